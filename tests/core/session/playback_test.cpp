#include "core/session/frames/playback.hpp"

#include <gtest/gtest.h>

namespace abrazo::playback_test {
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

TEST(Playback, WhatHasAnEndStopsThere) {
  Playback clip;
  clip.is_live = false;
  clip.extend(0, 10);
  clip.seek(9.5);
  clip.play();
  clip.advance(2);
  EXPECT_EQ(clip.state, Playback::State::Parked);
  EXPECT_EQ(clip.cursor_s, 10);
  clip.seek(3);
  clip.follow();
  EXPECT_EQ(clip.state, Playback::State::Parked) << "nothing comes that could be followed";
  EXPECT_EQ(clip.cursor_s, 10);
  clip.loop = true;
  clip.play();
  clip.advance(12);
  EXPECT_EQ(clip.state, Playback::State::Playing) << "a loop is a choice";
  EXPECT_NEAR(clip.cursor_s, 2, 1e-9);
}

TEST(Playback, InAndOutComeBackAsTheyWereSet) {
  Playback p = playback(State::Parked, 4);
  p.set_in();
  const Playback::Ends only_in = p.ends();
  EXPECT_EQ(only_in, (Playback::Ends{4, {}}));
  p.set_range(1, 3);
  p.set_ends(only_in);
  EXPECT_EQ(p.range(), (Playback::Range{4, 10}));
  p.extend(0, 20);
  EXPECT_EQ(p.range(), (Playback::Range{4, 20})) << "an end that is not set lies at the end";
  p.set_ends({});
  EXPECT_FALSE(p.range());
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
  p.set_range(6, 4);
  p.advance(0.2);
  EXPECT_NEAR(p.cursor_s, 4.1, 1e-12);
  EXPECT_EQ(p.state, State::Playing);
  p.speed = -1;
  p.advance(0.3);
  EXPECT_NEAR(p.cursor_s, 5.8, 1e-12);
}

TEST(Playback, LoopingWithoutARangeStartsAllOverInsteadOfFollowing) {
  Playback p = playback(State::Playing, 9.9);
  p.loop = true;
  p.advance(0.3);
  EXPECT_NEAR(p.cursor_s, 0.2, 1e-12);
  EXPECT_EQ(p.state, State::Playing);
}

TEST(Playback, BackAndForthTurnsAtBothEnds) {
  Playback p = playback(State::Playing, 5.9);
  p.loop = true;
  p.repeat = Playback::Repeat::PingPong;
  p.set_range(4, 6);
  p.advance(0.3);
  EXPECT_NEAR(p.cursor_s, 5.8, 1e-12);
  EXPECT_EQ(p.speed, -1);
  p.advance(2);
  EXPECT_NEAR(p.cursor_s, 4.2, 1e-12);
  EXPECT_EQ(p.speed, 1);
  p.advance(4);  // there and back
  EXPECT_NEAR(p.cursor_s, 4.2, 1e-12);
  EXPECT_EQ(p.speed, 1);
}

TEST(Playback, PlayFromOutsideALoopedRangeStartsInIt) {
  Playback p = playback(State::Parked, 9);
  p.loop = true;
  p.set_range(4, 6);
  p.play();
  EXPECT_EQ(p.cursor_s, 4);
}

TEST(Playback, AnOpenEndOfTheRangeGoesAlongWithWhatThereIs) {
  Playback p = playback(State::Parked, 4);
  p.set_in();
  EXPECT_EQ(p.range(), (Playback::Range{4, 10}));
  p.extend(0, 15);
  EXPECT_EQ(p.range(), (Playback::Range{4, 15}));
  p.seek(8);
  p.set_out();
  p.extend(0, 20);
  EXPECT_EQ(p.range(), (Playback::Range{4, 8}));
  p.clear_in();
  EXPECT_EQ(p.range(), (Playback::Range{0, 8}));
  p.clear_out();
  EXPECT_FALSE(p.range());
}

TEST(Playback, AnInBehindTheOutGivesTheOutUp) {
  Playback p = playback(State::Parked, 9);
  p.set_range(4, 6);
  p.set_in();
  EXPECT_EQ(p.range(), (Playback::Range{9, 10}));
  p.seek(2);
  p.set_out();
  EXPECT_EQ(p.range(), (Playback::Range{0, 2}));
}

TEST(Playback, ARangeThatEndsWhereItBeginsIsNone) {
  Playback out = playback(State::Parked, 4);
  out.set_in();
  out.set_out();
  EXPECT_EQ(out.range(), (Playback::Range{0, 4})) << "the in is given up";
  Playback in = playback(State::Parked, 4);
  in.set_out();
  in.set_in();
  EXPECT_EQ(in.range(), (Playback::Range{4, 10})) << "the out is given up";
}

TEST(Playback, WhatWasEvictedOfTheRangeIsGone) {
  Playback p = playback(State::Playing, 9);
  p.loop = true;
  p.set_range(4, 6);
  p.extend(5, 12);
  EXPECT_EQ(p.range(), (Playback::Range{5, 6}));
  p.extend(7, 12);
  EXPECT_FALSE(p.range());
}

TEST(Playback, ShuttlingDoublesUpToEightInEitherDirectionAndStops) {
  Playback p = playback(State::Parked, 5);
  for (const double speed : {-1.0, -2.0, -4.0, -8.0, -8.0}) {
    p.shuttle(-1);
    EXPECT_EQ(p.speed, speed);
  }
  p.shuttle(1);
  EXPECT_EQ(p.speed, 1) << "turning around starts slowly";
  p.shuttle(1);
  EXPECT_EQ(p.speed, 2);
  p.shuttle(0);
  EXPECT_EQ(p.state, State::Parked);
  p.shuttle(1);
  EXPECT_EQ(p.speed, 1);
  EXPECT_EQ(p.state, State::Playing);
}

TEST(Playback, AfterShuttlingBackPlayGoesOnwards) {
  Playback p = playback(State::Parked, 5);
  p.shuttle(-1);
  p.toggle();
  p.toggle();
  EXPECT_EQ(p.state, State::Playing);
  EXPECT_EQ(p.speed, 1);
}

TEST(Playback, ShuttlingOnAtTheLiveEndStaysThere) {
  Playback p = playback(State::Following, 10);
  p.shuttle(1);
  EXPECT_EQ(p.state, State::Following);
  p.shuttle(-1);
  EXPECT_EQ(p.state, State::Playing);
  EXPECT_EQ(p.cursor_s, 10);
  p.advance(1);
  EXPECT_EQ(p.cursor_s, 9);
}

TEST(Playback, SpeedGoesThroughTheUsualOnesAndKeepsItsDirection) {
  Playback p = playback(State::Playing, 5);
  p.change_speed(1);
  EXPECT_EQ(p.speed, 2);
  p.change_speed(-3);
  EXPECT_EQ(p.speed, 0.25);
  p.set_speed(0.3);
  p.change_speed(1);
  EXPECT_EQ(p.speed, 0.5) << "from between two to the next";
  p.speed = -1;
  p.change_speed(99);
  EXPECT_EQ(p.speed, -10);
  p.set_speed(1e-9);
  EXPECT_EQ(p.speed, -0.01);
}

TEST(Playback, AtTheLiveEndSlowerFallsBehindAndFasterIsImpossible) {
  Playback p = playback(State::Following, 10);
  p.change_speed(1);
  EXPECT_EQ(p.speed, 1);
  EXPECT_EQ(p.state, State::Following);
  p.change_speed(-1);
  EXPECT_EQ(p.speed, 0.5);
  EXPECT_EQ(p.state, State::Playing);
  p.advance(1);
  EXPECT_EQ(p.cursor_s, 10) << "waits for more";
  EXPECT_EQ(p.state, State::Playing);
  p.extend(0, 12);
  p.advance(1);
  EXPECT_EQ(p.cursor_s, 10.5);
}

TEST(Playback, AnotherSpeedDoesNotSetAParkedCursorGoing) {
  Playback p = playback(State::Parked, 5);
  p.set_speed(0.5);
  EXPECT_EQ(p.speed, 0.5);
  EXPECT_EQ(p.state, State::Parked);
}

TEST(Playback, CatchingUpWithTheLiveEndFollowsItAtNormalSpeed) {
  Playback p = playback(State::Playing, 8);
  p.speed = 4;
  p.advance(1);
  EXPECT_EQ(p.state, State::Following);
  EXPECT_EQ(p.speed, 1);
}

TEST(Playback, PlayingEveryFrameGoesNoFartherThanTheNext) {
  Playback p = playback(State::Playing, 5);
  p.speed = 2;
  EXPECT_NEAR(p.advance_to_next(0.5, 5.1), 0.05, 1e-12);
  EXPECT_EQ(p.cursor_s, 5.1);
  EXPECT_EQ(p.advance_to_next(0.01, 5.2), 0.01) << "and no faster than asked";
  EXPECT_NEAR(p.cursor_s, 5.12, 1e-12);
  p.speed = -1;
  EXPECT_NEAR(p.advance_to_next(0.5, 5.1), 0.02, 1e-12);
  EXPECT_EQ(p.cursor_s, 5.1);
  EXPECT_EQ(p.advance_to_next(0.5, 5.1), 0.5) << "there is no other frame: on to the end";
}

TEST(Playback, OfALongStretchWithoutFramesOnlyTheBeginningIsPlayed) {
  Playback p = playback(State::Playing, 3.4);
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 3.4);
  p.advance(0.2);
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 8) << "the next frame";
  p.speed = -1;
  p.advance(0.1);
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 3.5) << "the frame before it stands as long in both directions";
  p.cursor_s = 4.5;
  p.pass_over_gap(3, 5);
  EXPECT_EQ(p.cursor_s, 4.5) << "a gap of two seconds is played";
  p.pause();
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 4.5) << "a parked cursor stays";
}

