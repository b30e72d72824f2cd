#include <gtest/gtest.h>

#include <QApplication>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "tests/workbench/until.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"

namespace abrazo::app::window_test {
namespace {

using State = Playback::State;

/// One window on the generated dance for all tests: opening it takes seconds.
class Window : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    s_home = new QTemporaryDir;
    qputenv("ABRAZO_HOME", s_home->path().toUtf8());
    s_remembered = new UserSettings;
    s_window = new MainWindow(*s_remembered);
    s_window->setTheme(widgets::Theme::Dark);
    s_window->resize(1280, 720);
    add_all_actions(*s_window);
    s_window->show();
    s_window->openDemo();
    until([] { return s_window->ticker().shown() && s_window->ticker().shown()->index > 30; });
  }
  static void TearDownTestSuite() {
    delete s_window;
    delete s_remembered;
    delete s_home;
  }
  void SetUp() override {
    ASSERT_TRUE(s_window->ticker().shown()) << "the demo did not start";
    s_window->activateWindow();
    (void)QTest::qWaitForWindowActive(s_window, 300);  // a bare display has no window manager to say so
    s_window->setFocus();
    s_window->ticker().follow();
    turn();
  }

  static void turn() { QTest::qWait(40); }
  static void press(int key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(s_window, static_cast<Qt::Key>(key), modifiers);
    turn();
  }
  static FrameTicker& ticker() { return s_window->ticker(); }
  static std::uint64_t shown() { return ticker().shown()->index; }

  static inline MainWindow* s_window = nullptr;
  static inline UserSettings* s_remembered = nullptr;
  static inline QTemporaryDir* s_home = nullptr;
};

TEST_F(Window, PPinsTheSelectedPairVVetoesItAndBothCanBeUndone) {
  const auto winner = [] {
    const FrameResult& result = s_window->ticker().shown()->result;
    return result.selected < 0 ? -1 : result.candidates[static_cast<std::size_t>(result.selected)].pair;
  };
  const auto pinned = [] { return s_window->candidates().steering().pinned; };
  press(Qt::Key_P);
  ASSERT_TRUE(pinned());
  const int pair = *pinned();
  EXPECT_TRUE(until([&] { return winner() == pair; }));
  press(Qt::Key_V, Qt::ShiftModifier);
  EXPECT_FALSE(pinned());
  const std::string take = s_window->candidates().library()->take_of(pair).name;
  const auto source = [&] { return s_window->candidates().library()->take_of(winner()).name; };
  EXPECT_TRUE(until([&] { return winner() >= 0 && source() != take; }));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(pinned(), pair) << "the pin that the veto let go is back";
  EXPECT_TRUE(until([&] { return winner() == pair; }));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(s_window->candidates().steering().empty());
}

TEST_F(Window, WithEveryTakeVetoedTheFrameSaysSoAndThePartnerIsHeld) {
  const std::shared_ptr<const MotionLibrary> library = s_window->candidates().library();
  widgets::Steering all;
  for (const LibraryTake& take : library->takes()) all.vetoes.takes.insert(take.name);
  emit s_window->candidates().steeringRequested(all, "veto everything");
  EXPECT_TRUE(until([] { return s_window->ticker().shown()->result.status == StepStatus::Failed; }));
  EXPECT_NE(s_window->ticker().shown()->result.message.find("vetoed"), std::string::npos);
  press(Qt::Key_P, Qt::ShiftModifier);
  EXPECT_TRUE(until([] { return s_window->ticker().shown()->result.status != StepStatus::Failed; }));
  s_window->undoStack().clear();
}

QString described(const QWidget* widget) {
  if (!widget) return "nothing";
  return QString(widget->metaObject()->className()) + " " + widget->objectName() + " " +
         widget->accessibleName();
}

TEST_F(Window, AltCGoesToTheCandidatesAndReturnTellsTheFactsOfTheFrame) {
  ASSERT_TRUE(until([] { return !ticker().shown()->result.candidates.empty(); }));
  press(Qt::Key_C, Qt::AltModifier);
  const widgets::CandidateTable& table = s_window->candidates();
  EXPECT_TRUE(until(  // once the list shows the frame
      [] {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        return s_window->messages().text().contains("frame");
      }))
      << "the focus has " << qPrintable(described(QApplication::focusWidget())) << ", told is "
      << qPrintable(s_window->messages().text());
  const int take = s_window->takes().selectedTake();
  ASSERT_GE(take, 0);
  EXPECT_TRUE(s_window->messages().text().startsWith(
      QString::fromStdString(table.library()->takes()[static_cast<std::size_t>(take)].name)));
  EXPECT_EQ(QApplication::focusWidget(), table.focusProxy());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  s_window->setFocus();
}

