// The project of the window: saved, opened again, asked for, found where its data moved, kept against a
// crash.
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLockFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>
#include <filesystem>
#include <fstream>

#include "app/workbench/base/running_work.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/project/autosave.hpp"
#include "app/workbench/project/history_desk.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/project/relocate_dialog.hpp"
#include "app/workbench/shell/change_history.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/base/atomic_file.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/opening/session_material.hpp"
#include "core/session/file/library_reference.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/support/broken_world.hpp"
#include "tests/support/humanoid_rig.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app::project_actions_test {
namespace {

class ProjectActions : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1400, 900}); }
  void SetUp() override {
    DemoWindow::SetUp();
    desk().setAsks(false);
    reopen([] { window().openDemo(); });
    desk().setAsks(true);
    desk().ask = [this] { return ++asked, answer; };
    window().findChild<HistoryDesk*>()->ask = [](double) { return HistoryDesk::Answer::Discard; };
  }
  void TearDown() override {
    desk().setAsks(false);
    window().document().noteSaved({});  // labels of takes that were saved stay in the window's next sessions
  }

  static ProjectDesk& desk() { return *window().findChild<ProjectDesk*>("project desk"); }
  static TakeDesk& takes() { return *window().findChild<TakeDesk*>(); }
  static AnnotationDesk& annotations() { return *window().findChild<AnnotationDesk*>(); }
  static QString file(const QString& name) { return home().filePath(name); }
  static void reopen(const std::function<void()>& open) {
    bool begun = false;
    const auto link =
        QObject::connect(&window().document(), &Document::began, &window(), [&begun] { begun = true; });
    open();
    ASSERT_TRUE(until([&begun] { return begun; })) << window().messages().text().toStdString();
    QObject::disconnect(link);
    until([] { return window().session()->latest().newest() || window().session()->material().recorded; });
    turn();
  }
  static void save_as(const QString& name) {
    desk().saveAs(file(name));
    ASSERT_TRUE(until([] { return !desk().isSaving(); }));
  }
  static void save() {
    desk().save();
    ASSERT_TRUE(until([] { return !desk().isSaving(); }));
  }
  /// As a person draws an interval: a step of undo.
  static void annotate(double from_s, double to_s, const char* value) {
    Annotations next = window().document().live().annotations().of("");
    int tier = next.tiers().empty() ? 0 : next.tiers().front().id;
    if (tier == 0) tier = *next.add_tier("notes", TierKind::Note, {});
    for (const AnnotationTier& each : next.tiers())
      if (each.kind == TierKind::Note) tier = each.id;
    ASSERT_TRUE(next.draw(tier, from_s, to_s, value, Conflict::Replace, {0, 1e6}));
    window().document().changeAnnotations(next, "draw");
  }
  static std::size_t annotated() {
    std::size_t count = 0;
    for (const AnnotationTier& tier : window().document().live().annotations().of("").tiers())
      count += tier.annotations.size();
    return count;
  }
  static const Material& material() { return window().session()->material(); }
  /// Somebody else leads in the first take, and it begins with a move that no take had; the library has it.
  static void relabel_the_first_take() {
    const std::string take = material().library->takes().front().name;
    annotations().showSubject(take);
    Annotations next = window().document().annotations();
    const auto range = annotations().range();
    const int moves = next.first_of(TierKind::Move)->id, roles = next.first_of(TierKind::Role)->id;
    auto words = next.tier(moves)->vocabulary;
    words.insert(words.begin(), {"a new move"});
    ASSERT_TRUE(next.set_vocabulary(moves, words));
    ASSERT_TRUE(next.draw(moves, 0, 0.5, "a new move", Conflict::Replace, range));
    ASSERT_TRUE(next.draw(roles, 0, 1, "b", Conflict::Replace, range));
    window().document().changeAnnotations(next, "label");
    ASSERT_TRUE(until([] {
      const auto& labels = material().library->takes().front().labels;
      return !labels.empty() && labels.front().label == "a new move";
    }));
  }
  static Annotations said_of(const std::string& subject) {
    annotations().showSubject(subject);
    return window().document().annotations();
  }
  static bool is_modified() {
    desk().refresh();
    return window().isWindowModified();
  }

  int asked = 0;
  ProjectDesk::Answer answer = ProjectDesk::Answer::Cancel;
};

class UnsavedWork : public ProjectActions {};

