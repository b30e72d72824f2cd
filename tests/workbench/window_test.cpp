#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMimeData>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <QWheelEvent>
#include <utility>

#include "app/workbench/shell/status_figures.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"

namespace abrazo::app::window_test {
namespace {

using State = Playback::State;

/// One window on the generated dance for all tests: opening it takes seconds.
class Window : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1280, 720}, 31); }
  void SetUp() override {
    ASSERT_TRUE(window().ticker().shown()) << "the demo did not start";
    ticker().follow();
    DemoWindow::SetUp();
  }

  static std::uint64_t newest() { return window().session()->latest().newest()->index; }
  static std::uint64_t shown() { return ticker().shown()->index; }
};

TEST_F(Window, PPinsTheSelectedPairVVetoesItAndBothCanBeUndone) {
  const auto winner = [] {
    const FrameResult& result = window().ticker().shown()->result;
    return result.selected < 0 ? -1 : result.candidates[static_cast<std::size_t>(result.selected)].pair;
  };
  const auto pinned = [] { return window().document().decisions().pinned; };
  press(Qt::Key_P);
  ASSERT_TRUE(pinned());
  const int pair = *pinned();
  EXPECT_TRUE(until([&] { return winner() == pair; }));
  press(Qt::Key_V, Qt::ShiftModifier);
  EXPECT_FALSE(pinned());
  const std::string take = window().session()->material().library->take_of(pair).name;
  const auto source = [&] { return window().session()->material().library->take_of(winner()).name; };
  EXPECT_TRUE(until([&] { return winner() >= 0 && source() != take; }));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(pinned(), pair) << "the pin that the veto let go is back";
  EXPECT_TRUE(until([&] { return winner() == pair; }));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(is_neutral(window().document().decisions()));
}

TEST_F(Window, WithEveryTakeVetoedTheFrameSaysSoAndThePartnerIsHeld) {
  const std::shared_ptr<const MotionLibrary> library = window().session()->material().library;
  Decisions all;
  for (const LibraryTake& take : library->takes()) all.vetoes.takes.insert(take.name);
  window().document().change(all, "veto everything");
  EXPECT_TRUE(until([] { return window().ticker().shown()->result.status == StepStatus::Failed; }));
  EXPECT_NE(window().ticker().shown()->result.message.find("vetoed"), std::string::npos);
  press(Qt::Key_P, Qt::ShiftModifier);
  EXPECT_TRUE(until([] { return window().ticker().shown()->result.status != StepStatus::Failed; }));
  window().undoStack().clear();
}

QString described(const QWidget* widget) {
  if (!widget) return "nothing";
  return QString(widget->metaObject()->className()) + " " + widget->objectName() + " " +
         widget->accessibleName();
}