TEST_F(Window, SpaceParksAndPlaysOn) {
  press(Qt::Key_Space);
  EXPECT_EQ(ticker().playback().state, State::Parked);
  const auto parked = shown();
  QTest::qWait(200);
  EXPECT_EQ(shown(), parked) << "what comes in must not move a parked cursor";
  press(Qt::Key_Space);
  EXPECT_EQ(ticker().playback().state, State::Playing);
}

TEST_F(Window, ArrowsStepFrames) {
  press(Qt::Key_Space);
  const auto start = shown();
  press(Qt::Key_Left);
  EXPECT_EQ(shown(), start - 1);
  press(Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(shown(), start - 11);
  press(Qt::Key_Right, Qt::ShiftModifier);
  press(Qt::Key_Right);
  EXPECT_EQ(shown(), start);
}

TEST_F(Window, HomeGoesToTheBeginningAndEndFollows) {
  press(Qt::Key_Home);
  EXPECT_DOUBLE_EQ(ticker().playback().cursor_s, ticker().playback().first_s);
  EXPECT_EQ(ticker().playback().state, State::Parked);
  press(Qt::Key_End);
  EXPECT_EQ(ticker().playback().state, State::Following);
}

TEST_F(Window, ShuttleAndSpeedKeys) {
  press(Qt::Key_J);
  EXPECT_EQ(ticker().playback().state, State::Playing);
  EXPECT_LT(ticker().playback().speed, 0);
  press(Qt::Key_K);
  EXPECT_EQ(ticker().playback().state, State::Parked);
  press(Qt::Key_Backspace);
  EXPECT_DOUBLE_EQ(ticker().playback().speed, 1);
  press(Qt::Key_BracketLeft);
  EXPECT_DOUBLE_EQ(ticker().playback().speed, 0.5);
  press(Qt::Key_BracketRight);
  EXPECT_DOUBLE_EQ(ticker().playback().speed, 1);
}

TEST_F(Window, KeysGoToAFieldThatIsBeingEdited) {
  auto* field = s_window->findChild<QLineEdit*>();
  ASSERT_TRUE(field);
  field->setFocus();
  QTest::keyClick(field, Qt::Key_Space);
  turn();
  EXPECT_EQ(ticker().playback().state, State::Following);
  field->clear();
  field->clearFocus();
}

TEST_F(Window, ASettingReachesTheRunningSolverAndUndoTakesItBack) {
  const double before = s_window->settings().settings().alpha;
  s_window->settings().change("alpha", "0.77");
  EXPECT_TRUE(until([] { return ticker().shown()->settings.alpha == 0.77; }));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(until([before] { return ticker().shown()->settings.alpha == before; }));
}

TEST_F(Window, AFileThatCannotBeOpenedSaysWhatToDoAndLeavesTheSessionRunning) {
  s_window->openFiles({"/no/such/place/walk.txt"});
  EXPECT_TRUE(until([] { return s_window->messages().text().contains("walk.txt"); }));
  EXPECT_TRUE(s_window->messages().text().contains("use a motion"));
  const auto index = shown();
  EXPECT_TRUE(until([index] { return shown() > index; }));
}

/// A file with this content in the folder.
QString written(const QTemporaryDir& folder, const QString& name, const QByteArray& content) {
  QFile file(folder.filePath(name));
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(content);
  return file.fileName();
}

TEST_F(Window, FilesThatDoNotGoTogetherAreRefusedWithWhatToDo) {
  QTemporaryDir folder, elsewhere;
  const QString amc = written(folder, "walk.amc", ":DEGREES"),
                asf = written(elsewhere, "body.asf", ":version");
  const std::vector<std::pair<QStringList, QString>> cases = {
      {{amc}, "walk.amc: an .amc needs its skeleton"},
      {{asf}, "open it together with"},
      {{folder.path()}, "open a file in it"},
      {{folder.filePath("gone.bvh")}, "check its name"}};
  for (const auto& [files, message] : cases) {
    s_window->openFiles(files);
    EXPECT_TRUE(until([&message = message] { return s_window->messages().text().contains(message); }))
        << s_window->messages().text().toStdString();
    EXPECT_FALSE(s_window->messages().text().contains("--skeleton"));
  }
}

TEST_F(Window, DroppedFilesAreOpened) {
  QMimeData dropped;
  dropped.setUrls({QUrl::fromLocalFile("/no/such/place/dropped.bvh")});
  QDragEnterEvent enter({100, 100}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(s_window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(s_window, &drop);
  EXPECT_TRUE(until([] { return s_window->messages().text().contains("dropped.bvh"); }));
}

TEST_F(Window, OpeningSomethingElseReplacesTheJobThatRuns) {
  s_window->openDemo();
  s_window->openFiles({"/no/such/place/later.bvh"});
  EXPECT_TRUE(until([] { return s_window->messages().text().contains("later.bvh"); }));
  QTest::qWait(2500);
  EXPECT_TRUE(s_window->messages().text().contains("later.bvh")) << "the first job must not speak any more";
}

TEST_F(Window, AnotherMaterialReplacesTheSessionOnceItIsReady) {
  QSignalSpy started(s_window, &MainWindow::sessionStarted);  // the next session may lie at the same address
  const auto index = shown();
  s_window->openDemo();
  EXPECT_TRUE(until([index] { return shown() > index; })) << "the old one runs until then";
  EXPECT_TRUE(until([&started] { return started.size() == 1; }));
  EXPECT_TRUE(until([] { return ticker().shown() && shown() > 5; }));
  EXPECT_LT(ticker().playback().last_s, 10) << "a timeline of its own";
}

TEST_F(Window, ManyWarningsAreCounted) {
  auto& messages = s_window->messages();
  messages.showWarnings({"the unit was guessed"});
  EXPECT_EQ(messages.text(), "the unit was guessed");
  messages.showWarnings({"the unit was guessed", "no toes", "no hands"});
  EXPECT_TRUE(messages.text().startsWith("3 warnings: the unit was guessed"));
}

TEST_F(Window, AClosedWindowDoesNotWaitForItsJob) {
  QElapsedTimer clock;
  {
    MainWindow other(*s_remembered);
    other.show();
    other.openDemo();
    QTest::qWait(50);
    other.close();
    clock.start();
  }
  EXPECT_LT(clock.elapsed(), 2000);
}

TEST(PanelPlan, TheSceneComesFirstInASmallWindow) {
  EXPECT_TRUE(plan_panels({1280, 720}, {}).left);
  EXPECT_FALSE(plan_panels({900, 600}, {}).left);
  EXPECT_TRUE(plan_panels({900, 600}, {}).right);
  EXPECT_FALSE(plan_panels({640, 480}, {}).right);
  EXPECT_FALSE(plan_panels({640, 480}, {}).plots);
}

TEST(PanelPlan, WhatWasAskedForStands) {
  EXPECT_TRUE(plan_panels({640, 480}, {.left = true, .right = {}, .plots = {}}).left);
  EXPECT_FALSE(plan_panels({1600, 1000}, {.left = {}, .right = false, .plots = {}}).right);
}

TEST_F(Window, APictureOfTheWindowHoldsTheScene) {
  QTemporaryDir folder;
  const QString file = folder.filePath("window.png");
  QTest::keyClick(&s_window->scene(), Qt::Key_0);  // show all, whatever the tests before did
  ASSERT_TRUE(until([] { return ticker().shown()->result.status != StepStatus::Failed; }));
  turn();
  ASSERT_EQ(save_screenshot(*s_window, file), QString());
  const QImage picture(file);
  const QRect scene(s_window->scene().mapTo(s_window, QPoint(0, 0)), s_window->scene().size());
  const QImage view = picture.copy(scene);
  int blue = 0, coral = 0;
  for (int y = 60; y < view.height(); ++y)
    for (int x = 0; x < view.width(); ++x) {
      const QColor c = view.pixelColor(x, y);
      blue += c.hsvSaturation() > 90 && std::abs(c.hue() - s_window->colours().active.hue()) < 12;
      coral += c.hsvSaturation() > 90 && std::abs(c.hue() - s_window->colours().passive.hue()) < 12;
    }
  EXPECT_GT(blue, 1500);
  EXPECT_GT(coral, 1500);
}

}  // namespace
}  // namespace abrazo::app::window_test
