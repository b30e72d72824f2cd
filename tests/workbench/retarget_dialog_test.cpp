// Retargeting takes from the window: what is offered, what is written, and what is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

#include "app/workbench/library/retarget_desk.hpp"
#include "app/workbench/library/retarget_preview.hpp"
#include "app/workbench/library/retarget_preview_desk.hpp"
#include "core/base/atomic_file.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/store/takes_of_library.hpp"
#include "tests/support/humanoid_rig.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/value_slider.hpp"
#include "widgets/library/take_list.hpp"

namespace abrazo::app::retarget_dialog_test {
namespace {

using ::testing::HasSubstr;

/// A window on a library file of the generated dance.
class RetargetWindow : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showDemo({1280, 720}, 5);
    ASSERT_TRUE(write_library(*window().session()->material().library, library_file().toStdString()));
    window().openFiles({library_file()});
    ASSERT_TRUE(until([] {
      return window().session() &&
             window().session()->material().library_file == library_file().toStdString();
    }));
  }
  void SetUp() override {
    DemoWindow::SetUp();
    output = QDir(home().path()).filePath("out");
    QDir(output).removeRecursively();
    ASSERT_TRUE(QDir().mkpath(output));
    dialog().hide();
    desk().open();
    dialog().setFolder(output);
    dialog().chooseTakes({take(0)});
    body("Leader's body").setEditText("scale:0.9");
    body("Follower's body").setEditText("library");
    for (const char* weight : {"Contacts", "Smoothness"})
      emit named<widgets::ValueSlider>(weight).resetRequested(0);
    field("Character").clear();
    field("Name").setText("out");
    frame("From frame").setValue(0);
    frame("To frame").setValue(20);
    box("As").setCurrentIndex(0);
    dialog().findChild<QCheckBox*>()->setChecked(false);
    turn();
  }

  /// The command line is built beside the tests.
  static QString program() { return QCoreApplication::applicationDirPath() + "/abrazo"; }
  static QString library_file() { return home().filePath("demo.h5"); }
  static RetargetDesk& desk() { return *window().findChild<RetargetDesk*>(); }
  static RetargetDialog& dialog() { return desk().dialog(); }
  static QString take(std::size_t index) {
    return QString::fromStdString(window().session()->material().library->takes().at(index).name);
  }
  template <typename Widget>
  static Widget& named(const QString& name) {
    for (auto* each : dialog().findChildren<Widget*>())
      if (each->accessibleName() == name) return *each;
    throw std::invalid_argument(name.toStdString());
  }
  static QComboBox& box(const QString& name) { return named<QComboBox>(name); }
  static QComboBox& body(const QString& name) { return named<QComboBox>(name); }
  static QLineEdit& field(const QString& name) { return named<QLineEdit>(name); }
  static QSpinBox& frame(const QString& name) { return named<QSpinBox>(name); }
  static QPushButton& button(const QString& text) {
    for (auto* one : dialog().findChildren<QPushButton*>())
      if (one->text() == text) return *one;
    throw std::invalid_argument(text.toStdString());
  }
  static void chooseType(const QString& ending) {
    const int index = box("As").findData(ending);
    ASSERT_GE(index, 0) << ending.toStdString();
    box("As").setCurrentIndex(index);
  }
  static std::string state() { return dialog().findChild<QLabel*>("state")->text().toStdString(); }
  static std::string about() {
    std::string all;
    for (const auto* label : dialog().findChildren<QLabel*>("secondary"))
      all += label->text().toStdString() + "|";
    return all;
  }
  /// As a person does it, to the end.
  static void retarget() {
    ASSERT_TRUE(button("Retarget").isEnabled()) << about();
    button("Retarget").click();
    ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  }
  QStringList files() const { return QDir(output).entryList(QDir::Files | QDir::Hidden, QDir::Name); }
  std::string content(const QString& name) const {
    const auto read = read_whole_file(QDir(output).filePath(name).toStdString());
    return read ? *read : std::string();
  }
  /// What the command line writes for the same wish.
  void retargetOnTheCommandLine(const QStringList& more) const {
    QProcess abrazo;
    abrazo.setWorkingDirectory(output);
    abrazo.start(program(), QStringList{"retarget", "--library", library_file()} + more);
    ASSERT_TRUE(abrazo.waitForFinished(-1));
    ASSERT_EQ(abrazo.exitCode(), 0) << abrazo.readAllStandardError().toStdString();
  }

