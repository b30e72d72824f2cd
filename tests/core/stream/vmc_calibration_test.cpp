#include <gtest/gtest.h>

#include <random>

#include "core/motion/body/joint_set.hpp"
#include "tests/core/stream/vmc_packets.hpp"

namespace abrazo::vmc_calibration_test {
namespace {

using namespace test;
using Rotation = Eigen::Quaterniond;

void expect_near(const Vec3& actual, const Vec3& expected, double tolerance = 1e-5) {
  EXPECT_LT((actual - expected).norm(), tolerance)
      << actual.transpose() << " instead of " << expected.transpose();
}

std::string parent_of(const std::string& bone, const UnityPose& pose) {
  int above = humanoid_parent(humanoid_bone(bone).value());
  while (above >= 0 && !pose.contains(humanoid_bone_name(above))) above = humanoid_parent(above);
  return above < 0 ? std::string() : humanoid_bone_name(above);
}

/// An avatar of VRM 1: its bones have any rotation in the T-pose. `turned` are rotations in the world by
/// which bones are turned from the T-pose, each with all that hangs on it.
class Avatar {
 public:
  Avatar() {
    std::mt19937 random(9);
    std::normal_distribution<double> normal;
    for (const auto& [name, bone] : t_pose())
      rest_[name] = Rotation(normal(random), normal(random), normal(random), normal(random)).normalized();
  }

  UnityPose pose(const std::map<std::string, Rotation>& turned) const {
    const UnityPose straight = t_pose();
    UnityPose pose;
    for (const auto& [name, bone] : straight) {
      const std::string above = parent_of(name, straight);
      const Rotation parent_rest = above.empty() ? Rotation::Identity() : rest_.at(above);
      const Rotation parent_world = above.empty() ? Rotation::Identity() : world(above, turned);
      pose[name].position = parent_rest.inverse() * bone.position;
      pose[name].rotation = parent_world.inverse() * world(name, turned);
    }
    return pose;
  }

 private:
  Rotation world(const std::string& bone, const std::map<std::string, Rotation>& turned) const {
    Rotation turn = Rotation::Identity();
    for (std::string at = bone; !at.empty(); at = parent_of(at, t_pose()))
      if (turned.contains(at)) turn = turned.at(at) * turn;
    return turn * rest_.at(bone);
  }
  std::map<std::string, Rotation> rest_;
};

const Rotation forward_elbow = unity_rotation(90, Vec3::UnitY());  // the left forearm to +Z

TEST(VmcCalibration, TakesRestRotationsAway) {
  const Avatar avatar;
  Receiver receiver;
  receiver.take(as_slimevr(avatar.pose({}), 1), 1);
  EXPECT_FALSE(receiver.has_point("LeftHand_End"));  // the hand's own axes tell nothing yet
  receiver.decoder->calibrate("");
  receiver.take(as_slimevr(avatar.pose({}), 2), 2);
  expect_near(receiver.point("LeftHand"), {0.68, 1.37, 0});
  expect_near(receiver.point("LeftHand_End"), {0.77, 1.37, 0});
  expect_near(receiver.point("LeftToes_End") - receiver.point("LeftToes"), {0, 0, 0.06});
  receiver.take(as_slimevr(avatar.pose({{"LeftLowerArm", forward_elbow}}), 3), 3);
  expect_near(receiver.point("LeftLowerArm"), {0.43, 1.37, 0});
  expect_near(receiver.point("LeftHand"), {0.43, 1.37, 0.25});
  expect_near(receiver.point("LeftHand_End"), {0.43, 1.37, 0.34});
  expect_near(receiver.point("RightHand"), {-0.68, 1.37, 0});
}

TEST(VmcCalibration, TakesRestRotationsAwayWhereThereAreNoOffsets) {
  const Avatar avatar;
  const auto without_offsets = [&](UnityPose pose) {
    for (auto& [name, bone] : pose) bone.position.setZero();
    return pose;
  };
  Receiver receiver;
  receiver.decoder->calibrate("127.0.0.1:50000");  // nobody there yet
  receiver.take(as_slimevr(without_offsets(avatar.pose({})), 1), 1);
  receiver.decoder->calibrate("127.0.0.1:50000");
  receiver.take(as_slimevr(without_offsets(avatar.pose({{"LeftLowerArm", forward_elbow}})), 2), 2);
  expect_near(receiver.point("LeftHand") - receiver.point("LeftLowerArm"), {0, 0, 0.25});
  expect_near(receiver.point("LeftLowerArm") - receiver.point("LeftUpperArm"), {0.27, 0, 0});
}

TEST(VmcCalibration, KeepsTheDirectionThatThePerformerFaces) {
  const Avatar avatar;
  const Rotation to_the_right = unity_rotation(90, Vec3::UnitY());
  Receiver receiver;
  receiver.take(as_slimevr(avatar.pose({{"Hips", to_the_right}}), 1), 1);
  receiver.decoder->calibrate("");
  receiver.take(
      as_slimevr(avatar.pose({{"Hips", to_the_right},
                              {"LeftLowerArm", to_the_right * forward_elbow * to_the_right.inverse()}}),
                 2),
      2);
  // Facing Unity's +X, ours -X; the left is then ours +Z.
  expect_near(receiver.point("LeftUpperArm"), {0, 1.37, 0.16});
  expect_near(receiver.point("LeftLowerArm"), {0, 1.37, 0.43});
}

TEST(VmcCalibration, PutsATPoseRightThatWasNotQuiteOne) {
  UnityPose drooping = t_pose();
  drooping["LeftUpperArm"].rotation = unity_rotation(12, Vec3::UnitZ());  // down
  drooping["RightLowerArm"].rotation = unity_rotation(8, Vec3::UnitZ());
  Receiver receiver;
  receiver.take(as_slimevr(drooping, 1), 1);
  EXPECT_LT(receiver.point("LeftHand").y(), 1.3);
  receiver.decoder->calibrate("");
  receiver.take(as_slimevr(drooping, 2), 2);
  expect_near(receiver.point("LeftHand"), {0.68, 1.37, 0});
  expect_near(receiver.point("RightHand"), {-0.68, 1.37, 0});
  EXPECT_NEAR(receiver.joints()(joints::left_hand, 1), 1.37, 1e-5);
}

TEST(VmcCalibration, ConcernsThePerformerItWasAskedFor) {
  UnityPose drooping = t_pose();
  drooping["LeftUpperArm"].rotation = unity_rotation(12, Vec3::UnitZ());
  Receiver receiver;
  const Endpoint one{1, 1}, two{1, 2};
  for (const Endpoint& from : {one, two}) receiver.take(as_slimevr(drooping, 1), 1, from);
  receiver.decoder->calibrate(one.text());
  receiver.take(as_slimevr(drooping, 2), 2, one);
  EXPECT_NEAR(receiver.point("LeftHand").y(), 1.37, 1e-5);
  receiver.take(as_slimevr(drooping, 2), 2, two);
  EXPECT_LT(receiver.point("LeftHand").y(), 1.3);
}

}  // namespace
}  // namespace abrazo::vmc_calibration_test