TEST_F(ProjectActions, AFreshSessionIsUntitledAndNotModified) {
  EXPECT_TRUE(window().windowTitle().startsWith("Untitled[*]")) << window().windowTitle().toStdString();
  EXPECT_FALSE(is_modified());
  EXPECT_EQ(desk().file(), "");
}

TEST_F(ProjectActions, WhatASessionHadIsThereAgainWhenItIsOpened) {
  annotate(0.5, 1.5, "a long look");
  Markers markers = window().timeline().markers();
  markers.add(0.7, "clap");
  window().document().put(SubjectMarkers{"", markers});
  window().document().changeSetting("alpha", "0.77");
  EXPECT_TRUE(is_modified());
  save_as("one.abrazo");
  EXPECT_FALSE(is_modified());
  EXPECT_TRUE(window().windowTitle().startsWith("one[*]")) << window().windowTitle().toStdString();
  EXPECT_EQ(remembered().recent().value(0), file("one.abrazo"));
  window().document().changeSetting("alpha", "0.2");
  desk().setAsks(false);
  reopen([] { window().openDemo(); });
  EXPECT_EQ(annotated(), 0U);
  desk().setAsks(true);
  reopen([] { window().openFiles({file("one.abrazo")}); });
  EXPECT_EQ(annotated(), 1U);
  ASSERT_EQ(window().timeline().markers().all().size(), 1U);
  EXPECT_EQ(window().timeline().markers().all()[0].name, "clap");
  EXPECT_NEAR(window().document().settings().alpha, 0.77, 1e-12);
  EXPECT_EQ(desk().file(), file("one.abrazo"));
  EXPECT_FALSE(is_modified());
}

TEST_F(UnsavedWork, AChangeIsSeenAtOnceAndItsUndoToo) {
  window().document().changeSetting("alpha", "0.31");  // settings stay from session to session
  EXPECT_TRUE(window().isWindowModified()) << "without anyone looking";
  window().undoStack().undo();
  EXPECT_FALSE(window().isWindowModified());
}

TEST_F(ProjectActions, AFileThatCannotBeOpenedAsksNothing) {
  window().document().changeSetting("alpha", "0.32");
  QSignalSpy failed(&window(), &MainWindow::failed);
  window().openFiles({file("not there.bvh")});
  ASSERT_TRUE(until([&] { return failed.count() == 1; }));
  EXPECT_EQ(asked, 0) << "nothing would have been lost";
  EXPECT_TRUE(window().isWindowModified());
}

TEST_F(ProjectActions, MarkersOfATakeAreKeptWithIt) {
  const std::string take = window().session()->material().library->takes().front().name;
  annotations().showSubject(take);
  Markers markers;
  markers.add(0.4, "heel: \"down\"");
  markers.add(0.9);
  window().document().put(SubjectMarkers{take, markers});
  EXPECT_TRUE(is_modified());
  save_as("marked take.abrazo");
  EXPECT_FALSE(is_modified());
  annotations().showSubject("");
  EXPECT_FALSE(is_modified()) << "what is shown is no work";
  desk().setAsks(false);
  reopen([] { window().openDemo(); });
  EXPECT_TRUE(window().document().project().take_markers.empty());
  reopen([] { window().openFiles({file("marked take.abrazo")}); });
  desk().setAsks(true);
  EXPECT_TRUE(until([&] { return window().document().subject() == take; })) << "the one that was shown";
  EXPECT_EQ(window().timeline().markers().all(), markers.all());
  EXPECT_FALSE(is_modified());
  annotations().showSubject("");
  EXPECT_TRUE(window().timeline().markers().empty()) << "they are not the session's";
}

TEST_F(ProjectActions, AnOpenedSessionIsShownAsItWasLeft) {
  ASSERT_TRUE(until([] { return window().ticker().playback().last_s > 0.6; }));
  window().ticker().seek(0.3);
  auto left = window().scene().memory();
  left.ranges[static_cast<std::size_t>(left.scalar)] = {0.01, 0.08};
  window().scene().setMemory(left);
  save_as("left.abrazo");
  EXPECT_TRUE(window().scene().memory().ranges == left.ranges);
  desk().setAsks(false);
  reopen([] { window().openDemo(); });
  EXPECT_TRUE(window().scene().memory().ranges == widgets::SceneMemory().ranges) << "of that session alone";
  EXPECT_EQ(window().ticker().playback().state, Playback::State::Following);
  reopen([] { window().openFiles({file("left.abrazo")}); });
  desk().setAsks(true);
  EXPECT_TRUE(window().scene().memory().ranges == left.ranges);
  EXPECT_TRUE(until([] { return window().ticker().playback().state == Playback::State::Parked; }));
  EXPECT_NEAR(window().ticker().playback().cursor_s, 0.3, 1e-9);
  EXPECT_FALSE(is_modified());
  window().scene().setMemory({left.visibility, left.scalar, left.options, {}});
}

