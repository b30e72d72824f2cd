// A library that is built of motion files in the window and not saved: the session that was worked on with it
// is whole when it is opened again, and says what is missing where it cannot be.
#include <QDir>
#include <QPushButton>
#include <QTemporaryDir>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/library/library_build.hpp"
#include "app/workbench/library/library_desk.hpp"
#include "app/workbench/project/history_desk.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/project/relocate_dialog.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/session/file/library_reference.hpp"
#include "tests/support/libraries.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/annotation/annotation_panel.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/section_header.hpp"

namespace abrazo::app::built_session_test {
namespace {

class BuiltSession : public DemoWindow {
 protected:
  static void SetUpTestSuite() { start(); }
  void SetUp() override {
    DemoWindow::SetUp();
    QDir(folder.path()).mkpath("captures");
    prepare();
    build();
  }
  void TearDown() override { desk().setAsks(false); }

  static void start() { showWindow({1400, 900}); }
  /// Without saving; the next window is that of another start.
  void restart() {
    desk().setAsks(false);
    TearDownTestSuite();
    start();
    prepare();
  }
  void prepare() {
    desk().setAsks(true);
    desk().ask = [] { return ProjectDesk::Answer::Discard; };
    desk().askLibrary = [this] { return ++asked, answer; };
    window().findChild<HistoryDesk*>()->ask = [](double) { return HistoryDesk::Answer::Discard; };
  }

  static ProjectDesk& desk() { return *window().findChild<ProjectDesk*>("project desk"); }
  static AnnotationDesk& annotations() { return *window().findChild<AnnotationDesk*>(); }
  static const Material& material() { return window().session()->material(); }
  QString file(const QString& name) const { return folder.filePath(name); }
  static std::string said() { return window().messages().text().toStdString(); }

  QStringList written_motions() const {
    QStringList files;
    for (const auto& [take, seed] : {std::pair("one", 1U), {"two", 2U}}) {
      const PairedTake pair = test::swinging_take(take, 60, seed);
      for (const auto& [ending, clip] : {std::pair("_leader.bvh", &pair.a), {"_follower.bvh", &pair.b}}) {
        files << file(QString("captures/") + take + ending);
        std::ofstream(files.back().toStdString()) << *write_bvh(std::vector<Clip>{*clip});
      }
    }
    return files;
  }
  /// As by Library > Build library, without a name for the file.
  void build() {
    auto& library = *window().findChild<LibraryDesk*>();
    library.offer(written_motions());
    ASSERT_TRUE(until([&library] { return !library.building()->isBusy(); }));
    ASSERT_TRUE(begins(&press_build)) << said();
  }
  static void press_build() {
    for (auto* button : window().findChild<LibraryDesk*>()->building()->dialog().findChildren<QPushButton*>())
      if (button->text() == "Build") button->click();
  }
  /// @return whether a session began of it, or a question came up before one does
  static bool begins(const std::function<void()>& doing) {
    bool begun = false;
    const auto link =
        QObject::connect(&window().document(), &Document::began, &window(), [&begun] { begun = true; });
    doing();
    const bool done = until([&begun] { return begun || dialog(); });
    QObject::disconnect(link);
    turn();
    return done;
  }
  /// As a person draws a move of a take.
  static void annotate(const std::string& take) {
    annotations().showSubject(take);
    Annotations next = window().document().annotations();
    int note = 0;
    for (const AnnotationTier& tier : next.tiers())
      if (tier.kind == TierKind::Note) note = tier.id;
    ASSERT_TRUE(next.draw(note, 0.2, 0.6, "mind the elbow", Conflict::Replace, annotations().range()));
    window().document().changeAnnotations(next, "draw");
  }
  static std::size_t notes_of(const std::string& take) {
    std::size_t count = 0;
    for (const AnnotationTier& tier : window().document().live().annotations().of(take).tiers())
      if (tier.kind == TierKind::Note) count += tier.annotations.size();
    return count;
  }
  void save() const {
    desk().saveAs(file("s.abrazo"));
    ASSERT_TRUE(until([] { return !desk().isSaving(); }));
  }
  void open() const {
    ASSERT_TRUE(begins([this] { window().openFiles({file("s.abrazo")}); })) << said();
  }
  static RelocateDialog* dialog() {
    for (auto* each : window().findChildren<RelocateDialog*>())
      if (each->isVisible()) return each;
    return nullptr;
  }
  static void accept() {
    ASSERT_TRUE(begins([] { dialog()->accept(); })) << said();
  }
  static std::string warnings() {
    std::string all;
    for (const std::string& warning : material().warnings) all += warning + "\n";
    return all;
  }