  QString output;
};

TEST_F(RetargetWindow, TheMenuOpensTheDialogWithTheTakeOfTheLibraryPanel) {
  dialog().hide();
  window().takes().setSelectedTake(0);
  QAction* open = action("Retarget take…");
  ASSERT_TRUE(open);
  EXPECT_EQ(open->objectName(), QString("library.retarget_take"));
  open->trigger();
  turn();
  EXPECT_TRUE(dialog().isVisible());
  const auto wish = dialog().wish();
  ASSERT_TRUE(wish);
  EXPECT_EQ(wish->takes, std::vector<std::string>{take(0).toStdString()});
}

TEST_F(RetargetWindow, WritesTheSameBytesAsTheCommandLine) {
  dialog().findChild<QCheckBox*>()->setChecked(true);
  for (const QString ending : {".bvh", ".glb", ".csv", ".npz"}) {
    chooseType(ending);
    retarget();
    retargetOnTheCommandLine({"--take", take(0), "--to", "20", "--active-body", "scale:0.9", "-o",
                              "line" + ending, "--trace", "line.jsonl", "--quiet"});
    EXPECT_FALSE(content("out" + ending).empty());
    EXPECT_TRUE(content("out" + ending) == content("line" + ending)) << ending.toStdString();
    EXPECT_TRUE(content("out.jsonl") == content("line.jsonl"));
  }
}

TEST_F(RetargetWindow, ItsWeightsAreThoseOfTheCommandLine) {
  emit named<widgets::ValueSlider>("Contacts").moved(0.7071, 1);
  emit named<widgets::ValueSlider>("Smoothness").moved(0.3536, 2);
  const auto wish = dialog().wish();
  ASSERT_TRUE(wish);
  EXPECT_EQ(wish->contacts, 2);
  EXPECT_EQ(wish->smoothness, 0.5);
  chooseType(".csv");
  retarget();
  const QStringList line{"--take",    take(0), "--to",     "20",     "--active-body",
                         "scale:0.9", "-o",    "line.csv", "--quiet"};
  retargetOnTheCommandLine(line);
  EXPECT_FALSE(content("out.csv") == content("line.csv")) << "they matter";
  retargetOnTheCommandLine(line + QStringList{"--contacts", "2", "--smoothness", "0.5"});
  EXPECT_TRUE(content("out.csv") == content("line.csv"));
}

TEST_F(RetargetWindow, ACharacterOfAnotherProgramPerformsBoth) {
  const QString rig = QDir(output).filePath("rig.vrm");
  ASSERT_TRUE(write_whole_file(rig.toStdString(), test::rig(test::Naming::Vrm1)));
  field("Character").setText(rig);
  EXPECT_EQ(box("As").findData(".bvh"), -1) << "a character is a GLB or VRM";
  chooseType(".vrm");
  field("Character").setText(output + "/gone.vrm");
  EXPECT_FALSE(button("Retarget").isEnabled());
  EXPECT_THAT(about(), HasSubstr("gone.vrm"));
  field("Character").setText(rig);
  retarget();
  EXPECT_EQ(files(), QStringList({"out_active.vrm", "out_passive.vrm", "rig.vrm"}));
  retargetOnTheCommandLine({"--take", take(0), "--to", "20", "--active-body", "scale:0.9", "--character", rig,
                            "-o", "line.vrm", "--quiet"});
  EXPECT_TRUE(content("out_passive.vrm") == content("line_passive.vrm"));
}

TEST_F(RetargetWindow, SeveralTakesHaveFilesOfTheirOwnAndTheirFiguresAreTold) {
  const QStringList both{take(0), take(1)};
  dialog().chooseTakes(both);
  chooseType(".csv");
  QStringList told;
  const auto listening = QObject::connect(&window().messages(), &widgets::MessageBar::told, &window(),
                                          [&](widgets::MessageKind, const QString& text) { told << text; });
  retarget();
  QObject::disconnect(listening);
  EXPECT_EQ(files(), QStringList({"out_" + both[0] + ".csv", "out_" + both[1] + ".csv"}));
  ASSERT_FALSE(told.isEmpty());
  EXPECT_THAT(told.last().toStdString(), HasSubstr(both[1].toStdString() + ": 20 frames, leader scale:0.9"));
  EXPECT_THAT(state(), HasSubstr("2 takes"));
}