/// Without a word, the next session was without its dancers.
TEST_F(ProjectActions, HiddenBodiesAndCharactersAreOfTheirSession) {
  widgets::SceneView& scene = window().scene();
  const std::string character = file("ana.vrm").toStdString();
  ASSERT_TRUE(write_whole_file(character, test::skinned_rig(test::Naming::Vrm1)));
  action("Show or hide result")->trigger();
  widgets::SceneOptions options = scene.options();
  options.character_files[1] = character;
  options.map = widgets::ColourMap::Cividis;
  scene.setOptions(options);
  ASSERT_TRUE(until([&] { return scene.characters()[1] != nullptr; }));
  window().selection().select(widgets::Selection::joint(3));
  action("Hide the selection")->trigger();
  action("Cut")->trigger();
  ASSERT_TRUE(scene.options().cuts);
  const widgets::PartVisibility left = scene.visibility();
  save_as("hidden.abrazo");
  desk().setAsks(false);
  reopen([] { window().openDemo(); });
  EXPECT_EQ(scene.visibility(), widgets::default_visibility);
  EXPECT_EQ(scene.characters()[1], nullptr);
  EXPECT_EQ(scene.options().character_files[1], "");
  EXPECT_TRUE(scene.hidden().empty());
  EXPECT_FALSE(scene.options().cuts);
  EXPECT_EQ(scene.options().map, widgets::ColourMap::Cividis) << "how it is drawn is the window's";
  reopen([] { window().openFiles({file("hidden.abrazo")}); });
  desk().setAsks(true);
  EXPECT_EQ(scene.visibility(), left) << "as the file says";
  EXPECT_TRUE(until([&] { return scene.characters()[1] != nullptr; }));
  EXPECT_FALSE(is_modified());
  scene.setOptions({});
}

TEST_F(ProjectActions, WhoDecidesAboutTheRoleIsWorkThatIsKept) {
  EXPECT_FALSE(is_modified());
  action("Role from the library's annotation")->trigger();
  EXPECT_TRUE(is_modified());
  save_as("role.abrazo");
  action("Role by hand")->trigger();
  desk().setAsks(false);
  reopen([] { window().openFiles({file("role.abrazo")}); });
  desk().setAsks(true);
  EXPECT_EQ(window().document().decisions().role_control, RoleControl::Library);
  EXPECT_TRUE(until([] { return action("Role from the library's annotation")->isChecked(); }));
  EXPECT_FALSE(is_modified());
  action("Role by hand")->trigger();
}

TEST_F(ProjectActions, ARecordingMadeAfterATakeWasAnnotatedIsOpenedAgain) {
  const auto library = window().session()->material().library;
  const LibraryTake& take = library->takes().front();
  annotations().showSubject(take.name);
  Annotations next = window().document().annotations();
  const int moves = next.first_of(TierKind::Move)->id;
  ASSERT_TRUE(next.draw(moves, 0.2, 0.6, "something new", Conflict::Replace, annotations().range()));
  window().document().changeAnnotations(next, "draw");
  ASSERT_TRUE(until([&] { return window().session()->material().library != library; }));
  annotations().showSubject("");
  const auto annotated = window().session()->material().library;
  takes().toggle();
  ASSERT_TRUE(until([] { return takes().isRecording() && takes().takes().all().back().frames > 20; }));
  takes().toggle();
  save();
  const auto again = material_of(*open_session(takes().file().toStdString()), {}, {});  // with nothing open
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_TRUE(again->warnings.empty()) << again->warnings[0];
  EXPECT_EQ(library_fingerprint(*again->library), library_fingerprint(*annotated));
  while (window().undoStack().canUndo()) window().undoStack().undo();
}

