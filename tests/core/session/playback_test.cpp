#include "core/session/playback.hpp"

#include <gtest/gtest.h>

namespace abrazo {
namespace {

Playback playback(Playback::State state, double cursor_s, double last_s = 10) {
  Playback p;
  p.extend(0, last_s);
  p.state = state;
  p.cursor_s = cursor_s;
  return p;
}

using State = Playback::State;

TEST(Playback, NewFramesMoveOnlyAFollowingCursor) {
  for (const State state : {State::Parked, State::Playing}) {
    Playback p = playback(state, 4);
    p.extend(0, 12);
    EXPECT_EQ(p.cursor_s, 4);
  }
  Playback p = playback(State::Following, 10);
  p.extend(0, 12);
  EXPECT_EQ(p.cursor_s, 12);
}

TEST(Playback, PlayingMovesTheCursorByTimeAndSpeed) {
  Playback p = playback(State::Playing, 2);
  p.speed = 2;
  p.advance(0.5);
  EXPECT_EQ(p.cursor_s, 3);
  p.speed = -1;
  p.advance(0.5);
  EXPECT_EQ(p.cursor_s, 2.5);
}

TEST(Playback, ReachingTheLiveEndFollowsIt) {
  Playback p = playback(State::Playing, 9.9);
  p.advance(0.5);
  EXPECT_EQ(p.state, State::Following);
  EXPECT_EQ(p.cursor_s, 10);
}

TEST(Playback, PlayAtTheEndStartsOver) {
  Playback p = playback(State::Parked, 10);
  p.play();
  EXPECT_EQ(p.cursor_s, 0);
  EXPECT_EQ(p.state, State::Playing);
}

TEST(Playback, PausingWhileFollowingParksAtThatInstant) {
  Playback p = playback(State::Following, 10);
  p.toggle();
  p.extend(0, 13);
  EXPECT_EQ(p.state, State::Parked);
  EXPECT_EQ(p.cursor_s, 10);
  EXPECT_EQ(p.behind_live_s(), 3);
}

TEST(Playback, SeekingParksInsideTheRange) {
  Playback p = playback(State::Following, 10);
  p.seek(99);
  EXPECT_EQ(p.cursor_s, 10);
  EXPECT_EQ(p.state, State::Parked);
  p.seek(-1);
  EXPECT_EQ(p.cursor_s, 0);
}

TEST(Playback, EvictionPullsAParkedCursorAlong) {
  Playback p = playback(State::Parked, 1);
  p.extend(3, 20);
  EXPECT_EQ(p.cursor_s, 3);
}

TEST(Playback, LoopingStaysBetweenInAndOut) {
  Playback p = playback(State::Playing, 5.9);
  p.loop = true;
  p.in_s = 4;
  p.out_s = 6;
  p.advance(0.2);
  EXPECT_NEAR(p.cursor_s, 4.1, 1e-12);
  EXPECT_EQ(p.state, State::Playing);
  p.speed = -1;
  p.advance(0.3);
  EXPECT_NEAR(p.cursor_s, 5.8, 1e-12);
}

TEST(Playback, PlayingBackwardsParksAtTheStart) {
  Playback p = playback(State::Playing, 0.1);
  p.speed = -1;
  p.advance(0.5);
  EXPECT_EQ(p.state, State::Parked);
  EXPECT_EQ(p.cursor_s, 0);
}

}  // namespace
}  // namespace abrazo
