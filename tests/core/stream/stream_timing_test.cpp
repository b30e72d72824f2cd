#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/stream/receive/frame_order.hpp"
#include "core/stream/receive/jitter_buffer.hpp"
#include "core/stream/receive/sender_clock.hpp"
#include "core/stream/receive/stream_meter.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::stream_timing_test {
namespace {

using Kind = FrameOrder::Kind;

/// Frames of a sender at 100 Hz whose content is its counter.
class CountingSender {
 public:
  Kind send(std::int64_t counter) { return send(counter, static_cast<std::uint64_t>(counter)); }
  Kind send(std::int64_t counter, std::uint64_t content) {
    now_s_ += 0.01;
    return order.place({counter, {}, content, now_s_}).kind;
  }
  void wait(double seconds) { now_s_ += seconds; }
  FrameOrder order;

 private:
  double now_s_ = 0;
};

TEST(FrameOrder, CountsGapsOfTheCounterAsLost) {
  CountingSender sender;
  for (const int counter : {0, 1, 2, 5, 6}) EXPECT_EQ(sender.send(counter), Kind::Next);
  EXPECT_EQ(sender.order.lost(), 2U);
}

TEST(FrameOrder, WhatComesAfterItsSuccessorWasNotLost) {
  CountingSender sender;
  for (const int counter : {0, 1, 4}) sender.send(counter);
  EXPECT_EQ(sender.order.lost(), 2U);
  EXPECT_EQ(sender.send(2), Kind::Earlier);
  EXPECT_EQ(sender.order.lost(), 1U);
  EXPECT_EQ(sender.send(2), Kind::Repeated);
  EXPECT_EQ(sender.order.lost(), 1U);
}

TEST(FrameOrder, ASenderThatCountsInTwosLosesNothing) {
  CountingSender sender;
  for (int i = 0; i < 200; ++i) sender.send(2 * i);
  EXPECT_EQ(sender.order.lost(), 0U);
  sender.send(2 * 202);
  EXPECT_EQ(sender.order.lost(), 2U) << "200 and 201 of the frames in twos";
}

TEST(FrameOrder, RecognisesASenderThatBeganAnewAfterThreeFrames) {
  CountingSender sender;
  for (int i = 1000; i < 1300; ++i) sender.send(i);
  EXPECT_EQ(sender.send(0, 7), Kind::Stray);
  EXPECT_EQ(sender.send(1, 8), Kind::Stray);
  EXPECT_EQ(sender.send(2, 9), Kind::Restarted);
  EXPECT_EQ(sender.send(3, 10), Kind::Next);
  EXPECT_EQ(sender.order.lost(), 0U);
}

TEST(FrameOrder, RecognisesARestartAlsoWhenTheSameMotionBeginsAgain) {
  CountingSender sender;
  for (int i = 0; i < 100; ++i) sender.send(i);
  sender.wait(0.5);
  EXPECT_EQ(sender.send(0), Kind::Stray) << "the same frame, but more than 0.75 s later";
  sender.send(1);
  EXPECT_EQ(sender.send(2), Kind::Restarted);
}

TEST(FrameOrder, ASingleOldFrameIsNoRestart) {
  CountingSender sender;
  for (int i = 1000; i < 1300; ++i) sender.send(i);
  EXPECT_EQ(sender.send(3, 7), Kind::Stray);
  EXPECT_EQ(sender.send(1300), Kind::Next);
  EXPECT_EQ(sender.send(4, 7), Kind::Stray);
  EXPECT_EQ(sender.send(1301), Kind::Next);
  EXPECT_EQ(sender.send(5, 7), Kind::Stray) << "two senders in one never take turns in restarting";
}

TEST(FrameOrder, AnImpossibleLeapOfTheCounterIsNoLoss) {
  CountingSender sender;
  sender.send(1);
  sender.send(2);
  EXPECT_EQ(sender.send(2'000'000'000), Kind::Restarted);
  EXPECT_EQ(sender.order.lost(), 0U);
  sender.send(3);
  sender.send(4);
  EXPECT_EQ(sender.send(5), Kind::Restarted) << "and one broken number does not last";
}

TEST(FrameOrder, WithoutACounterGoesByTheSendersTime) {
  FrameOrder order;
  const auto at = [&](double time_s, std::uint64_t content) {
    return order.place({{}, time_s, content, time_s}).kind;
  };
  EXPECT_EQ(at(0.00, 1), Kind::Next);
  EXPECT_EQ(at(0.02, 3), Kind::Next);
  EXPECT_EQ(at(0.01, 2), Kind::Earlier);
  EXPECT_EQ(at(0.02, 3), Kind::Repeated);
  EXPECT_EQ(at(0.02, 4), Kind::Next) << "a time that is too coarse tells nothing of the order";
}

TEST(FrameOrder, WithoutAnythingTakesFramesAsTheyCome) {
  FrameOrder order;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(order.place({{}, {}, 1, 0.01 * i}).kind, Kind::Next);
}

TEST(FrameOrder, AFrameWithoutTheTimeThatOthersHaveIsNoRestart) {
  FrameOrder order;
  SequencePlace before;
  const auto is_next = [&](std::optional<double> time_s, std::uint64_t content, double arrived_s) {
    const FrameOrder::Placed placed = order.place({{}, time_s, content, arrived_s});
    const bool ascends = placed.place > before;
    before = placed.place;
    return placed.kind == Kind::Next && ascends;
  };
  EXPECT_TRUE(is_next({}, 1, 0.00)) << "a receiver that began in the middle of a frame";
  EXPECT_TRUE(is_next(5.00, 2, 0.01));
  EXPECT_TRUE(is_next({}, 3, 0.02)) << "cut in two by a silence: its time is in the second half";
  EXPECT_TRUE(is_next(5.02, 4, 0.03));
  EXPECT_TRUE(is_next(5.03, 5, 0.04));
}

TEST(SenderClock, TheLeastDelayedPacketGivesTheOffset) {
  SenderClock clock;
  // Sent every 10 ms on a clock that began 100 s before ours; the network takes 5 ms and up to 20 ms more.
  for (int i = 0; i < 100; ++i) {
    const double sent_s = 100 + 0.01 * i;
    clock.take(sent_s, 0.01 * i + 0.005 + (i % 7 == 0 ? 0.0 : 0.003 * (i % 7)));
  }
  EXPECT_NEAR(*clock.session_time(100.5), 0.505, 1e-12);
}

TEST(SenderClock, FollowsAClockThatDrifts) {
  SenderClock clock;
  constexpr double fast = 1.001;  // a second a quarter of an hour
  double worst_s = 0;
  for (int i = 0; i < 6000; ++i) {
    const double now_s = 0.01 * i;
    EXPECT_FALSE(clock.take(fast * now_s, now_s));
    worst_s = std::max(worst_s, std::abs(*clock.session_time(fast * now_s) - now_s));
  }
  EXPECT_LT(worst_s, 0.0021) << "at most the drift within the window";
}

TEST(SenderClock, SaysWhenItWasSetForwardsAndBackwards) {
  SenderClock clock;
  EXPECT_FALSE(clock.take(10.0, 0.0));
  EXPECT_FALSE(clock.take(10.1, 0.1));
  EXPECT_TRUE(clock.take(15.2, 0.2));
  EXPECT_NEAR(*clock.session_time(15.2), 0.2, 1e-9);
  EXPECT_TRUE(clock.take(3.3, 0.3));
  EXPECT_NEAR(*clock.session_time(3.3), 0.3, 1e-9);
}

TEST(SenderClock, ANetworkThatStallsIsNoJump) {
  SenderClock clock;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(clock.take(0.01 * i, 0.01 * i));
  // 0.8 s of packets come at once.
  for (int i = 100; i < 180; ++i) EXPECT_FALSE(clock.take(0.01 * i, 1.8)) << i;
  EXPECT_FALSE(clock.take(1.8, 1.8));
  EXPECT_NEAR(*clock.session_time(1.8), 1.8, 1e-12);
}

TEST(SenderClock, AClockThatStoodStillStaysBehind) {
  SenderClock clock;
  for (int i = 0; i < 100; ++i) clock.take(0.01 * i, 0.01 * i);
  int jumps = 0;
  for (int i = 100; i < 300; ++i) jumps += clock.take(0.01 * i, 0.01 * i + 0.5) ? 1 : 0;
  EXPECT_EQ(jumps, 1);
  EXPECT_NEAR(*clock.session_time(3.0), 3.5, 1e-9);
}

// Seconds since 1970, or since a computer was started some days ago, in a 32-bit float.
TEST(SenderClock, ATimeTooCoarseForItsFramesIsInDoubt) {
  for (const double since_s : {1.7e9, 3.0 * 24 * 3600}) {
    SenderClock clock;
    for (int i = 0; i < 300; ++i) {
      EXPECT_FALSE(clock.take(static_cast<float>(since_s + i / 60.0), i / 60.0));
      EXPECT_EQ(clock.doubt(), SenderClock::Doubt::Coarse);
      EXPECT_FALSE(clock.session_time(since_s));
    }
  }
  SenderClock hours;
  for (int i = 0; i < 300; ++i) EXPECT_FALSE(hours.take(static_cast<float>(8 * 3600 + i / 60.0), i / 60.0));
  EXPECT_EQ(hours.doubt(), SenderClock::Doubt::None) << "steps of 2 ms";
}

TEST(SenderClock, ATimeThatStandsIsInDoubtAndProvesItselfAnew) {
  SenderClock clock;
  for (int i = 0; i < 300; ++i)
    EXPECT_FALSE(clock.take(0, i / 60.0)) << "no jump of a clock that is not used";
  EXPECT_EQ(clock.doubt(), SenderClock::Doubt::Stands);
  double used_from_s = 0;
  for (int i = 301; i < 600; ++i) {
    clock.take(100 + i / 60.0 + 0.0001, i / 60.0);
    if (used_from_s == 0 && clock.doubt() == SenderClock::Doubt::None) used_from_s = i / 60.0;
  }
  EXPECT_NEAR(used_from_s - 299 / 60.0, SenderClock::proof_s, 0.02);
}

// Milliseconds, or a count of frames, in place of seconds.
TEST(SenderClock, ATimeThatDoesNotCountSecondsIsInDoubt) {
  for (const double factor : {1000.0, 60.0, 0.5}) {
    SenderClock clock;
    int jumps = 0;
    for (int i = 0; i < 1200; ++i) jumps += clock.take(factor * (7.003 + i / 60.0), i / 60.0) ? 1 : 0;
    EXPECT_EQ(clock.doubt(), SenderClock::Doubt::Jumps) << factor;
    EXPECT_LE(jumps, SenderClock::most_jumps) << factor;
  }
}

JitterBuffer::Entry entry(double number, double sent_s) {
  JitterBuffer::Entry made;
  made.place = {0, number, static_cast<std::uint64_t>(number)};
  made.sent_s = sent_s;
  made.pose.frame = static_cast<std::int64_t>(number);
  return made;
}

std::vector<std::int64_t> all_due(JitterBuffer& buffer, JitterBuffer::Cursor& cursor, double now_s) {
  std::vector<std::int64_t> frames;
  while (const auto due = buffer.due_after(cursor, now_s)) {
    frames.push_back(due->entry->pose.frame);
    cursor.next = due->number + 1;
  }
  return frames;
}

TEST(JitterBuffer, HoldsBackAndPutsInOrder) {
  JitterBuffer buffer(0.05);
  JitterBuffer::Cursor cursor;
  EXPECT_EQ(buffer.push(entry(1, 1.00), 1.00), JitterBuffer::Fate::Taken);
  EXPECT_EQ(buffer.push(entry(3, 1.02), 1.02), JitterBuffer::Fate::Taken);
  EXPECT_EQ(buffer.push(entry(2, 1.01), 1.03), JitterBuffer::Fate::Reordered);
  EXPECT_TRUE(all_due(buffer, cursor, 1.049).empty());
  EXPECT_DOUBLE_EQ(*buffer.next_due_s(cursor), 1.05);
  EXPECT_EQ(all_due(buffer, cursor, 1.065), (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(all_due(buffer, cursor, 1.07), (std::vector<std::int64_t>{3}));
}

TEST(JitterBuffer, LeavesOutWhatComesAfterANewerOneWasDue) {
  JitterBuffer buffer(0.05);
  buffer.push(entry(1, 1.00), 1.00);
  buffer.push(entry(3, 1.02), 1.02);
  EXPECT_EQ(buffer.push(entry(2, 1.01), 1.075), JitterBuffer::Fate::Late);
}

TEST(JitterBuffer, WithoutADelayGivesAtOnceAndNeverGoesBack) {
  JitterBuffer buffer;
  JitterBuffer::Cursor cursor;
  buffer.push(entry(2, 1.00), 1.001);
  EXPECT_EQ(all_due(buffer, cursor, 1.001), (std::vector<std::int64_t>{2}));
  EXPECT_EQ(buffer.push(entry(1, 0.99), 1.002), JitterBuffer::Fate::Late);
  EXPECT_TRUE(all_due(buffer, cursor, 2).empty());
}

TEST(JitterBuffer, MayBeMadeLongerAndShorterInBetween) {
  JitterBuffer buffer(0);
  JitterBuffer::Cursor cursor;
  buffer.push(entry(1, 1.00), 1.00);
  EXPECT_EQ(all_due(buffer, cursor, 1.00).size(), 1U);
  buffer.set_delay(0.1);
  buffer.push(entry(2, 1.01), 1.01);
  EXPECT_TRUE(all_due(buffer, cursor, 1.05).empty());
  buffer.set_delay(0);
  EXPECT_EQ(all_due(buffer, cursor, 1.05), (std::vector<std::int64_t>{2}));
  buffer.set_delay(7);
  EXPECT_EQ(buffer.delay_s(), 0.5);
  buffer.set_delay(std::nan(""));
  EXPECT_EQ(buffer.delay_s(), 0);
}

TEST(JitterBuffer, ForgetsWhatNobodyReads) {
  JitterBuffer buffer;
  JitterBuffer::Cursor cursor;
  for (int i = 0; i < 5000; ++i) buffer.push(entry(i, 0.01 * i), 0.01 * i);
  const auto due = buffer.due_after(cursor, 50);
  ASSERT_TRUE(due);
  EXPECT_GE(due->number, 4850U) << "the reader is told how many it missed";
}

TEST(RecentCount, ForgetsAfterFiveSeconds) {
  RecentCount count;
  count.add(1.0, 3);
  count.add(3.0, 2);
  EXPECT_EQ(count.value(3.0), 5U);
  EXPECT_EQ(count.value(6.6), 2U);
  EXPECT_EQ(count.value(100), 0U);
}

TEST(ArrivalMeter, GivesRateAndPercentilesOfTheLastSecond) {
  ArrivalMeter meter;
  double now_s = 0;
  for (int i = 0; i < 400; ++i) {
    now_s += i % 10 == 0 ? 0.028 : 0.008;  // 100 Hz, every tenth 20 ms late
    meter.add(now_s - 0.001, now_s);
  }
  const ArrivalMeter::Times times = meter.times(now_s);
  EXPECT_NEAR(times.rate_hz, 100, 2);
  EXPECT_NEAR(times.interval_p50_ms, 8, 1e-6);
  EXPECT_NEAR(times.interval_p95_ms, 28, 1e-6);
  EXPECT_NEAR(times.assembly_p50_ms, 1, 1e-6);
  EXPECT_EQ(meter.times(now_s + 1.1).rate_hz, 0) << "nothing comes any more";
}

TEST(ArrivalMeter, TwoArrivalsHaveOneInterval) {
  ArrivalMeter meter;
  for (const double now_s : {1.0, 1.02}) meter.add(now_s - 0.003, now_s);
  const ArrivalMeter::Times times = meter.times(1.02);
  for (const double interval_ms : {times.interval_p50_ms, times.interval_p95_ms})
    EXPECT_NEAR(interval_ms, 20, 1e-6);
  for (const double assembly_ms : {times.assembly_p50_ms, times.assembly_p95_ms})
    EXPECT_NEAR(assembly_ms, 3, 1e-6);
}

TEST(PostureMeter, CountsJumpsThatDoNotComeBackAsJumpsOnly) {
  PostureMeter meter;
  Pose pose = test::standing_pose();
  for (int i = 0; i <= 240; ++i) {
    if (i % 2 == 0) pose.col(0).array() += 1;  // metres, and on the same way
    meter.add(pose, i / 60.0);
  }
  EXPECT_NEAR(meter.posture().jumps, 0.5, 0.03) << "every other frame; the last one weighs 5 %";
  EXPECT_LT(meter.posture().alternating, 0.01);
}

TEST(PostureMeter, SeesWhetherThePoseIsFrozenAndWhetherItAlternates) {
  const Pose here = test::standing_pose();
  const Pose there = test::moved(here, 1, Vec3(2, 0, 0));
  PostureMeter still, two;
  for (int i = 0; i <= 120; ++i) {
    still.add(here, i / 60.0);
    two.add(i % 2 == 0 ? here : there, i / 60.0);
  }
  EXPECT_NEAR(still.frozen_s(), 2, 1e-9);
  EXPECT_LT(still.posture().alternating, 0.01);
  EXPECT_EQ(two.frozen_s(), 0);
  EXPECT_GT(two.posture().alternating, 0.9);
  EXPECT_NEAR(still.posture().bones_height_m, 1.65, 0.15);
  EXPECT_GT(still.posture().hips_above_feet_m, 0.7);
}

}  // namespace
}  // namespace abrazo::stream_timing_test