TEST_F(UnsavedWork, UndoGoesOnAcrossASave) {
  annotate(0.5, 1, "first");
  save_as("undo.abrazo");
  EXPECT_TRUE(window().undoStack().isClean());
  annotate(2, 3, "second");
  EXPECT_TRUE(is_modified());
  window().undoStack().undo();
  EXPECT_EQ(annotated(), 1U);
  EXPECT_FALSE(is_modified());  // as it was saved
  EXPECT_TRUE(window().undoStack().isClean());
  window().undoStack().undo();
  EXPECT_EQ(annotated(), 0U);
  EXPECT_TRUE(is_modified());
  save();
  const auto saved = load_project(file("undo.abrazo").toStdString());
  ASSERT_TRUE(saved);
  const auto session = saved->annotations.find("");  // with nothing said it need not be there
  if (session == saved->annotations.end()) return;
  for (const AnnotationTier& tier : session->second.tiers()) EXPECT_TRUE(tier.annotations.empty());
}

TEST_F(UnsavedWork, UndoEndsWithItsSession) {
  annotate(0.5, 1, "of the session before");
  window().document().changeSetting("alpha", "0.33");
  ASSERT_TRUE(window().undoStack().canUndo());
  auto* changes = window().findChild<ChangeHistory*>();
  ASSERT_TRUE(changes);
  EXPECT_EQ(changes->count(), 3);
  save_as("before.abrazo");
  reopen([] { window().openDemo(); });
  EXPECT_FALSE(window().undoStack().canUndo());
  ASSERT_TRUE(action("Undo")) << "without the words of the session before";
  EXPECT_FALSE(action("Undo")->isEnabled());
  ASSERT_EQ(changes->count(), 1);
  EXPECT_EQ(changes->item(0)->text(), "As it was opened");
  reopen([] { window().openFiles({file("before.abrazo")}); });
  EXPECT_FALSE(window().undoStack().canUndo());
  EXPECT_EQ(annotated(), 1U);
}

TEST_F(ProjectActions, TakesAreRecordedIntoTheFileOfTheProjectAndItIsSavedMeanwhile) {
  annotate(0.5, 1, "before");
  save_as("both.abrazo");
  takes().toggle();
  ASSERT_TRUE(until([] { return takes().isRecording() && takes().takes().all().back().frames > 20; }));
  EXPECT_EQ(takes().file(), file("both.abrazo"));
  annotate(2, 3, "while it is recorded");
  save();
  EXPECT_TRUE(window().messages().openErrors().isEmpty()) << window().messages().text().toStdString();
  EXPECT_FALSE(is_modified());
  EXPECT_EQ(load_project(file("both.abrazo").toStdString())->annotations.at(""),
            window().document().live().annotations().of(""));
  takes().toggle();
  ASSERT_TRUE(until([] { return !takes().finishing(); }));
  const auto session = SessionFile::open(file("both.abrazo").toStdString());
  ASSERT_TRUE(session);
  EXPECT_GT((*session)->contents().frames, 20U);
  EXPECT_EQ((*session)->contents().takes.size(), 1U);
  reopen([] { window().openFiles({file("both.abrazo")}); });
  EXPECT_TRUE(window().session()->material().recorded);
  EXPECT_EQ(annotated(), 2U);
  EXPECT_EQ(takes().takes().all().size(), 1U);
}

/// The later save wiped the labels of the other.
TEST_F(ProjectActions, ASessionThatIsOpenInAnotherWindowIsReadOnly) {
  annotate(0.5, 1, "of the other window");
  save_as("shared.abrazo");
  const Project saved = *load_project(file("shared.abrazo").toStdString());
  reopen([] { window().openDemo(); });
  SessionHold other;
  ASSERT_TRUE(other.take(file("shared.abrazo")));
  reopen([] { window().openFiles({file("shared.abrazo")}); });
  EXPECT_TRUE(window().messages().text().contains("read-only here"))
      << window().messages().text().toStdString();
  EXPECT_TRUE(window().windowTitle().startsWith("shared[*] (read-only)"))
      << window().windowTitle().toStdString();
  annotate(2, 3, "of this one");
  save_as("shared.abrazo");
  EXPECT_TRUE(window().messages().text().contains("choose another name"));
  takes().toggle();
  EXPECT_FALSE(takes().isRecording()) << "nor is a take recorded into it";
  EXPECT_EQ(*load_project(file("shared.abrazo").toStdString()), saved);
  save_as("mine.abrazo");
  EXPECT_EQ(desk().file(), file("mine.abrazo"));
  EXPECT_FALSE(window().windowTitle().contains("read-only")) << window().windowTitle().toStdString();
  EXPECT_FALSE(is_modified());
  SessionHold third;
  EXPECT_FALSE(third.take(file("mine.abrazo"))) << "it is this window's now";
}