TEST(Playback, ALoopWithoutAFrameIsNotPlayed) {
  for (const double speed : {1.0, -1.0}) {
    Playback p = playback(State::Playing, 4.5);
    p.loop = true;
    p.set_range(4, 5);
    p.speed = speed;
    p.pass_over_gap(3, 8);
    EXPECT_EQ(p.state, State::Parked);
    EXPECT_EQ(p.cursor_s, 4.5) << "and the cursor does not leave it";
  }
  Playback p = playback(State::Playing, 4.5);
  p.set_range(4, 5);
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 8) << "without Loop the range is no bound";
}

TEST(Playback, ALoopThatEndsInAStretchWithoutFramesStartsOverThere) {
  Playback p = playback(State::Playing, 3.6);
  p.loop = true;
  p.set_range(2, 5);
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 2) << "the frame after the gap is beyond out";
  p.cursor_s = 3.6;
  p.repeat = Playback::Repeat::PingPong;
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 3.5);
  EXPECT_EQ(p.speed, -1);
}

TEST(Playback, ALoopThatBeginsInAStretchWithoutFramesBeginsAtTheNextOne) {
  Playback p = playback(State::Playing, 4);
  p.loop = true;
  p.set_range(4, 9);
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 8);
  p.speed = -1;
  p.cursor_s = 7.9;
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 9) << "backwards the frame before the gap is before in";
  p.cursor_s = 7.9;
  p.repeat = Playback::Repeat::PingPong;
  p.pass_over_gap(3, 8);
  EXPECT_EQ(p.cursor_s, 8);
  EXPECT_EQ(p.speed, 1);
}

TEST(Playback, PlayingBackwardsParksAtTheStart) {
  Playback p = playback(State::Playing, 0.1);
  p.speed = -1;
  p.advance(0.5);
  EXPECT_EQ(p.state, State::Parked);
  EXPECT_EQ(p.cursor_s, 0);
}

}  // namespace
}  // namespace abrazo::playback_test
