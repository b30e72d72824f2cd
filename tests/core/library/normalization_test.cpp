#include "core/library/store/normalization.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::normalization_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-12;  // a few operations on metres

double angle_between(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * pi));
}

/// Both joints of an axis at the same place seen from above, one over the other.
void flatten_axis(Pose& pose, int left, int right) {
  pose.row(left) = pose.row(right);
  pose(left, 1) += 0.2;
}

TEST(Normalization, SomeoneFacingZHasHeadingZeroAndTheLeftAtX) {
  const RootFrame frame = root_frame(test::standing_pose());
  EXPECT_NEAR(frame.heading_rad, 0, rounding);
  EXPECT_GT(test::standing_pose()(joints::left_hip, 0), test::standing_pose()(joints::right_hip, 0));
}

TEST(Normalization, HeadingIsPositiveToTheBodysLeft) {
  // Facing +X means a quarter turn to the left of +Z, whose left is +X.
  const Pose pose = test::moved(test::standing_pose(), pi / 2, Vec3::Zero());
  const Vec3 toes = (pose.row(joints::left_toe_tip) - pose.row(joints::left_ankle)).transpose();
  EXPECT_GT(toes.x(), 0.15);
  EXPECT_NEAR(root_frame(pose).heading_rad, pi / 2, rounding);
}

TEST(Normalization, HeadingFollowsATurnOfTheWholeBody) {
  for (double yaw = -3.1; yaw < 3.2; yaw += 0.1)
    EXPECT_LT(
        angle_between(root_frame(test::moved(test::standing_pose(), yaw, Vec3(1, 0, -2))).heading_rad, yaw),
        rounding);
}

TEST(Normalization, HeadingDoesNotChangeWhenTheBodyIsMoved) {
  std::mt19937 random(3);
  const Pose pose = test::shaken(test::standing_pose(), 0.03, random);
  EXPECT_NEAR(root_frame(pose).heading_rad, root_frame(test::moved(pose, 0, Vec3(5, 1, -7))).heading_rad,
              1e-10);
}

TEST(Normalization, HipsCountForSixTenthsAndShouldersForFour) {
  Pose pose = test::standing_pose();
  // Shoulders a quarter turn to the left of the hips: 0.6 (1, 0) + 0.4 (0, -1) in (x, z), whose heading is
  // atan(0.4 / 0.6).
  const Vec3 middle = 0.5 * (pose.row(joints::left_shoulder) + pose.row(joints::right_shoulder)).transpose();
  pose.row(joints::left_shoulder) = (middle + Vec3(0, 0, -0.3)).transpose();
  pose.row(joints::right_shoulder) = (middle + Vec3(0, 0, 0.3)).transpose();
  EXPECT_NEAR(root_frame(pose).heading_rad, std::atan2(0.4, 0.6), rounding);
}

TEST(Normalization, KeepsThePreviousHeadingWhenTheHipAxisIsShortFromAbove) {
  Pose pose = test::moved(test::standing_pose(), 0.7, Vec3::Zero());
  flatten_axis(pose, joints::left_hip, joints::right_hip);
  EXPECT_DOUBLE_EQ(root_frame(pose, 1.25).heading_rad, 1.25);
}

TEST(Normalization, LetsTheShouldersDecideWhenThereIsNoPreviousHeading) {
  Pose pose = test::moved(test::standing_pose(), 0.7, Vec3::Zero());
  flatten_axis(pose, joints::left_hip, joints::right_hip);
  EXPECT_NEAR(root_frame(pose).heading_rad, 0.7, rounding);
}

TEST(Normalization, LeavesOutAShoulderAxisThatIsShortFromAbove) {
  Pose pose = test::moved(test::standing_pose(), 0.7, Vec3::Zero());
  flatten_axis(pose, joints::left_shoulder, joints::right_shoulder);
  EXPECT_NEAR(root_frame(pose, 2.0).heading_rad, 0.7, rounding);
}

TEST(Normalization, PutsTheActiveRootAtTheOriginFacingZ) {
  std::mt19937 random(5);
  const Pose world = test::moved(test::shaken(test::standing_pose(), 0.05, random), -2.1, Vec3(3, 0.1, 4));
  const Pose normalized = to_normalized(world, root_frame(world));
  EXPECT_LT(normalized.row(joints::Root).norm(), rounding);
  EXPECT_NEAR(root_frame(normalized).heading_rad, 0, rounding);
}

TEST(Normalization, IsTheSameWhereverThePairStandsAndFaces) {
  const PairPose pair = test::facing_pair(0.6);
  const Pose active = pair.topRows<joint_count>();
  const Pose passive = pair.bottomRows<joint_count>();
  const Vec3 offset(2, 0, -5);
  const RootFrame here = root_frame(active);
  const RootFrame there = root_frame(test::moved(active, 1.9, offset));
  EXPECT_LT((to_normalized(passive, here) - to_normalized(test::moved(passive, 1.9, offset), there))
                .cwiseAbs()
                .maxCoeff(),
            rounding);
}

TEST(Normalization, ComputesTransposedRotationTimesOffsetForEachJoint) {
  const Pose world = test::moved(test::standing_pose(), 0.4, Vec3(1, 2, 3));
  const RootFrame frame = root_frame(world);
  const Pose normalized = to_normalized(world, frame);
  const double c = std::cos(frame.heading_rad), s = std::sin(frame.heading_rad);
  for (int j = 0; j < joint_count; ++j) {
    const Vec3 offset = world.row(j).transpose() - frame.position;
    // R^T for a turn by h about Y: x' = c x - s z, z' = s x + c z.
    EXPECT_NEAR(normalized(j, 0), c * offset.x() - s * offset.z(), rounding);
    EXPECT_NEAR(normalized(j, 1), offset.y(), rounding);
    EXPECT_NEAR(normalized(j, 2), s * offset.x() + c * offset.z(), rounding);
  }
}

TEST(Normalization, ToWorldTakesItBack) {
  std::mt19937 random(7);
  const Pose world = test::moved(test::shaken(test::standing_pose(), 0.05, random), 2.5, Vec3(-4, 0, 9));
  const RootFrame frame = root_frame(world);
  EXPECT_LT((to_world(to_normalized(world, frame), frame) - world).cwiseAbs().maxCoeff(), rounding);
}

TEST(Normalization, FeaturesAreHeadRightHandLeftHandRightFootLeftFoot) {
  const Pose pose = test::standing_pose();
  const Features features = pose_features(pose);
  const std::array<int, 5> order = {joints::Head, joints::RightHand, joints::LeftHand, joints::RightFoot,
                                    joints::LeftFoot};
  for (int f = 0; f < 5; ++f)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(features(3 * f + axis), pose(order[static_cast<std::size_t>(f)], axis));
}

}  // namespace
}  // namespace abrazo::normalization_test