TEST_F(ProjectActions, WhatAnotherProgramSavedIsToldBeforeItIsSavedOver) {
  save_as("changed.abrazo");
  auto database = SessionDatabase::open(file("changed.abrazo").toStdString(), SessionDatabase::Access::Write);
  ASSERT_TRUE(database &&
              database->execute("UPDATE project SET value = '2999-01-01T00:00:00Z' WHERE key = 'saved_at'") &&
              database->close());
  annotate(2, 3, "first change");
  EXPECT_TRUE(window().messages().text().contains("was saved by another window at 2999"))
      << window().messages().text().toStdString();
}

TEST_F(UnsavedWork, NothingIsLostWithoutBeingAsked) {
  annotate(0.5, 1, "precious");
  window().close();
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(window().isVisible());
  window().openDemo();
  EXPECT_EQ(asked, 2);
  turn();
  EXPECT_EQ(annotated(), 1U);
  answer = ProjectDesk::Answer::Discard;
  reopen([] { window().openDemo(); });
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(annotated(), 0U);
  reopen([] { window().openDemo(); });
  EXPECT_EQ(asked, 3);  // there was nothing to lose
}

/// They were there again in the next session, and the keys of the words were others.
TEST_F(UnsavedWork, DiscardedLabelsOfATakeAreGoneWhileItsLibraryStaysOpen) {
  const auto library = material().library;
  const std::string first = library->takes()[0].name, second = library->takes()[1].name;
  const Annotations of_session = said_of(""), of_first = said_of(first), of_second = said_of(second);
  relabel_the_first_take();
  const QString motion = file("walk.bvh");
  std::ofstream(motion.toStdString()) << *write_bvh(std::vector<Clip>{clip_of_take(*library, 1)});
  answer = ProjectDesk::Answer::Discard;
  reopen([&motion] { window().openFiles({motion}); });
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(material().reading.file, motion.toStdString());
  EXPECT_EQ(material().library, library) << "as its file, or what generates it, has it";
  EXPECT_EQ(said_of(""), of_session);
  EXPECT_EQ(said_of(first), of_first);
  EXPECT_EQ(said_of(second), of_second);
  EXPECT_FALSE(is_modified());
  relabel_the_first_take();
  reopen([] { window().openDemo(); });  // which makes the library again
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(said_of(first), of_first);
  EXPECT_EQ(material().library->takes()[0].labels, library->takes()[0].labels);
}

TEST_F(UnsavedWork, SavedLabelsOfATakeAreThereInTheNextSessionOnItsLibrary) {
  const auto library = material().library;
  const std::string first = library->takes()[0].name;
  relabel_the_first_take();
  const Annotations saved = said_of(first);
  save_as("labelled.abrazo");
  Annotations next = saved;
  ASSERT_TRUE(next.remove(next.first_of(TierKind::Move)->annotations.front().id));
  window().document().changeAnnotations(next, "delete");
  answer = ProjectDesk::Answer::Discard;
  reopen([] { window().takes().setSelectedTake(1), window().takes().dance(); });
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(said_of(first), saved) << "what was changed after the save is gone";
  EXPECT_TRUE(until([] { return material().library->takes().front().labels.front().label == "a new move"; }));
  EXPECT_FALSE(is_modified());
}

/// Those of subjects that nobody had labelled were given anew, with the new move among them.
TEST_F(ProjectActions, TheKeysOfWordsAreTheSameWhenASessionIsOpenedAgain) {
  const auto words_of = [](const std::string& subject) {
    return said_of(subject).first_of(TierKind::Move)->vocabulary;
  };
  const std::string second = material().library->takes()[1].name;
  const auto of_session = words_of(""), of_second = words_of(second);
  relabel_the_first_take();
  const auto of_first = words_of(material().library->takes()[0].name);
  save_as("keys.abrazo");
  desk().setAsks(false);
  reopen([] { window().openDemo(); });
  reopen([] { window().openFiles({file("keys.abrazo")}); });
  desk().setAsks(true);
  EXPECT_EQ(words_of(material().library->takes()[0].name), of_first);
  for (const auto& [subject, before] : {std::pair(std::string(), of_session), {second, of_second}}) {
    auto expected = before;
    expected.push_back({"a new move"});
    EXPECT_EQ(words_of(subject), expected) << subject;
  }
}

