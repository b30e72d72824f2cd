#include "widgets/timeline/timeline_axis.hpp"

#include <gtest/gtest.h>

namespace abrazo::widgets::timeline_axis_test {
namespace {

TimelineAxis axis() {
  return {100, 700, 10, 35};
}  // 20 pixels a second

TEST(TimelineAxis, TakesSecondsToPixelsAndBack) {
  EXPECT_DOUBLE_EQ(axis().x(10), 100);
  EXPECT_DOUBLE_EQ(axis().x(45), 800);
  EXPECT_DOUBLE_EQ(axis().x(12), 140);
  for (const double time : {-3.0, 10.0, 17.25, 44.0}) EXPECT_NEAR(axis().time(axis().x(time)), time, 1e-12);
}

TEST(TimelineAxis, ZoomLeavesTheFixedTimeWhereItIs) {
  TimelineAxis zoomed = axis();
  const double before = zoomed.x(20);
  zoomed.zoom(0.5, 20);
  EXPECT_NEAR(zoomed.x(20), before, 1e-9);
  EXPECT_DOUBLE_EQ(zoomed.span_s, 17.5);
}

TEST(TimelineAxis, ZoomStopsAtItsLimitsWithoutMovingTheFixedTime) {
  TimelineAxis zoomed = axis();
  const double before = zoomed.x(20);
  for (int i = 0; i < 100; ++i) zoomed.zoom(0.5, 20);
  EXPECT_DOUBLE_EQ(zoomed.span_s, TimelineAxis::shortest_s);
  EXPECT_NEAR(zoomed.x(20), before, 1e-6);
}

TEST(TimelineAxis, FollowingShowsTheBeginningWhileAllFits) {
  TimelineAxis following = axis();
  following.follow(0, 12);
  EXPECT_DOUBLE_EQ(following.first_s, 0);
}

TEST(TimelineAxis, FollowingKeepsTheLiveEndInsideTheRightEdge) {
  TimelineAxis following = axis();
  following.follow(0, 100);
  EXPECT_LT(following.x(100), following.right_px());
  EXPECT_GT(following.x(100), following.right_px() - 0.05 * following.width_px);
}

TEST(TimelineAxis, RevealingATimeInViewMovesNothing) {
  TimelineAxis shown = axis();
  shown.reveal(20);
  EXPECT_DOUBLE_EQ(shown.first_s, 10);
}

TEST(TimelineAxis, RevealingATimeOutsideBringsItIntoView) {
  for (const double time : {5.0, 50.0, 900.0}) {
    TimelineAxis shown = axis();
    shown.reveal(time);
    EXPECT_GE(shown.x(time), shown.left_px);
    EXPECT_LE(shown.x(time), shown.right_px());
  }
}

TEST(TimelineAxis, TicksAreRoundAndFarEnoughApart) {
  const auto ticks = axis().ticks(90);
  ASSERT_EQ(ticks.size(), 8u);  // 90 px are 4.5 s, so every 5 s from 10 to 45
  EXPECT_DOUBLE_EQ(ticks.front(), 10);
  EXPECT_DOUBLE_EQ(ticks.back(), 45);
}

}  // namespace
}  // namespace abrazo::widgets::timeline_axis_test