TEST_F(Window, AltCGoesToTheCandidatesAndReturnTellsTheFactsOfTheFrame) {
  ASSERT_TRUE(until([] { return !ticker().shown()->result.candidates.empty(); }));
  press(Qt::Key_C, Qt::AltModifier);
  const widgets::CandidateTable& table = window().candidates();
  EXPECT_TRUE(until(  // once the list shows the frame
      [] {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        return window().messages().text().contains("frame");
      }))
      << "the focus has " << qPrintable(described(QApplication::focusWidget())) << ", told is "
      << qPrintable(window().messages().text());
  const int take = window().takes().selectedTake();
  ASSERT_GE(take, 0);
  EXPECT_TRUE(window().messages().text().startsWith(QString::fromStdString(
      window().session()->material().library->takes()[static_cast<std::size_t>(take)].name)));
  EXPECT_EQ(QApplication::focusWidget(), table.focusProxy());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  window().setFocus();
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

/// A parked window cost most of a core: a lane that grew made Qt put the whole window together, scene and
/// all. Counted, not timed: so many turns of the display, however long they take.
TEST_F(Window, AParkedWindowDrawsNoSceneAndFewPanelsWhileTheSolverGoesOn) {
  for (const QSize size : {QSize(1280, 720), QSize(1600, 1000)}) {
    window().resize(size);
    ticker().pause();
    std::uint64_t before = ~std::uint64_t{0};  // the last picture is drawn again with smooth edges
    ASSERT_TRUE(until([&before] {
      QTest::qWait(600);
      const std::uint64_t seen = std::exchange(before, window().scene().renderedFrames());
      return seen == before;
    }));
    const std::uint64_t pictures = window().scene().renderedFrames(), solved = newest();
    int turns = 0, panels = 0;
    const QObject here;
    QObject::connect(&ticker(), &FrameTicker::playbackChanged, &here, [&turns] { ++turns; });
    QObject::connect(&ticker(), &FrameTicker::panelsDue, &here, [&panels] { ++panels; });
    QElapsedTimer clock;
    clock.start();
    ASSERT_TRUE(until([&] { return turns > 60 && newest() > solved + 30; }));
    const int due = static_cast<int>(clock.elapsed() / 500) + 1;
    // A message that goes makes the scene higher, which is one picture.
    EXPECT_LE(window().scene().renderedFrames(), pictures + 1);
    EXPECT_LE(panels, due);
  }
  for (const QWidget* widget : window().findChildren<QWidget*>())
    EXPECT_FALSE(widget->inherits("QOpenGLWidget")) << "with it every repaint is one of the whole window";
  window().resize(1280, 720);
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
  auto* field = window().findChild<QLineEdit*>();
  ASSERT_TRUE(field);
  field->setFocus();
  QTest::keyClick(field, Qt::Key_Space);
  turn();
  EXPECT_EQ(ticker().playback().state, State::Following);
  field->clear();
  field->clearFocus();
}

TEST_F(Window, ASettingReachesTheRunningSolverAndUndoTakesItBack) {
  const double before = window().document().settings().alpha;
  window().document().changeSetting("alpha", "0.77");
  EXPECT_EQ(window().undoStack().undoText(), "temporal smoothness to 0.77");
  EXPECT_TRUE(until([] { return ticker().shown()->settings.alpha == 0.77; }));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(until([before] { return ticker().shown()->settings.alpha == before; }));
}

/// Every fourth pose of a clip was "lost" with the preset paper, and came "in 15 Hz".
/// What scrolled the settings changed the energy of the running solver as soon as its list came under the
/// pointer, and scrolled no further.
TEST_F(Window, TheWheelScrollsTheSettingsAndChangesNoChoiceInThem) {
  auto* list = window().settings().findChild<QScrollArea*>();
  ASSERT_TRUE(list);
  while (QWidget* popup = QApplication::activePopupWidget()) popup->close();  // it would get the wheel
  ASSERT_TRUE(until([list] { return list->verticalScrollBar()->maximum() > 100; })) << "is laid out";
  list->verticalScrollBar()->setValue(0);
  const auto boxes = list->widget()->findChildren<QComboBox*>();
  ASSERT_GE(boxes.size(), 3);
  int tried = 0;
  for (QComboBox* box : boxes) {
    if (!box->isEnabled() || box->count() < 2) continue;
    ++tried;
    list->ensureWidgetVisible(box);
    for (const bool has_focus : {false, true}) {
      if (has_focus) box->setFocus();
      for (const int notches : {-1, 1}) {
        const int before = box->currentIndex();
        const QPointF middle = box->rect().center();
        QWheelEvent wheel(middle, box->mapToGlobal(middle.toPoint()), {}, {0, 120 * notches}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QSpontaneKeyEvent::setSpontaneous(&wheel);  // as of a mouse: it is offered to the parents as well
        QApplication::instance()->notify(box, &wheel);
        EXPECT_EQ(box->currentIndex(), before) << box->accessibleName().toStdString();
      }
    }
  }
  EXPECT_GE(tried, 3);
}

TEST_F(Window, TheStatusBarTellsWhatComesInFromWhatIsSolved) {
  const auto says = [](const QString& words) {
    return until([&] { return window().status().words().contains(words); });
  };
  window().document().choosePreset("paper", false);
  EXPECT_TRUE(says("steps 15 Hz")) << window().status().words().join("; ").toStdString();
  EXPECT_TRUE(says("in 60 Hz"));
  for (const QString& figure : window().status().words())
    EXPECT_FALSE(figure.startsWith("lost")) << "a clip loses nothing";
  window().document().choosePreset("responsive", false);
  EXPECT_TRUE(says("steps 60 Hz"));
}

TEST_F(Window, AFileThatCannotBeOpenedSaysWhatToDoAndLeavesTheSessionRunning) {
  window().openFiles({"/no/such/place/walk.txt"});
  EXPECT_TRUE(until([] { return window().messages().text().contains("walk.txt"); }));
  EXPECT_TRUE(window().messages().text().contains("use a motion"));
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
    window().openFiles(files);
    EXPECT_TRUE(until([&message = message] { return window().messages().text().contains(message); }))
        << window().messages().text().toStdString();
    EXPECT_FALSE(window().messages().text().contains("--skeleton"));
  }
}

TEST_F(Window, DroppedFilesAreOpened) {
  QMimeData dropped;
  dropped.setUrls({QUrl::fromLocalFile("/no/such/place/dropped.bvh")});
  QDragEnterEvent enter({100, 100}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &drop);
  EXPECT_TRUE(until([] { return window().messages().text().contains("dropped.bvh"); }));
}

TEST_F(Window, OpeningSomethingElseReplacesTheJobThatRuns) {
  window().openDemo();
  window().openFiles({"/no/such/place/later.bvh"});
  EXPECT_TRUE(until([] { return window().messages().text().contains("later.bvh"); }));
  QTest::qWait(2500);
  EXPECT_TRUE(window().messages().text().contains("later.bvh")) << "the first job must not speak any more";
}

TEST_F(Window, AnotherMaterialReplacesTheSessionOnceItIsReady) {
  QSignalSpy started(&window().document(), &Document::began);  // the next session may lie at the same address
  window().openDemo();
  bool was_shown = true;
  EXPECT_TRUE(until([&started, &was_shown] {
    if (started.isEmpty()) was_shown = was_shown && ticker().shown();
    return started.size() == 1;
  }));
  EXPECT_TRUE(was_shown) << "the old one runs until then";
  EXPECT_TRUE(until([] { return ticker().shown() && shown() > 5; }));
  EXPECT_LT(ticker().playback().last_s, 10) << "a timeline of its own";
}

TEST_F(Window, ManyWarningsAreCounted) {
  auto& messages = window().messages();
  messages.showWarnings({"the unit was guessed"});
  EXPECT_EQ(messages.text(), "the unit was guessed");
  messages.showWarnings({"the unit was guessed", "no toes", "no hands"});
  EXPECT_TRUE(messages.text().startsWith("3 warnings: the unit was guessed"));
}

TEST_F(Window, AClosedWindowDoesNotWaitForItsJob) {
  QElapsedTimer clock;
  {
    MainWindow other(remembered());
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
  EXPECT_TRUE(plan_panels({1280, 720}, {}, 348).left) << "beside the welcome page";
  EXPECT_FALSE(plan_panels({1060, 640}, {}, 348).left);
  EXPECT_TRUE(plan_panels({1060, 640}, {}, 348).right);
}

TEST(PanelPlan, WhatWasAskedForStands) {
  EXPECT_TRUE(plan_panels({640, 480}, {.left = true, .right = {}, .plots = {}}).left);
  EXPECT_FALSE(plan_panels({1600, 1000}, {.left = {}, .right = false, .plots = {}}).right);
}

TEST_F(Window, APictureOfTheWindowHoldsTheScene) {
  QTemporaryDir folder;
  const QString file = folder.filePath("window.png");
  QTest::keyClick(&window().scene(), Qt::Key_0);  // show all, whatever the tests before did
  ASSERT_TRUE(until([] { return ticker().shown()->result.status != StepStatus::Failed; }));
  turn();
  ASSERT_EQ(save_screenshot(window(), file), QString());
  const QImage picture(file);
  const QRect scene(window().scene().mapTo(&window(), QPoint(0, 0)), window().scene().size());
  const QImage view = picture.copy(scene);
  int blue = 0, coral = 0;
  for (int y = 60; y < view.height(); ++y)
    for (int x = 0; x < view.width(); ++x) {
      const QColor c = view.pixelColor(x, y);
      blue += c.hsvSaturation() > 90 && std::abs(c.hue() - window().colours().active.hue()) < 12;
      coral += c.hsvSaturation() > 90 && std::abs(c.hue() - window().colours().passive.hue()) < 12;
    }
  EXPECT_GT(blue, 1500);
  EXPECT_GT(coral, 1500);
}

}  // namespace
}  // namespace abrazo::app::window_test
