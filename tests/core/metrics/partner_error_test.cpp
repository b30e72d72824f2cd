#include "core/metrics/partner_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::partner_error_test {
namespace {

/// Someone who sways, nods and walks, as a function of time.
Pose dancing(double t) {
  Pose pose = test::bent(test::standing_pose(), joints::LowerBack, 0.3 * std::sin(2.1 * t), {0, 0, 1});
  pose = test::bent(pose, joints::left_shoulder, 0.5 * std::sin(5.3 * t + 1), {1, 0, 0});
  return test::moved(pose, 0.4 * std::sin(1.3 * t), {0.3 * t, 0, 0.1 * std::sin(3.7 * t)});
}

std::vector<Pose> dance(double fps, double late_s) {
  const int frames = static_cast<int>(10 * fps);
  std::vector<Pose> poses;
  poses.reserve(static_cast<std::size_t>(frames));
  for (int frame = 0; frame < frames; ++frame) poses.push_back(dancing(frame / fps - late_s));
  return poses;
}

TEST(PartnerError, IsTheMeanDistanceOfJoints) {
  const Pose pose = test::standing_pose();
  EXPECT_EQ(mean_joint_distance(pose, pose), 0);
  EXPECT_NEAR(mean_joint_distance(pose, test::moved(pose, 0, {0.03, 0, 0.04})), 0.05, 1e-12);
  Pose one_joint = pose;
  one_joint(joints::left_hand, 0) += 0.5;
  EXPECT_NEAR(mean_joint_distance(pose, one_joint), 0.5 / 25, 1e-12);
}

TEST(Lag, IsTheShiftOfAMotionThatComesLater) {
  for (const double fps : {60.0, 30.0, 15.0})
    for (const double late_s : {0.137, 0.0, 0.25, 0.021, -0.18}) {
      const Lag lag = measure_lag(dance(fps, 0), dance(fps, late_s), fps);
      EXPECT_NEAR(lag.shift_s, late_s, 0.04 / fps) << "a twenty-fifth of a frame, at " << fps;
      EXPECT_GT(lag.correlation, 0.99);
      EXPECT_LE(lag.correlation, 1);
    }
}

TEST(Lag, OfAFollowerWithOtherSizeElsewhereIsTheSame) {
  std::vector<Pose> follower;
  for (const Pose& pose : dance(60, 0.1)) follower.push_back(test::moved(0.8 * pose, 0, {4, 0, 2}));
  EXPECT_NEAR(measure_lag(dance(60, 0), follower, 60).shift_s, 0.1, 0.001);
}

TEST(Lag, DoesNotChangeWhenTheSceneTurns) {
  const auto turned = [](std::vector<Pose> poses) {
    for (Pose& pose : poses) pose = test::moved(pose, 1.0, {1, 0, 1});
    return poses;
  };
  const std::vector<Pose> leader = test::swinging_take("swing", 300, 6).a.poses;
  const std::vector<Pose> follower = test::swinging_take("swing", 300, 6).b.poses;
  const Lag here = measure_lag(leader, follower, 60);
  const Lag there = measure_lag(turned(leader), turned(follower), 60);
  EXPECT_NEAR(here.shift_s, there.shift_s, 1e-9);
  EXPECT_NEAR(here.correlation, there.correlation, 1e-9);
}

TEST(Lag, BeyondTheLongestIsLeftAtTheRangesEnd) {
  EXPECT_NEAR(measure_lag(dance(60, 0), dance(60, 0.3), 60, 0.2).shift_s, 0.2, 1e-9);
  EXPECT_NEAR(measure_lag(dance(60, 0), dance(60, 0.3), 60, 0.4).shift_s, 0.3, 0.001);
}

TEST(Lag, MerelyGoingTheSameWaySaysNothing) {
  std::vector<Pose> straight;
  straight.reserve(200);
  for (int frame = 0; frame < 200; ++frame)
    straight.push_back(test::moved(test::standing_pose(), 0, {0.01 * frame, 0, 0}));
  const Lag lag = measure_lag(straight, straight, 60);
  EXPECT_EQ(lag.shift_s, 0);
  EXPECT_EQ(lag.correlation, 0);
}

TEST(Lag, OfOppositeMotionsCorrelatesBadly) {
  std::vector<Pose> opposite = dance(60, 0);
  for (Pose& pose : opposite) pose *= -1;
  EXPECT_LT(measure_lag(dance(60, 0), opposite, 60, 0.1).correlation, 0);
}

TEST(Lag, OfTooFewFramesIsNothing) {
  EXPECT_EQ(measure_lag({}, {}, 60).correlation, 0);
  const std::vector<Pose> one(1, test::standing_pose());
  EXPECT_EQ(measure_lag(one, one, 60).shift_s, 0);
}

TEST(Lag, NeedsMotionsOfOneLength) {
  EXPECT_THROW(measure_lag(dance(60, 0), dance(30, 0), 60), std::invalid_argument);
  EXPECT_THROW(measure_lag({}, {}, 0), std::invalid_argument);
  EXPECT_THROW(measure_lag({}, {}, 60, -1), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::partner_error_test