TEST_F(RetargetWindow, WhatCannotBeDoneIsSaidBeforeItIsStarted) {
  const auto refused = [](const std::string& why) {
    EXPECT_FALSE(button("Retarget").isEnabled()) << why;
    EXPECT_THAT(about(), HasSubstr(why));
  };
  EXPECT_THAT(about(), HasSubstr("Writes out.bvh"));
  body("Leader's body").setEditText("scale:9");
  refused("a number from 0.3 to 3 is expected");
  body("Leader's body").setEditText("user");
  refused("a recorded pair has no user");
  body("Leader's body").setEditText("library");
  frame("To frame").setValue(10'000'000);
  refused("has frames 0 to");
  frame("To frame").setValue(20);
  dialog().setFolder(output + "/gone");
  refused("folder does not exist");
  dialog().setFolder(output);
  dialog().chooseTakes({});
  refused("No take is chosen");
}

TEST_F(RetargetWindow, AFileThatIsReplacedIsNamedBefore) {
  ASSERT_TRUE(write_whole_file(QDir(output).filePath("out.bvh").toStdString(), "old"));
  field("Name").setText("other");
  EXPECT_THAT(about(), ::testing::Not(HasSubstr("Replaces")));
  field("Name").setText("out");
  EXPECT_THAT(about(), HasSubstr("Writes out.bvh. Replaces out.bvh"));
}

TEST_F(RetargetWindow, CancelledItLeavesNothing) {
  frame("To frame").setValue(-1);
  dialog().findChild<QCheckBox*>()->setChecked(true);
  button("Retarget").click();
  ASSERT_TRUE(until([] { return named<QProgressBar>("Progress").value() > 150; })) << "fitting";
  EXPECT_THAT(state(), HasSubstr(take(0).toStdString() + ": "));
  button("Cancel").click();
  ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  EXPECT_TRUE(dialog().isVisible()) << "the button closes the dialog only when nothing runs";
  EXPECT_THAT(state(), HasSubstr("nothing was written"));
  EXPECT_EQ(files(), QStringList());
}

TEST_F(RetargetWindow, AnErrorOfTheWorkIsShownAndLeavesNothing) {
  body("Follower's body").setEditText(QDir(output).filePath("gone.bvh"));
  retarget();
  EXPECT_THAT(state(), HasSubstr("gone.bvh"));
  ASSERT_EQ(window().messages().openErrors().size(), 1);
  EXPECT_EQ(files(), QStringList());
  body("Follower's body").setEditText("library");
  retarget();
  EXPECT_TRUE(window().messages().openErrors().isEmpty()) << "the error leaves with the next success";
}

TEST_F(RetargetWindow, TakesOfAManifestAreOfferedToo) {
  QProcess abrazo;
  abrazo.setWorkingDirectory(home().path());
  abrazo.start(program(), {"demo", "-o", "takes", "--minutes", "0.2"});
  ASSERT_TRUE(abrazo.waitForFinished(-1));
  const QString manifest = home().filePath("takes/manifest.json");
  emit dialog().manifestChosen(manifest);
  ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  EXPECT_EQ(dialog().manifest(), manifest);
  dialog().chooseTakes({"salsa_01"});
  retarget();
  EXPECT_EQ(files(), QStringList({"out.bvh"}));
  emit dialog().manifestChosen(home().filePath("gone.json"));
  ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  EXPECT_THAT(state(), HasSubstr("gone.json"));
}