TEST_F(UnsavedWork, SaveIsAnAnswerThatSavesBeforeItGoesOn) {
  save_as("asked.abrazo");
  annotate(0.5, 1, "late");
  answer = ProjectDesk::Answer::Save;
  reopen([] { window().openDemo(); });
  EXPECT_EQ(asked, 1);
  std::size_t kept = 0;
  for (const AnnotationTier& tier :
       load_project(file("asked.abrazo").toStdString())->annotations.at("").tiers())
    kept += tier.annotations.size();
  EXPECT_EQ(kept, 1U);
}

TEST_F(UnsavedWork, OnAFullDiskTheOldFileStaysWholeAndTheRestIsSavedOnceThereIsRoom) {
  const auto saved_annotations = [] {
    std::size_t count = 0;
    const auto project = load_project(file("whole.abrazo").toStdString());
    if (!project) return count;
    for (const AnnotationTier& tier : project->annotations.at("").tiers()) count += tier.annotations.size();
    return count;
  };
  annotate(0.5, 1, "first");
  save_as("whole.abrazo");
  ASSERT_EQ(saved_annotations(), 1U);
  annotate(2, 3, "second");
  {
    const test::LimitedFiles full(4096);
    save();
  }
  const QString told = window().messages().openErrors().join("\n");
  EXPECT_TRUE(told.contains("whole.abrazo") && told.contains("full")) << told.toStdString();
  EXPECT_TRUE(is_modified());
  EXPECT_EQ(saved_annotations(), 1U);
  save();
  EXPECT_FALSE(window().messages().openErrors().join("\n").contains("whole.abrazo")) << "it was saved since";
  EXPECT_FALSE(is_modified());
  EXPECT_EQ(saved_annotations(), 2U);
}

TEST_F(UnsavedWork, WhatIsNotSavedIsKeptAndComesBackAfterACrash) {
  const QString folder = remembered().folder() + "/autosave";
  annotate(0.5, 1.5, "nearly lost");
  const auto kept = [&folder] { return QDir(folder).entryList({"*.abrazo"}, QDir::Files); };
  ASSERT_TRUE(until(
      [&] { return kept().size() == 1 && !words_of_autosave(folder + "/" + kept().front()).isEmpty(); }));
  EXPECT_TRUE(Autosave::leftBehind(folder).isEmpty());  // it belongs to this window
  // What a killed program leaves: its file, and a lock that nobody holds.
  const QString left = folder + "/crashed.abrazo";
  ASSERT_TRUE(QFile::copy(folder + "/" + kept().front(), left));
  EXPECT_EQ(Autosave::leftBehind(folder), QStringList{left});
  EXPECT_TRUE(words_of_autosave(left).contains("an untitled session"))
      << words_of_autosave(left).toStdString();
  EXPECT_TRUE(words_of_autosave(left).contains("1 annotation, 0 markers"));
  answer = ProjectDesk::Answer::Discard;
  reopen([] { window().openDemo(); });
  EXPECT_TRUE(until([&] { return kept() == QStringList{"crashed.abrazo"}; }));  // its own is gone
  reopen([&left] { window().openFiles({left}); });
  EXPECT_EQ(annotated(), 1U);
  EXPECT_EQ(desk().file(), "");
  EXPECT_TRUE(is_modified());
  // It goes when the same is kept for this window.
  EXPECT_TRUE(until([&] { return !QFile::exists(left) && kept().size() == 1; }));
}

TEST_F(ProjectActions, AFileOfANewerVersionIsRefused) {
  const QString newer = file("newer.abrazo");
  save_as("now.abrazo");
  ASSERT_TRUE(QFile::copy(file("now.abrazo"), newer));
  {
    QFile patch(newer);
    ASSERT_TRUE(patch.open(QIODevice::ReadWrite));
    patch.seek(60);  // user_version, in the head of every SQLite file
    patch.write(QByteArray("\0\0\0\x09", 4));
  }
  window().openFiles({newer});
  EXPECT_TRUE(until([] { return window().messages().text().contains("open it with a newer Abrazo"); }))
      << window().messages().text().toStdString();
}

