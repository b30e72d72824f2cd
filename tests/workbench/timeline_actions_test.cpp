// Markers, range, go to and speed in the whole window, by the keys of a user.
#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/workbench/demo_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/timeline/quick_entry.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app::timeline_actions_test {
namespace {

using State = Playback::State;

/// One window on the generated dance for all tests: opening it takes seconds.
class TimelineActions : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showDemo({1280, 720});
    until([] { return ticker().playback().last_s > 3; });
  }
  void SetUp() override {
    ASSERT_TRUE(ticker().shown()) << "the demo did not start";
    DemoWindow::SetUp();
    window().document().put(SubjectMarkers{"", {}});
    ticker().setRange(0, 0);
    ticker().setLoop(false);
    ticker().setEveryFrame(false);
    ticker().seek(1.5);
    ticker().setSpeed(1);
    turn();
  }

  /// Into the field that is open.
  static QString enter(const QString& text) {
    auto* entry = window().findChild<widgets::QuickEntry*>();
    if (!entry) return "no field is open";
    auto* field = entry->findChild<QLineEdit*>();
    field->setText(text);
    QTest::keyClick(field, Qt::Key_Return);
    turn();
    const auto* still = window().findChild<widgets::QuickEntry*>();
    return still && still->isVisible() ? still->complaint() : QString();
  }
  static const Playback& playback() { return ticker().playback(); }
  static widgets::TimelineView& timeline() { return window().timeline(); }
  static const std::vector<Marker>& markers() { return timeline().markers().all(); }
};

TEST_F(TimelineActions, MAddsAMarkerDelDeletesItAndUndoBringsItBack) {
  press(Qt::Key_M);
  ASSERT_EQ(markers().size(), 1u);
  EXPECT_NEAR(markers()[0].time_s, 1.5, 1e-9);
  EXPECT_EQ(timeline().selectedMarker(), markers()[0].id);
  press(Qt::Key_Delete);
  EXPECT_TRUE(markers().empty());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(markers().size(), 1u);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(markers().empty());
}

TEST_F(TimelineActions, ShiftMAsksForANameWhereTheKeyWasPressed) {
  ticker().follow();
  turn();
  const double before = playback().cursor_s;
  press(Qt::Key_M, Qt::ShiftModifier);
  const double after = playback().cursor_s;
  until([after] { return playback().cursor_s > after; });
  EXPECT_EQ(enter("dip"), QString());
  ASSERT_EQ(markers().size(), 1u);
  EXPECT_EQ(markers()[0].name, "dip");
  EXPECT_GE(markers()[0].time_s, before);
  EXPECT_LE(markers()[0].time_s, after) << "it went on while the name was typed";
}

