#include "core/choreography/arm_swivel.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/choreography/limb_ik.hpp"
#include "core/motion/body/body.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo::arm_swivel_test {
namespace {

constexpr int frames = 60, half_width = 8;
const DancerBody dancer = leader_body(1.80);

/// A left arm that points forward; the elbow flips from below to above between two frames.
std::vector<Pose> flipping_arm() {
  std::vector<Pose> poses;
  for (int f = 0; f < frames; ++f) {
    Pose pose = Pose::Zero();
    TrunkPosture trunk;
    trunk.root.y() = 1;
    place_trunk(dancer, trunk, pose);
    const Vec3 shoulder = pose.row(joints::left_shoulder).transpose();
    const Vec3 wrist = shoulder + Vec3(0, 0, 0.40), hand = wrist + Vec3(0, 0, dancer.hand);
    const Vec3 pole(0.2, f < frames / 2 ? -1 : 1, 0);
    pose.row(joints::left_elbow) =
        middle_joint(shoulder, wrist, dancer.upper_arm, dancer.forearm, pole).transpose();
    pose.row(joints::left_wrist) = wrist.transpose();
    pose.row(joints::left_hand) = hand.transpose();
    poses.push_back(pose);
  }
  return poses;
}

double largest_step(const std::vector<Pose>& poses, int joint) {
  double most = 0;
  for (std::size_t f = 1; f < poses.size(); ++f)
    most = std::max(most, (poses[f].row(joint) - poses[f - 1].row(joint)).norm());
  return most;
}

TEST(ArmSwivel, AnElbowThatFlipsComesAboutOverSeveralFrames) {
  std::vector<Pose> poses = flipping_arm();
  const double before = largest_step(poses, joints::left_elbow);
  smooth_arm(dancer, Side::Left, std::vector<Turn>(frames), half_width, poses);
  // The steepest slope of a Hann-averaged step is 2 / (2 half_width + 2) of it.
  EXPECT_LT(largest_step(poses, joints::left_elbow), 2.2 / (half_width + 1) * before);
}

TEST(ArmSwivel, LengthsAndHandsStay) {
  const std::vector<Pose> before = flipping_arm();
  std::vector<Pose> poses = before;
  smooth_arm(dancer, Side::Left, std::vector<Turn>(frames), half_width, poses);
  for (std::size_t f = 0; f < poses.size(); ++f) {
    const auto between = [&](int a, int b) { return (poses[f].row(a) - poses[f].row(b)).norm(); };
    EXPECT_NEAR(between(joints::left_shoulder, joints::left_elbow), dancer.upper_arm, 1e-12);
    EXPECT_NEAR(between(joints::left_elbow, joints::left_wrist), dancer.forearm, 1e-12);
    EXPECT_NEAR(between(joints::left_wrist, joints::left_hand), dancer.hand, 1e-12);
    EXPECT_NEAR((poses[f].row(joints::left_hand) - before[f].row(joints::left_hand)).norm(), 0, 1e-9);
  }
}

TEST(ArmSwivel, AnArmThatTurnsWithTheChestIsLeftAsItIs) {
  // A quarter turn a second about the vertical: in the space of the chest nothing moves.
  const Pose still = flipping_arm().front();
  std::vector<Pose> poses;
  std::vector<Turn> chests;
  for (int f = 0; f < frames; ++f) {
    chests.push_back({.yaw = f * std::numbers::pi / 2 / 60});
    poses.emplace_back(still * chests.back().matrix().transpose());
  }
  const std::vector<Pose> before = poses;
  smooth_arm(dancer, Side::Left, chests, half_width, poses);
  for (std::size_t f = half_width; f + half_width < poses.size(); ++f)
    EXPECT_NEAR((poses[f] - before[f]).norm(), 0, 1e-3);
}

}  // namespace
}  // namespace abrazo::arm_swivel_test
