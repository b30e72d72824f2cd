#include "core/metrics/bone_lengths.hpp"

#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::bone_lengths_test {
namespace {

TEST(BoneLengths, OfABodysOwnMotionAreRight) {
  const Body body = body_of(test::standing_pose());
  const std::vector<Pose> poses = test::swinging_take("swing", 30, 1).a.poses;
  EXPECT_LT(measure_bone_lengths(poses, body).max, 1e-12);
}

TEST(BoneLengths, ErrorsAreRelative) {
  const Body body = body_of(test::standing_pose());
  const std::vector<Pose> grown(3, 1.02 * test::standing_pose());
  EXPECT_NEAR(measure_bone_lengths(grown, body).mean, 0.02, 1e-12);
  EXPECT_NEAR(measure_bone_lengths(grown, body).max, 0.02, 1e-12);
  const std::vector<Pose> shrunk(3, 0.98 * test::standing_pose());
  EXPECT_NEAR(measure_bone_lengths(shrunk, body).mean, 0.02, 1e-12) << "shorter is an error too";
}

TEST(BoneLengths, OneLongBoneOfOneFrameIsTheMaximumAndASmallMean) {
  std::vector<Pose> poses(2, test::standing_pose());
  const Vec3 forearm = (poses[0].row(joints::left_hand) - poses[0].row(joints::left_wrist)).transpose();
  poses[1].row(joints::left_hand) += 0.12 * forearm.transpose();
  const BoneLengthError error = measure_bone_lengths(poses, body_of(test::standing_pose()));
  EXPECT_NEAR(error.max, 0.12, 1e-12);
  EXPECT_NEAR(error.mean, 0.12 / (2 * bone_count), 1e-12);
}

TEST(BoneLengths, OfNothingAreRight) {
  EXPECT_EQ(measure_bone_lengths({}, body_of(test::standing_pose())).max, 0);
  EXPECT_EQ(measure_bone_lengths({}, body_of(test::standing_pose())).mean, 0);
  EXPECT_EQ(measure_bone_lengths(std::vector<Pose>(1, test::standing_pose()), Body{}).max, 0);
}

}  // namespace
}  // namespace abrazo::bone_lengths_test