/// A project whose library and video were moved away together.
class Relocation : public ProjectActions {
 protected:
  void SetUp() override {
    ProjectActions::SetUp();
    QFile::remove(file("moved.abrazo"));
    QDir(home().path()).mkpath("old/libs");
    QDir(home().path()).mkpath("old/video");
    ASSERT_TRUE(
        write_library(*window().session()->material().library, file("old/libs/lib.h5").toStdString()));
    std::ofstream(file("old/video/v.mp4").toStdString()) << "a film";
    Project project;
    for (const auto& [name, use] : {std::pair{"old/libs/lib.h5", DataReference::Use::Library},
                                    {"old/video/v.mp4", DataReference::Use::Video}})
      project.data.push_back(
          *reference_to(file(name).toStdString(), use, file("moved.abrazo").toStdString()));
    project.input = window().session()->material().library->takes().front().name;
    ASSERT_TRUE(save_project(file("moved.abrazo").toStdString(), project));
    QDir(file("new")).removeRecursively();
    ASSERT_TRUE(QDir(home().path()).rename("old", "new"));
  }
  static RelocateDialog* dialog() {
    for (auto* each : window().findChildren<RelocateDialog*>())
      if (each->isVisible()) return each;
    return nullptr;
  }
};

TEST_F(Relocation, OnePointedOutFindsTheOthersAndTheSessionOpens) {
  window().openFiles({file("moved.abrazo")});
  ASSERT_TRUE(until([] { return dialog() != nullptr; }));
  EXPECT_EQ(dialog()->leftMissing(), 2U);
  dialog()->pointOut(0, file("new/libs/lib.h5"));
  EXPECT_EQ(dialog()->leftMissing(), 0U);
  EXPECT_EQ(dialog()->places().at(1), file("new/video/v.mp4").toStdString());
  const auto* next = qobject_cast<QPushButton*>(dialog()->focusWidget());
  EXPECT_TRUE(next && next->text() == "Open") << "Return opens";
  reopen([] { dialog()->accept(); });
  EXPECT_EQ(window().session()->material().library_file, file("new/libs/lib.h5").toStdString());
  EXPECT_EQ(window().session()->material().input.name,
            window().session()->material().library->takes().front().name);
  EXPECT_TRUE(is_modified()) << "the file does not know the new places yet";
  save();
  EXPECT_FALSE(is_modified());
  EXPECT_EQ(load_project(file("moved.abrazo").toStdString())->data[0].absolute_path,
            file("new/libs/lib.h5").toStdString());
}

TEST_F(Relocation, WithoutThemItSaysWhatWillNotWorkAndOpens) {
  window().openFiles({file("moved.abrazo")});
  ASSERT_TRUE(until([] { return dialog() != nullptr; }));
  QString said;
  for (const QLabel* label : dialog()->findChildren<QLabel*>()) said += label->text() + "\n";
  EXPECT_TRUE(said.contains("Without lib.h5: the generated dance answers in its place"))
      << said.toStdString();
  reopen([] { dialog()->accept(); });
  EXPECT_TRUE(window().session()->material().library_file.empty());
  EXPECT_TRUE(window().messages().text().contains("lib.h5 is not there"))
      << window().messages().text().toStdString();
  save();  // what it was opened without stays among its data
  const auto saved = load_project(file("moved.abrazo").toStdString());
  ASSERT_TRUE(saved);
  ASSERT_FALSE(saved->data.empty());
  EXPECT_EQ(saved->data[0].absolute_path, file("old/libs/lib.h5").toStdString());
  EXPECT_EQ(saved->data[0].hash.size(), 16U);
}

TEST_F(Relocation, CancelledLeavesTheSessionAsItWas) {
  QSignalSpy failed(&window(), &MainWindow::failed);
  const auto* session = window().session();
  window().openFiles({file("moved.abrazo")});
  ASSERT_TRUE(until([] { return dialog() != nullptr; }));
  dialog()->reject();
  ASSERT_TRUE(until([] { return !RunningWork::any(); }));
  turn();
  EXPECT_EQ(window().session(), session);
  EXPECT_TRUE(failed.isEmpty());
  EXPECT_FALSE(window().messages().isVisible() && window().messages().text().contains("Waiting"));
}

TEST_F(Relocation, EndsWithTheOpeningThatAskedForIt) {
  window().openFiles({file("moved.abrazo")});
  ASSERT_TRUE(until([] { return dialog() != nullptr; }));
  reopen([] { window().openDemo(); });
  EXPECT_TRUE(until([] { return dialog() == nullptr; }));
  EXPECT_TRUE(window().session()->material().is_generated);
}

}  // namespace
}  // namespace abrazo::app::project_actions_test
