#include "widgets/timeline/timeline_viewport.hpp"

#include <gtest/gtest.h>

namespace abrazo::widgets::timeline_viewport_test {
namespace {

using State = Playback::State;

Playback playback(State state, double cursor_s, double last_s) {
  Playback p;
  p.extend(0, last_s);
  p.state = state;
  p.cursor_s = cursor_s;
  return p;
}

/// Following 100 seconds, of which it shows the last 35.
TimelineViewport following() {
  TimelineViewport viewport;
  viewport.set_place(100, 700);
  viewport.show(playback(State::Following, 100, 100));
  return viewport;
}

TEST(TimelineViewport, GoesAlongWithTheLiveEnd) {
  TimelineViewport viewport = following();
  const double before = viewport.axis().first_s;
  viewport.show(playback(State::Following, 105, 105));
  EXPECT_NEAR(viewport.axis().first_s, before + 5, 1e-9);
}

TEST(TimelineViewport, WhatComesInDoesNotMoveAParkedView) {
  TimelineViewport viewport = following();
  viewport.show(playback(State::Parked, 90, 100));
  const double before = viewport.axis().first_s;
  for (int second = 0; second < 50; ++second) viewport.show(playback(State::Parked, 90, 100 + second));
  EXPECT_EQ(viewport.axis().first_s, before);
}

TEST(TimelineViewport, MovedAwayByHandItStaysAlsoWhileFollowing) {
  TimelineViewport viewport = following();
  viewport.pan(-50);
  EXPECT_TRUE(viewport.is_detached());
  const double before = viewport.axis().first_s;
  viewport.show(playback(State::Following, 130, 130));
  EXPECT_EQ(viewport.axis().first_s, before);
  viewport.pan(90);
  EXPECT_FALSE(viewport.is_detached()) << "the live end is in view again";
}

TEST(TimelineViewport, AStepOfTheCursorBringsTheViewBackToIt) {
  TimelineViewport viewport = following();
  viewport.show(playback(State::Parked, 90, 100));
  viewport.pan(-80);
  viewport.show(playback(State::Parked, 90, 101));
  EXPECT_LT(viewport.axis().last_s(), 90);
  viewport.show(playback(State::Parked, 89.9, 101));
  EXPECT_GE(viewport.axis().last_s(), 89.9);
}

TEST(TimelineViewport, ACursorThatIsDraggedDoesNotMoveTheViewUnderThePointer) {
  TimelineViewport viewport = following();
  viewport.show(playback(State::Parked, 90, 100), true);
  const double before = viewport.axis().first_s;
  viewport.show(playback(State::Parked, 66, 100), true);
  EXPECT_EQ(viewport.axis().first_s, before);
}

TEST(TimelineViewport, ZoomsAroundThePointerOrTheLiveEnd) {
  TimelineViewport viewport = following();
  const double live_px = viewport.axis().x(100);
  viewport.zoom(0.5, 80);
  EXPECT_NEAR(viewport.axis().x(100), live_px, 5);
  viewport.show(playback(State::Parked, 95, 100));
  const double pointer_px = viewport.axis().x(93);
  viewport.zoom(0.5, 93);
  EXPECT_NEAR(viewport.axis().x(93), pointer_px, 1e-9);
}

TEST(TimelineViewport, ShowingAllGoesOnDoingSoUntilMoved) {
  TimelineViewport viewport = following();
  EXPECT_TRUE(viewport.is_partial());
  viewport.show_all();
  EXPECT_FALSE(viewport.is_partial());
  viewport.show(playback(State::Following, 500, 500));
  EXPECT_FALSE(viewport.is_partial());
  viewport.zoom(0.5, 400);
  viewport.show(playback(State::Following, 600, 600));
  EXPECT_TRUE(viewport.is_partial());
}

TEST(TimelineViewport, ShowsARangeWithRoomAtBothEnds) {
  TimelineViewport viewport = following();
  viewport.show(playback(State::Parked, 30, 100));
  viewport.show_range(20, 40);
  EXPECT_LT(viewport.axis().first_s, 20);
  EXPECT_GT(viewport.axis().last_s(), 40);
  EXPECT_LT(viewport.axis().span_s, 22);
  viewport.show_range(50, 50);
  EXPECT_LT(viewport.axis().first_s, 20) << "an empty range shows nothing else";
}

TEST(TimelineViewport, CannotBeMovedToWhereThereIsNothing) {
  TimelineViewport viewport = following();
  viewport.pan(1e6);
  EXPECT_LT(viewport.axis().first_s, 100);
  viewport.pan(-1e6);
  EXPECT_GT(viewport.axis().last_s(), 0);
}

}  // namespace
}  // namespace abrazo::widgets::timeline_viewport_test
