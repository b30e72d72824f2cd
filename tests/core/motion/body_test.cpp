#include "core/motion/body/body.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/support/bodies.hpp"

namespace abrazo::body_test {
namespace {

TEST(Body, MeasuresTheBonesOfAPose) {
  const Pose pose = test::standing_pose();
  const Body body = body_of(pose);
  for (int b = 0; b < bone_count; ++b)
    EXPECT_NEAR(body.bone_lengths[static_cast<std::size_t>(b)],
                (pose.row(bone(b).first) - pose.row(bone(b).second)).norm(), 1e-12);
  EXPECT_NEAR(body.toe_rest_height, 0.04, 1e-12);
}

TEST(Body, DoesNotChangeWhenThePersonTurnsOrWalks) {
  const Body standing = body_of(test::standing_pose());
  const Body elsewhere = body_of(test::moved(test::standing_pose(), 1.2, Vec3(3, 0, -2)));
  EXPECT_LT(largest_length_difference(standing, elsewhere), 1e-12);
  EXPECT_NEAR(standing.height(), elsewhere.height(), 1e-12);
}

TEST(Body, TakesTheMedianSoThatAGlitchDoesNotCount) {
  std::vector<Pose> poses(11, test::standing_pose());
  poses[5].row(joints::left_hand) += Eigen::RowVector3d(5, 5, 5);
  EXPECT_LT(largest_length_difference(body_of(poses), body_of(test::standing_pose())), 1e-12);
}

TEST(Body, IsAsTallAsAnAdult) {
  EXPECT_GT(body_of(test::standing_pose()).height(), 1.5);
  EXPECT_LT(body_of(test::standing_pose()).height(), 1.8);
}

}  // namespace
}  // namespace abrazo::body_test