/// The preview of the dialog, whose player stands still.
class RetargetPreviewOfWindow : public RetargetWindow {
 protected:
  void SetUp() override {
    RetargetWindow::SetUp();
    frame("To frame").setValue(-1);
    ASSERT_TRUE(complete());
    preview().ticker().pause();
    preview().setSide(RetargetPreview::Side::Both);
  }
  static RetargetPreview& preview() { return dialog().preview(); }
  static RetargetPreviewDesk& computing() { return desk().preview(); }
  static QLabel& state() { return *preview().findChild<QLabel*>("previewState"); }
  static bool complete() {
    return until([] { return !computing().isComputing() && computing().shown().recorded; });
  }
  static widgets::ValueSlider& slider(const QString& body) {
    return named<widgets::ValueSlider>(body + ": size");
  }
  static QToolButton& side(const QString& name) {
    for (auto* each : preview().findChildren<QToolButton*>())
      if (each->text() == name) return *each;
    throw std::invalid_argument(name.toStdString());
  }
  /// Parks there and waits until it is shown. @return the pair in the scene
  static PairPose shownAt(int frame) {
    const double time_s = computing().shown().time_of(static_cast<std::size_t>(frame));
    preview().ticker().seek(time_s);
    EXPECT_TRUE(until([&] {
      const auto& shown = preview().ticker().shown();
      return shown && shown->input_frame == frame && shown == preview().ticker().history()->at(time_s);
    }));
    return preview().ticker().shown()->result.result;
  }
  /// What is written of these choices.
  static TakeOnBodies written() {
    const auto wish = dialog().previewed();
    EXPECT_TRUE(wish);
    const auto takes = takes_of_library(*window().session()->material().library, wish->takes, "");
    EXPECT_TRUE(takes);
    auto made = retarget_take(takes->front(), *wish);
    EXPECT_TRUE(made);
    return *made;
  }
  static PairPose recording(int frame) {
    const RecordedPair& recorded = *computing().shown().recorded;
    PairPose pair;
    pair << recorded.active.poses[static_cast<std::size_t>(frame)],
        recorded.passive.poses[static_cast<std::size_t>(frame)];
    return pair;
  }
};

TEST_F(RetargetPreviewOfWindow, ShowsTheTakeAsItIsWrittenBesideTheRecording) {
  const TakeOnBodies made = written();
  for (const int frame : {0, 100, 333}) {
    EXPECT_EQ(shownAt(frame), made.pair.frames[static_cast<std::size_t>(frame)].pose) << frame;
    EXPECT_EQ(preview().ticker().shown()->result.selected_pair, recording(frame));
  }
  EXPECT_THAT(state().text().toStdString(), HasSubstr("Leader scale:0.9 ("));
  EXPECT_THAT(state().text().toStdString(), HasSubstr(made.described().quality_text()));
}

TEST_F(RetargetPreviewOfWindow, ItPlaysFromTheBeginningOfEveryTakeThatIsChosen) {
  (void)shownAt(200);
  dialog().chooseTakes({take(1)});
  ASSERT_TRUE(until([] {
    return computing().shown().recorded && computing().shown().recorded->name == take(1).toStdString();
  }));
  EXPECT_EQ(preview().ticker().playback().state, Playback::State::Playing);
  EXPECT_TRUE(until([] { return preview().ticker().playback().cursor_s > 0.3; }));
  EXPECT_LT(preview().ticker().playback().cursor_s, 200 / 60.0);
  EXPECT_TRUE(complete());
}

TEST_F(RetargetPreviewOfWindow, ASliderGivesABodyAnotherSizeAndFramesNearbyComeFirst) {
  const PairPose before = shownAt(150);
  int pieces = 0;
  const auto counting = QObject::connect(&preview().ticker(), &FrameTicker::frameReady, &preview(), [&] {
    for (const PreviewedPair::Piece& piece : computing().shown().pieces)
      if (piece.first > 0) ++pieces;
  });
  emit slider("Leader's body").moved(0.7, 1);
  EXPECT_EQ(body("Leader's body").currentText(), QString("scale:1.20"));
  EXPECT_TRUE(until([&] { return preview().ticker().shown()->result.result != before; }));
  QObject::disconnect(counting);
  EXPECT_GT(pieces, 0) << "a piece around the cursor, before the whole take";
  EXPECT_EQ(preview().ticker().playback().cursor_s, 150 / 60.0) << "the place stays";
  ASSERT_TRUE(complete());
  EXPECT_EQ(shownAt(150), written().pair.frames[150].pose);
  emit slider("Leader's body").resetRequested(2);
  EXPECT_EQ(body("Leader's body").currentText(), QString("library"));
  ASSERT_TRUE(complete());
  EXPECT_EQ(shownAt(150), recording(150)) << "both are as recorded";
  body("Leader's body").setEditText("scale:0.8");
  EXPECT_NEAR(slider("Leader's body").place(), 0.3, 1e-9) << "a typed size moves it as well";
}

TEST_F(RetargetPreviewOfWindow, AWeightChangesTheResult) {
  const PairPose before = shownAt(100);
  emit named<widgets::ValueSlider>("Contacts").moved(0, 1);
  EXPECT_TRUE(until([&] { return preview().ticker().shown()->result.result != before; }));
  ASSERT_TRUE(complete());
  EXPECT_EQ(shownAt(100), written().pair.frames[100].pose);
}

