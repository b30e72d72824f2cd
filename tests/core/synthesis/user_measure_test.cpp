#include "core/synthesis/step/user_measure.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies.hpp"

namespace abrazo::user_measure_test {
namespace {

TEST(UserMeasure, ABadFirstPoseIsOutweighed) {
  const Pose pose = test::standing_pose();
  std::mt19937 random(7);
  UserMeasure measure;
  measure.look_at(1.3 * pose, 0);
  for (int frame = 0; frame < 170; ++frame) measure.look_at(test::shaken(pose, 0.002, random), 1.0 / 60);
  EXPECT_NEAR(measure.body()->leg_length(), body_of(pose).leg_length(), 0.01);
}

TEST(UserMeasure, StaysAsItIsAfterTheFirstSeconds) {
  const Pose pose = test::standing_pose();
  UserMeasure measure;
  for (int frame = 0; frame < 200; ++frame) measure.look_at(pose, 1.0 / 60);
  EXPECT_FALSE(measure.look_at(1.2 * pose, 1.0 / 60));
}

TEST(UserMeasure, WhatIsGivenIsKept) {
  const Body given = body_of(test::standing_pose());
  UserMeasure measure(given);
  EXPECT_FALSE(measure.look_at(1.2 * test::standing_pose(), 0));
  EXPECT_EQ(measure.body()->bone_lengths, given.bone_lengths);
}

TEST(UserMeasure, WhatIsNoPersonIsNotMeasured) {
  UserMeasure measure;
  EXPECT_FALSE(measure.look_at(Pose::Zero(), 0));
  EXPECT_FALSE(measure.look_at(100 * test::standing_pose(), 0));
  EXPECT_FALSE(measure.body());
}

}  // namespace
}  // namespace abrazo::user_measure_test
