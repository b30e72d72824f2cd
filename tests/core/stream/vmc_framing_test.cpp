#include "core/stream/vmc/vmc_framing.hpp"

#include <gtest/gtest.h>

namespace abrazo::vmc_framing_test {
namespace {

using namespace humanoid;

constexpr double ms = 0.001;

/// Sets some bones one after the other at one time; none of them may close a frame.
void set(VmcFraming& framing, std::initializer_list<int> bones, double at_s) {
  framing.packet_begins();
  for (const int bone : bones) EXPECT_FALSE(framing.bone(bone, at_s)) << bone;
}

TEST(VmcFraming, ClosesWhenABoneComesAgain) {
  VmcFraming framing;
  set(framing, {Hips, Spine, Chest}, 1);
  framing.packet_begins();
  const auto frame = framing.bone(Hips, 1 + 5 * ms);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->first_arrived_s, 1);
  EXPECT_EQ(frame->arrived_s, 1);
  EXPECT_FALSE(frame->time);
  EXPECT_TRUE(framing.is_open());  // the bone belongs to the next one
}

TEST(VmcFraming, ClosesAtANewTimeThatComesLast) {
  VmcFraming framing;
  set(framing, {Hips, Spine}, 1);
  const auto frame = framing.time(5.5, 1 + ms);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->time, 5.5);
  EXPECT_EQ(frame->arrived_s, 1 + ms);
  EXPECT_FALSE(framing.is_open());
}

// From another timer, or between the bones: after three of them frames end as without a T.
TEST(VmcFraming, ATimeBetweenTheBonesOfAFrameIsToldAndDoesNotCutIt) {
  VmcFraming inside, last, first;
  for (int frame = 0; frame < 12; ++frame) {
    const double at_s = 1 + frame / 60.0, time = 5 + frame / 60.0;
    inside.bone(Hips, at_s);
    const auto cut = inside.time(time, at_s);
    inside.bone(Spine, at_s);
    const auto whole = inside.silence(at_s + 10 * ms);
    EXPECT_EQ(cut.has_value(), frame < 3) << frame;
    if (frame >= 3) {
      ASSERT_TRUE(whole) << frame;
      EXPECT_EQ(whole->time, time);
    }
    last.bone(Hips, at_s), last.bone(Spine, at_s), last.time(time, at_s);
    first.time(time, at_s), first.bone(Hips, at_s), first.bone(Spine, at_s);
  }
  EXPECT_TRUE(inside.is_time_inside());
  EXPECT_FALSE(last.is_time_inside());
  EXPECT_FALSE(first.is_time_inside());
  // Now it comes last.
  inside.bone(Hips, 2), inside.bone(Spine, 2), inside.time(7, 2);
  EXPECT_TRUE(inside.silence(2 + VmcFraming::silence_s));
  EXPECT_FALSE(inside.is_time_inside());
}

TEST(VmcFraming, DoesNotCloseAtATimeThatStands) {
  VmcFraming framing;
  EXPECT_FALSE(framing.time(5.5, 1));
  set(framing, {Hips}, 1);
  EXPECT_FALSE(framing.time(5.5, 1 + ms));
}

TEST(VmcFraming, ClosesAtTheEndOfABundleThatBeganWithTime) {
  VmcFraming framing;
  framing.bundle_begins();
  EXPECT_FALSE(framing.time(2, 1));
  set(framing, {Hips, Spine}, 1);
  const auto frame = framing.bundle_ends();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->time, 2);
  EXPECT_TRUE(framing.is_time_first());
}

TEST(VmcFraming, DoesNotCloseAtTheEndOfOtherBundles) {
  VmcFraming framing;
  framing.bundle_begins();
  set(framing, {Hips, Spine}, 1);
  framing.bundle_begins();
  set(framing, {Chest}, 1);
  EXPECT_FALSE(framing.bundle_ends());
  EXPECT_TRUE(framing.time(2, 1));
  EXPECT_FALSE(framing.bundle_ends());
}

TEST(VmcFraming, ClosesAfterEightMillisecondsOfSilence) {
  VmcFraming framing;
  set(framing, {Hips}, 1);
  EXPECT_FALSE(framing.silence(1 + 7.9 * ms));
  EXPECT_TRUE(framing.silence(1 + 8.1 * ms));
  EXPECT_FALSE(framing.silence(2));
}

TEST(VmcFraming, GivesATimeThatComesFirstToTheBonesBehindIt) {
  VmcFraming framing;
  EXPECT_FALSE(framing.time(1, 1));
  set(framing, {Hips, Spine}, 1);
  const auto first = framing.time(2, 1 + 4 * ms);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->time, 1);
  set(framing, {Hips, Spine}, 1 + 4 * ms);
  EXPECT_EQ(framing.silence(2)->time, 2);
}

TEST(VmcFraming, DoesNotTakeTheTimeOfAnEarlierFrameForThatOfTheNext) {
  VmcFraming framing;
  EXPECT_FALSE(framing.time(1, 1));  // of a frame whose bones came before we listened
  set(framing, {Hips, Spine}, 1 + 4.1 * ms);
  EXPECT_EQ(framing.time(1.004, 1 + 4.2 * ms)->time, 1.004);
}

TEST(VmcFraming, GoesOnWhenAPacketComesTwice) {
  VmcFraming framing;
  set(framing, {Hips, Spine, Chest, Neck}, 1);
  EXPECT_TRUE(framing.time(1, 1));
  set(framing, {Hips, Spine}, 2);
  set(framing, {Hips, Spine}, 2 + ms);  // again
  EXPECT_EQ(framing.mixed(), 1u);
  set(framing, {Chest, Neck}, 2 + ms);
  const auto frame = framing.time(2, 2 + ms);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->held, 0);
}

TEST(VmcFraming, GetsUsedToASenderWithFewerBones) {
  VmcFraming framing;
  set(framing, {Hips, Spine, Chest, Neck}, 1);
  EXPECT_TRUE(framing.silence(2));
  set(framing, {Hips, Spine}, 2);
  set(framing, {Hips, Spine}, 2 + ms);
  set(framing, {Hips, Spine}, 2 + 2 * ms);
  framing.packet_begins();
  EXPECT_TRUE(framing.bone(Hips, 2 + 3 * ms));
  EXPECT_FALSE(framing.bone(Spine, 2 + 3 * ms));
  framing.packet_begins();
  EXPECT_TRUE(framing.bone(Hips, 2 + 4 * ms));
}

TEST(VmcFraming, CountsTheBonesThatDidNotCome) {
  VmcFraming framing;
  set(framing, {Hips, Spine, Chest, Neck}, 1);
  EXPECT_EQ(framing.time(1, 1)->held, 0);
  set(framing, {Hips}, 2);
  EXPECT_EQ(framing.time(2, 2)->held, 3);
}

}  // namespace
}  // namespace abrazo::vmc_framing_test