TEST_F(TimelineActions, CtrlArrowsGoToMarkersAndEdgesOfMoves) {
  Markers two;
  two.add(0.8);
  two.add(2.2);
  window().document().put(SubjectMarkers{"", two});
  double before = playback().cursor_s;
  for (int steps = 0; steps < 50 && playback().cursor_s < 2.2 - 1e-9; ++steps) {
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_GT(playback().cursor_s, before);
    before = playback().cursor_s;
  }
  EXPECT_NEAR(playback().cursor_s, 2.2, 1e-9) << "no marker is passed over";
  EXPECT_EQ(timeline().selectedMarker(), two.all()[1].id);
  for (int steps = 0; steps < 50 && playback().cursor_s > 0.8 + 1e-9; ++steps)
    press(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_NEAR(playback().cursor_s, 0.8, 1e-9);
}

TEST_F(TimelineActions, ADraggedMarkerIsOneStepOfUndo) {
  Markers one;
  const int id = one.add(1);
  window().document().put(SubjectMarkers{"", one});
  Markers moved = one;
  moved.move(id, 2);
  emit timeline().markersRequested(moved, "move marker");
  EXPECT_EQ(markers()[0].time_s, 2);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(markers()[0].time_s, 1);
}

TEST_F(TimelineActions, InOutAndTheirClearingByKey) {
  ticker().seek(1);
  press(Qt::Key_I);
  ticker().seek(2);
  press(Qt::Key_O);
  EXPECT_EQ(playback().range(), (Playback::Range{1, 2}));
  press(Qt::Key_I, Qt::AltModifier);
  EXPECT_EQ(playback().range(), (Playback::Range{playback().first_s, 2}));
  press(Qt::Key_O, Qt::AltModifier);
  EXPECT_FALSE(playback().range());
}

TEST_F(TimelineActions, InAndOutAreTakenBackAndADragOfThemIsOneStep) {
  ticker().seek(1);
  press(Qt::Key_I);
  ticker().seek(2);
  press(Qt::Key_O);
  const Playback::Ends both{1, 2};
  ASSERT_EQ(playback().ends(), both);
  EXPECT_EQ(window().undoStack().undoText(), "set out");
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(playback().ends(), (Playback::Ends{1, {}}));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(playback().ends(), Playback::Ends());
  press(Qt::Key_Y, Qt::ControlModifier);
  press(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(playback().ends(), both);
  const auto at = [](double time_s) {
    return QPoint(static_cast<int>(std::lround(timeline().axis().x(time_s))), 40);
  };
  QTest::mousePress(&timeline(), Qt::LeftButton, Qt::ShiftModifier, at(0.5));
  for (const double time_s : {0.7, 0.9, 1.3}) {
    QMouseEvent move(QEvent::MouseMove, at(time_s), timeline().mapToGlobal(at(time_s)), Qt::NoButton,
                     Qt::LeftButton, Qt::ShiftModifier);
    QApplication::sendEvent(&timeline(), &move);
  }
  QTest::mouseRelease(&timeline(), Qt::LeftButton, Qt::ShiftModifier, at(1.3));
  turn();
  const Playback::Ends dragged = playback().ends();
  ASSERT_NE(dragged, both);
  EXPECT_EQ(window().undoStack().undoText(), "set in and out");
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(playback().ends(), both) << "the whole drag";
  press(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(playback().ends(), dragged);
  press(Qt::Key_I, Qt::AltModifier);
  EXPECT_EQ(window().undoStack().undoText(), "clear in");
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(playback().ends(), dragged);
}

TEST_F(TimelineActions, CtrlLLoopsTheRange) {
  ticker().setRange(1, 1.3);
  press(Qt::Key_L, Qt::ControlModifier);
  EXPECT_TRUE(playback().loop);
  ticker().seek(2);
  press(Qt::Key_Space);
  QTest::qWait(600);
  EXPECT_EQ(playback().state, State::Playing);
  EXPECT_GE(playback().cursor_s, 1);
  EXPECT_LT(playback().cursor_s, 1.3);
}

/// A person who parks the cursor may believe that the clip stops with it.
TEST_F(TimelineActions, AParkedCursorIsToldThatTheClipPlaysOn) {
  const auto* live = window().transport().findChild<QPushButton*>();
  EXPECT_EQ(live->text(), "CLIP goes on  End");
  const double last_s = playback().last_s;
  EXPECT_TRUE(until([last_s] { return playback().last_s > last_s; })) << "as it says";
  action("Hold the input still")->trigger();
  EXPECT_TRUE(until([live] { return live->text() == "HELD  End"; }));
  action("Hold the input still")->trigger();
  EXPECT_TRUE(until([live] { return live->text() == "CLIP goes on  End"; }));
  press(Qt::Key_End);
  EXPECT_TRUE(until([live] { return live->text() == "CLIP  End"; }));
}

/// The cursor sprang to and fro between the gap and the frame after it.
TEST_F(TimelineActions, ALoopWithoutAFrameIsNotPlayedAndSaysWhy) {
  SessionEngine& engine = window().session()->engine();
  ticker().follow();
  action("Hold the input still")->trigger();
  const double held_s = engine.clock().now_s(), released_s = held_s + 2 * Playback::longest_gap_s;
  ASSERT_TRUE(until([&] { return engine.clock().now_s() > released_s; }));
  action("Hold the input still")->trigger();
  ASSERT_TRUE(until([&] { return engine.history().span().last_s > released_s; }));
  const double after_s = engine.history().stepped(released_s - 0.5, 1)->time_s;
  ASSERT_GT(after_s - engine.history().at(released_s - 0.5)->time_s, Playback::longest_gap_s);
  ticker().setRange(after_s - 1.2, after_s - 0.8);
  ticker().setLoop(true);
  ticker().seek(after_s - 1);
  turn();
  QSignalSpy frames(&ticker(), &FrameTicker::frameReady);
  press(Qt::Key_Space);
  EXPECT_TRUE(until([] { return playback().state == State::Parked; }));
  EXPECT_GE(playback().cursor_s, after_s - 1.2);
  EXPECT_LE(playback().cursor_s, after_s - 0.8);
  EXPECT_EQ(frames.count(), 0);
  EXPECT_TRUE(window().messages().text().contains("no frame lies between in and out"))
      << window().messages().text().toStdString();
}

TEST_F(TimelineActions, GGoesToFramesAndTimesAndSaysWhatIsWrong) {
  press(Qt::Key_G);
  EXPECT_EQ(enter("60"), QString());
  EXPECT_EQ(ticker().shown()->index, 60u);
  press(Qt::Key_G);
  EXPECT_EQ(enter("+10"), QString());
  EXPECT_EQ(ticker().shown()->index, 70u);
  press(Qt::Key_G);
  EXPECT_EQ(enter("0:01.25"), QString());
  EXPECT_NEAR(playback().cursor_s, 1.25, 1e-9);
  press(Qt::Key_G);
  EXPECT_EQ(enter("-0.5s"), QString());
  EXPECT_NEAR(playback().cursor_s, 0.75, 1e-9);
  press(Qt::Key_G);
  EXPECT_TRUE(enter("tomorrow").contains("neither a frame nor a time"));
  EXPECT_TRUE(enter("99999999").contains("has not been solved yet"));
  EXPECT_NEAR(playback().cursor_s, 0.75, 1e-9);
  EXPECT_EQ(enter("1s"), QString());
}

TEST_F(TimelineActions, TheRangeByNumber) {
  emit timeline().rangeEntryRequested();
  EXPECT_TRUE(enter("1s").contains("two places"));
  EXPECT_EQ(enter("0:02 to 0:01"), QString());
  ASSERT_TRUE(playback().range());
  EXPECT_DOUBLE_EQ(playback().range()->to_s, 2);
}

TEST_F(TimelineActions, WithKHeldJAndLStepOneFrame) {
  const auto start = ticker().shown()->index;
  QTest::keyPress(&window(), Qt::Key_K);
  turn();
  press(Qt::Key_L);
  press(Qt::Key_L);
  EXPECT_EQ(ticker().shown()->index, start + 2);
  press(Qt::Key_J);
  EXPECT_EQ(ticker().shown()->index, start + 1);
  EXPECT_EQ(playback().state, State::Parked);
  QTest::keyRelease(&window(), Qt::Key_K);
  press(Qt::Key_J);
  EXPECT_EQ(playback().state, State::Playing);
  EXPECT_EQ(playback().speed, -1);
}

TEST_F(TimelineActions, PlayingEveryFrameLeavesNoneOut) {
  ticker().setEveryFrame(true);
  std::vector<std::uint64_t> shown;
  const auto connection =
      QObject::connect(&ticker(), &FrameTicker::frameReady,
                       [&shown](const FrameSnapshotPtr& frame) { shown.push_back(frame->index); });
  ticker().seek(0.2);
  turn();
  shown.clear();
  ticker().toggle();
  until([&shown] { return shown.size() > 20; });
  ticker().pause();
  QObject::disconnect(connection);
  ASSERT_GT(shown.size(), 20u);
  for (std::size_t i = 1; i < shown.size(); ++i) EXPECT_EQ(shown[i], shown[i - 1] + 1);
}

TEST_F(TimelineActions, OfManyMovesBetweenTwoPicturesOnlyTheNewestIsShown) {
  int shown = 0;
  const auto connection = QObject::connect(&ticker(), &FrameTicker::frameReady, [&shown] { ++shown; });
  ticker().setScrubbing(true);
  for (int move = 0; move < 50; ++move) ticker().seek(1 + 0.02 * move);
  turn();
  ticker().setScrubbing(false);
  QObject::disconnect(connection);
  EXPECT_EQ(shown, 1);
  EXPECT_LE(ticker().shown()->time_s, 1.98);
  EXPECT_GT(ticker().shown()->time_s, 1.9);
}

TEST_F(TimelineActions, ArrowsWorkWithTheFocusInTheTimeline) {
  timeline().setFocus(Qt::TabFocusReason);
  const auto start = ticker().shown()->index;
  QTest::keyClick(&timeline(), Qt::Key_Right);
  turn();
  EXPECT_EQ(ticker().shown()->index, start + 1);
  QTest::keyClick(&timeline(), Qt::Key_Left, Qt::ShiftModifier);
  turn();
  EXPECT_EQ(ticker().shown()->index, start - 9);
}

TEST_F(TimelineActions, LanesAreRememberedAndZKeysShowAllAndTheRange) {
  widgets::TimelineLanes lanes = timeline().lanes();
  lanes.set_shown(widgets::TimelineLane::Energy, true);
  timeline().setLanes(lanes);
  EXPECT_TRUE(remembered().timelineLanes().contains("Energy"));
  ticker().setRange(1, 1.5);
  turn();
  press(Qt::Key_Z, Qt::ShiftModifier);
  EXPECT_LT(timeline().axis().span_s, 0.6);
  press(Qt::Key_Z);
  EXPECT_FALSE(timeline().viewport().is_partial());
}

}  // namespace
}  // namespace abrazo::app::timeline_actions_test
