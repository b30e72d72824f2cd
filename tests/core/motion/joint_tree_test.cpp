#include "core/motion/body/joint_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::joint_tree_test {
namespace {

/// Largest turn of a node relative to its parent between two frames of a clip [rad].
double largest_turn_rad(const Clip& clip) {
  JointTree tree(clip);
  std::vector<Eigen::Matrix3d> world;
  std::vector<Eigen::Quaterniond> before;
  double largest = 0;
  for (const Pose& pose : clip.poses) {
    tree.rotations(pose, 1 / clip.fps, world);
    for (std::size_t n = 0; n < world.size(); ++n) {
      const int parent = tree.nodes()[n].parent;
      const Eigen::Quaterniond local(
          parent < 0 ? world[n]
                     : Eigen::Matrix3d(world[static_cast<std::size_t>(parent)].transpose() * world[n]));
      if (before.size() == world.size()) largest = std::max(largest, local.angularDistance(before[n]));
      if (before.size() < world.size())
        before.push_back(local);
      else
        before[n] = local;
    }
  }
  return largest;
}

TEST(JointTree, HasTheJointsParentsBeforeChildren) {
  const JointTree tree(test::swinging_take("t", 10, 1).a);
  std::vector<int> seen(joint_count, 0);
  for (std::size_t n = 0; n < tree.nodes().size(); ++n) {
    EXPECT_LT(tree.nodes()[n].parent, static_cast<int>(n));
    if (n == 0 || tree.nodes()[n].offset.norm() > 0) ++seen[static_cast<std::size_t>(tree.nodes()[n].joint)];
  }
  EXPECT_EQ(seen, std::vector<int>(joint_count, 1));
}

TEST(JointTree, OffsetsTurnedByTheRotationsGiveTheJoints) {
  const Clip clip = test::swinging_take("t", 60, 2).a;
  JointTree tree(clip);
  std::vector<Eigen::Matrix3d> world;
  for (const Pose& pose : clip.poses) {
    tree.rotations(pose, 1 / clip.fps, world);
    std::vector<Vec3> places(world.size(), pose.row(0).transpose());
    for (std::size_t n = 1; n < world.size(); ++n) {
      const auto parent = static_cast<std::size_t>(tree.nodes()[n].parent);
      places[n] = places[parent] + world[parent] * tree.nodes()[n].offset;
      ASSERT_LT((places[n] - pose.row(tree.nodes()[n].joint).transpose()).norm(), 1e-9);
      ASSERT_NEAR(world[n].determinant(), 1, 1e-9);
    }
  }
}

/// The left upper arm sweeps past the direction opposite to its rest, missing it by `miss_rad`.
Clip arm_across_the_body(double miss_rad) {
  Clip clip{"sweep", 120, {}};
  const Pose stand = test::standing_pose();
  for (int f = 0; f <= 120; ++f) {
    const double angle = 2.4 + 0.0125 * f;  // from the left side (0) over the front (pi / 2), past pi
    const Vec3 direction =
        Vec3(std::cos(angle), std::tan(miss_rad) * std::abs(std::cos(angle)), std::sin(angle)).normalized();
    Pose pose = stand;
    const Vec3 shoulder = stand.row(joints::left_shoulder).transpose();
    for (const int joint : {joints::left_elbow, joints::left_wrist, joints::left_hand})
      pose.row(joint) =
          (shoulder + direction * (stand.row(joint) - stand.row(joints::left_shoulder)).norm()).transpose();
    clip.poses.push_back(pose);
  }
  return clip;
}

TEST(JointTree, ABoneOppositeToItsRestDoesNotFlip) {
  for (const double miss_rad : {0.0, 1e-6, 1e-3, 0.02})
    EXPECT_LT(largest_turn_rad(arm_across_the_body(miss_rad)), 0.25) << miss_rad;  // 30 rad/s; a flip is 3
}

}  // namespace
}  // namespace abrazo::joint_tree_test