TEST_F(RetargetPreviewOfWindow, OfManySizesInARowTheLastOneStays) {
  for (int step = 1; step <= 20; ++step) {
    emit slider("Follower's body").moved(0.5 + 0.01 * step, 1);
    turn();
  }
  EXPECT_EQ(body("Follower's body").currentText(), QString("scale:1.20"));
  ASSERT_TRUE(complete());
  EXPECT_EQ(shownAt(40), written().pair.frames[40].pose);
}

TEST_F(RetargetPreviewOfWindow, ATallerBodyStaysInThePicture) {
  body("Leader's body").setEditText("library");
  ASSERT_TRUE(complete());
  (void)shownAt(60);
  const auto distance_m = [] { return preview().scene().camera().distance_m; };
  preview().scene().frameAll();
  QTest::qWait(500);  // the camera moves there
  const double before_m = distance_m();
  body("Leader's body").setEditText("scale:1.50");
  EXPECT_TRUE(until([&] { return distance_m() > 1.2 * before_m; }));
  ASSERT_TRUE(complete());
}

TEST_F(RetargetPreviewOfWindow, AAndBExchangeTheRecordingAndTheResult) {
  const PairPose made = shownAt(60);
  ASSERT_NE(made, recording(60));
  side("A: recording").click();
  EXPECT_EQ(shownAt(60), recording(60));
  side("B: other bodies").click();
  EXPECT_EQ(shownAt(60), made);
  side("Both").click();
  EXPECT_EQ(shownAt(60), made);
}

TEST_F(RetargetPreviewOfWindow, ThePicturesOfAAndBDiffer) {
  body("Leader's body").setEditText("scale:1.3");
  ASSERT_TRUE(complete());
  (void)shownAt(60);
  preview().scene().setFollowing(false);  // the camera would still come nearer
  const auto picture = [](RetargetPreview::Side side) {
    preview().setSide(side);
    (void)shownAt(60);
    return preview().scene().picture();
  };
  const auto pixels_unlike = [](const QImage& a, const QImage& b) {
    int unlike = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) unlike += a.pixel(x, y) != b.pixel(x, y);
    return unlike;
  };
  const QImage recorded = picture(RetargetPreview::Side::Recording);
  const QImage made = picture(RetargetPreview::Side::Retargeted);
  ASSERT_EQ(recorded.size(), made.size());
  const int whole = made.width() * made.height();
  EXPECT_GT(pixels_unlike(recorded, made), whole / 100) << "a leader who is 30 % taller";
  EXPECT_GT(pixels_unlike(made, picture(RetargetPreview::Side::Both)), whole / 500)
      << "lines of the recording";
  EXPECT_EQ(pixels_unlike(made, picture(RetargetPreview::Side::Retargeted)), 0) << "the same again";
  preview().scene().setFollowing(true);
}

TEST_F(RetargetPreviewOfWindow, WhatCannotBeShownIsSaidAndTheNextChoiceIsShownAgain) {
  body("Leader's body").setEditText("scale:9");
  EXPECT_THAT(state().text().toStdString(), HasSubstr("a number from 0.3 to 3 is expected"));
  EXPECT_FALSE(preview().isEnabled());
  body("Leader's body").setEditText(QDir(output).filePath("gone.bvh"));
  EXPECT_TRUE(until([] { return state().text().contains("gone.bvh"); }));
  body("Leader's body").setEditText("scale:1.1");
  ASSERT_TRUE(complete());
  EXPECT_TRUE(preview().isEnabled());
  EXPECT_EQ(shownAt(10), written().pair.frames[10].pose);
  dialog().chooseTakes({});
  EXPECT_THAT(state().text().toStdString(), HasSubstr("Choose a take"));
}

TEST_F(RetargetPreviewOfWindow, NothingIsComputedForADialogThatIsHidden) {
  emit slider("Leader's body").moved(0.8, 1);
  dialog().hide();
  EXPECT_FALSE(computing().isComputing());
  EXPECT_FALSE(preview().ticker().history()) << "nothing plays";
  body("Leader's body").setEditText("scale:0.7");
  turn();
  EXPECT_FALSE(computing().isComputing());
}

}  // namespace
}  // namespace abrazo::app::retarget_dialog_test