  QTemporaryDir folder;
  int asked = 0;
  ProjectDesk::LibraryAnswer answer = ProjectDesk::LibraryAnswer::SaveWithout;
};

TEST_F(BuiltSession, IsWholeAgainAfterAQuitWithoutTheLibraryAsAFile) {
  const std::string fingerprint = library_fingerprint(*material().library);
  annotate("one");
  save();
  EXPECT_EQ(asked, 1);
  press(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(until([] { return !desk().isSaving(); }));
  EXPECT_EQ(asked, 1) << "it was answered";
  EXPECT_EQ(load_project(file("s.abrazo").toStdString())->data.size(), 4U) << "the motion files";
  restart();
  open();
  ASSERT_TRUE(window().session()) << said();
  EXPECT_EQ(library_fingerprint(*material().library), fingerprint);
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(notes_of("one"), 1U);
  annotations().showSubject("one");
  EXPECT_EQ(window().document().subject(), "one") << "and can be reached";
}

TEST_F(BuiltSession, MayBeSavedWithItsLibraryBesideIt) {
  answer = ProjectDesk::LibraryAnswer::Write;
  const std::string name = material().library->name();
  save();
  EXPECT_EQ(material().library_file, file(QString::fromStdString(name) + ".h5").toStdString());
  EXPECT_EQ(read_library(material().library_file)->pair_count(), material().library->pair_count());
  EXPECT_FALSE(window().isWindowModified());
  annotate("two");
  desk().save();
  ASSERT_TRUE(until([] { return !desk().isSaving(); }));
  EXPECT_EQ(asked, 1) << "it is a file now";
  QDir(file("captures")).removeRecursively();  // which it does not need any more
  restart();
  open();
  ASSERT_TRUE(window().session()) << said();
  EXPECT_TRUE(material().library_file.ends_with(".h5"));
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(notes_of("two"), 1U);
}

TEST_F(BuiltSession, IsNotSavedWhenThePersonChangesTheirMind) {
  answer = ProjectDesk::LibraryAnswer::Cancel;
  save();
  EXPECT_EQ(asked, 1);
  EXPECT_FALSE(QFile::exists(file("s.abrazo")));
}

TEST_F(BuiltSession, WithoutItsMotionFilesAsksForThemAndListsWhatWasSaidOfTheirTakes) {
  annotate("one");
  save();
  restart();
  QDir(file("captures")).removeRecursively();
  open();
  ASSERT_TRUE(dialog()) << said();
  EXPECT_EQ(dialog()->leftMissing(), 4U);
  accept();
  EXPECT_NE(said().find("one_leader.bvh"), std::string::npos) << said();
  EXPECT_NE(warnings().find("of one are kept, and not shown"), std::string::npos) << warnings();
  EXPECT_TRUE(annotations().panel().subjects().contains("one (not in the library)"));
  annotations().showSubject("one");
  EXPECT_EQ(window().document().subject(), "");
  EXPECT_NE(said().find("open the session together with its library"), std::string::npos) << said();
  // What cannot be shown is saved with the rest.
  desk().save();
  ASSERT_TRUE(until([] { return !desk().isSaving(); }));
  const auto kept = load_project(file("s.abrazo").toStdString());
  EXPECT_EQ(kept->data.size(), 4U);
  EXPECT_FALSE(kept->manifest.empty());
  EXPECT_TRUE(kept->annotations.contains("one"));
}

TEST_F(BuiltSession, FindsItsMotionFilesWhereOneOfThemIsPointedOut) {
  annotate("one");
  save();
  restart();
  std::filesystem::rename(file("captures").toStdString(), file("moved").toStdString());
  open();
  ASSERT_TRUE(dialog()) << said();
  const auto project = load_project(file("s.abrazo").toStdString());
  const QString first = QFileInfo(QString::fromStdString(project->data[0].absolute_path)).fileName();
  dialog()->pointOut(0, file("moved/" + first));
  EXPECT_EQ(dialog()->leftMissing(), 0U);
  accept();
  EXPECT_GE(material().library->find_take("one"), 0);
  EXPECT_EQ(notes_of("one"), 1U);
}

/// The generated dance answers meanwhile, and its frames are saved with the rest.
TEST_F(BuiltSession, SavedWhileItsLibraryWasMissingItIsAskedForAgainAndComesBack) {
  const std::string fingerprint = library_fingerprint(*material().library);
  ASSERT_TRUE(until([] { return ticker().shown() && ticker().shown()->index > 20; }));
  const double recorded_s = ticker().shown()->time_s;
  save();
  restart();
  std::filesystem::rename(file("captures").toStdString(), file("moved").toStdString());
  open();
  ASSERT_TRUE(dialog()) << said();
  accept();
  ASSERT_TRUE(material().stands_in);
  ASSERT_TRUE(until([] { return ticker().shown() && ticker().shown()->result.selected >= 0; }))
      << "the generated dance answers";
  ticker().seek(recorded_s);
  ASSERT_TRUE(until([&] { return ticker().shown()->time_s <= recorded_s; }));
  EXPECT_EQ(ticker().shown()->result.selected, -1) << "no pair of the library that stands in";
  EXPECT_TRUE(window().candidates().rows().empty());
  const auto* list = window().candidates().findChild<widgets::CandidateList*>();
  const QString why =
      "Danced with library “library”, which is not open. To see its candidates open the session again, "
      "and locate the files of the library.";
  EXPECT_TRUE(until([&] { return list->accessibleDescription() == why; }))
      << list->accessibleDescription().toStdString();
  EXPECT_EQ(window().candidates().reason(), "") << "and not that there was no candidate";
  ticker().follow();
  press(Qt::Key_M);
  press(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(until([] { return !desk().isSaving() && !desk().isModified(); }));
  restart();
  open();
  ASSERT_TRUE(dialog()) << "it is still missing; " << said();
  EXPECT_EQ(dialog()->leftMissing(), 4U);
  const auto project = load_project(file("s.abrazo").toStdString());
  const QString first = QFileInfo(QString::fromStdString(project->data[0].absolute_path)).fileName();
  dialog()->pointOut(0, file("moved/" + first));
  accept();
  EXPECT_FALSE(material().stands_in);
  EXPECT_EQ(library_fingerprint(*material().library), fingerprint);
  desk().save();
  ASSERT_TRUE(until([] { return !desk().isSaving() && !desk().isModified(); })) << said();
  restart();
  open();
  ASSERT_FALSE(dialog()) << "it knows where they are";
  EXPECT_EQ(library_fingerprint(*material().library), fingerprint);
}

/// Everything that was decided in the dialog was gone.
TEST_F(BuiltSession, WhoeverKeepsTheSessionAfterBuildingKeepsTheDialog) {
  const auto before = material().library;
  press(Qt::Key_M);
  ASSERT_TRUE(desk().isModified());
  desk().ask = [] { return ProjectDesk::Answer::Cancel; };
  auto& library = *window().findChild<LibraryDesk*>();
  library.offer(written_motions());
  ASSERT_TRUE(until([&library] { return !library.building()->isBusy(); }));
  const int rows = library.building()->dialog().model().rowCount();
  press_build();
  ASSERT_TRUE(until([&library] { return !library.building()->isBusy(); }));
  turn();
  ASSERT_TRUE(library.building());
  EXPECT_TRUE(library.building()->dialog().isVisible());
  EXPECT_EQ(library.building()->dialog().model().rowCount(), rows);
  EXPECT_EQ(material().library, before);
  prepare();
  ASSERT_TRUE(begins(&press_build)) << "with another answer";
  EXPECT_NE(material().library, before);
}

/// The heading was "LIBRARY · LIBRARY".
TEST_F(BuiltSession, ThePanelNamesTheLibraryUnlessThatIsItsOwnName) {
  const auto has_panel = [](const QString& heading) {
    const auto headers = window().findChildren<widgets::SectionHeader*>();
    return std::ranges::any_of(headers, [&](auto* each) { return each->title() == heading; });
  };
  ASSERT_EQ(material().library->name(), "library");
  EXPECT_TRUE(has_panel("Library"));
  EXPECT_FALSE(has_panel("Library · library"));
  const auto named = std::make_shared<const MotionLibrary>(*build_library(
      "salsa", {test::swinging_take("one", 60, 1), test::swinging_take("two", 60, 2)}, {}, {}));
  ASSERT_TRUE(begins([&named] {
    window().openMaterial(
        [named](const Progress&) -> Result<Material> { return built_material(named, {}, "", {}); });
  })) << said();
  EXPECT_TRUE(has_panel("Library · salsa"));
}

TEST_F(BuiltSession, ItsRecordingOpensWithItToo) {
  auto& takes = *window().findChild<TakeDesk*>();
  save();
  takes.toggle();
  ASSERT_TRUE(until([&] { return takes.isRecording() && takes.takes().all().back().frames > 20; }));
  takes.toggle();
  restart();
  open();
  ASSERT_TRUE(window().session()) << said();
  EXPECT_TRUE(material().recorded);
  EXPECT_GE(material().library->find_take("one"), 0) << said();
  EXPECT_EQ(warnings(), "");
}

}  // namespace
}  // namespace abrazo::app::built_session_test
