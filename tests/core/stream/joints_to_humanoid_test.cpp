#include "core/stream/humanoid/joints_to_humanoid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/files/import_clip.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::joints_to_humanoid_test {
namespace {

using Rotation = Eigen::Quaterniond;
constexpr double degree = std::numbers::pi / 180;
constexpr double step_s = 1.0 / 120;

/// Standing with the arms held sideways, legs straight down, feet flat.
Pose t_pose() {
  Pose pose;
  pose << 0, 0.95, 0,                                                                  // root
      0.1, 0.87, 0, 0.1, 0.47, 0, 0.1, 0.09, 0, 0.1, 0.04, 0.1, 0.1, 0.04, 0.16,       // left leg
      -0.1, 0.87, 0, -0.1, 0.47, 0, -0.1, 0.09, 0, -0.1, 0.04, 0.1, -0.1, 0.04, 0.16,  // right leg
      0, 1.06, 0, 0, 1.17, 0, 0, 1.29, 0, 0, 1.40, 0, 0, 1.48, 0, 0, 1.60, 0,          // trunk, head
      0.19, 1.37, 0, 0.46, 1.37, 0, 0.71, 1.37, 0, 0.79, 1.37, 0,                      // left arm
      -0.19, 1.37, 0, -0.46, 1.37, 0, -0.71, 1.37, 0, -0.79, 1.37, 0;                  // right arm
  return pose;
}

/// The T-pose with the left arm along `upper` and its forearm and hand along `lower` (units).
Pose with_left_arm(const Vec3& upper, const Vec3& lower) {
  Pose pose = t_pose();
  using namespace joints;
  pose.row(left_elbow) = pose.row(left_shoulder) + 0.27 * upper.transpose();
  pose.row(left_wrist) = pose.row(left_elbow) + 0.25 * lower.transpose();
  pose.row(left_hand) = pose.row(left_wrist) + 0.08 * lower.transpose();
  return pose;
}

double angle(const Rotation& rotation) {
  return rotation.angularDistance(Rotation::Identity()) / degree;
}

TEST(JointsToHumanoid, GivesNoRotationsInTheTPose) {
  JointsToHumanoid humanoid(body_of(t_pose()));
  const HumanoidPose pose = humanoid.pose(t_pose(), 0);
  for (std::size_t bone = 0; bone < humanoid::bone_count; ++bone)
    EXPECT_LT(angle(pose.rotation[bone]), 0.01) << humanoid_bone_name(static_cast<int>(bone));
  EXPECT_NEAR(pose.position[humanoid::LeftLowerArm].x(), 0.27, 1e-9);
  EXPECT_NEAR(pose.position[humanoid::RightLowerLeg].y(), -0.40, 1e-9);
  EXPECT_NEAR(pose.end[humanoid::LeftToes]->z(), 0.06, 1e-9);
}

TEST(JointsToHumanoid, GivesNoRotationsToAnUprightPelvisWhoseRootLiesBehindTheHips) {
  Pose pose = t_pose();
  for (const int hip : {joints::left_hip, joints::right_hip}) pose(hip, 2) = 0.03;  // 20 degrees
  JointsToHumanoid humanoid(body_of(pose));
  EXPECT_LT(angle(humanoid.pose(pose, 0).rotation[humanoid::Hips]), 0.01);
}

TEST(JointsToHumanoid, GivesNoRotationsToAPelvisWhoseRootLiesBetweenTheHips) {
  Pose pose = t_pose();
  for (const int hip : {joints::left_hip, joints::right_hip})
    pose.row(hip).tail<2>() << 0.95, -0.002;  // the root is 2 mm before them: no direction to go by
  JointsToHumanoid humanoid(body_of(pose));
  EXPECT_LT(angle(humanoid.pose(pose, 0).rotation[humanoid::Hips]), 1.1)
      << "the lower back says what is up: 2 mm before the hips and 11 cm above them";
}

TEST(JointsToHumanoid, BendsAnElbowAboutItsHinge) {
  for (const double bend : {30.0, 90.0, 150.0}) {
    JointsToHumanoid humanoid(body_of(t_pose()));
    const Vec3 forward(std::cos(bend * degree), 0, std::sin(bend * degree));
    const HumanoidPose pose = humanoid.pose(with_left_arm(Vec3::UnitX(), forward), 0);
    EXPECT_LT(angle(pose.rotation[humanoid::LeftUpperArm]), 0.01) << bend;
    const Rotation expected(Eigen::AngleAxisd(bend * degree, -Vec3::UnitY()));
    EXPECT_LT(pose.rotation[humanoid::LeftLowerArm].angularDistance(expected), 1e-6) << bend;
  }
}

TEST(JointsToHumanoid, TwistsTheUpperArmForAForearmThatIsBentUpwards) {
  JointsToHumanoid humanoid(body_of(t_pose()));
  const HumanoidPose pose = humanoid.pose(with_left_arm(Vec3::UnitX(), Vec3::UnitY()), 0);
  // From forwards (+Z) to upwards (+Y): a quarter turn about -X. The elbow is bent about its hinge as before.
  const Rotation quarter(Eigen::AngleAxisd(90 * degree, -Vec3::UnitX()));
  EXPECT_LT(pose.rotation[humanoid::LeftUpperArm].angularDistance(quarter), 1e-6);
  EXPECT_LT(pose.rotation[humanoid::LeftLowerArm].angularDistance(
                Rotation(Eigen::AngleAxisd(90 * degree, -Vec3::UnitY()))),
            1e-6);
}

TEST(JointsToHumanoid, TwistsAStraightLegByItsFoot) {
  Pose pose = t_pose();
  const double out = 60 * degree;  // the left foot turned outwards
  for (const int joint : {joints::left_toe_base, joints::left_toe_tip}) {
    const double length = joint == joints::left_toe_base ? 0.1 : 0.16;
    pose.row(joint) = Vec3(0.1 + length * std::sin(out), 0.04, length * std::cos(out)).transpose();
  }
  JointsToHumanoid humanoid(body_of(t_pose()));
  EXPECT_LT(humanoid.pose(pose, 0).rotation[humanoid::LeftUpperLeg].angularDistance(
                Rotation(Eigen::AngleAxisd(out, Vec3::UnitY()))),
            1e-6);
}

/// Largest turn of the left upper arm and forearm from one pose to the next [degrees].
template <typename PoseAt>
double largest_step(int steps, const PoseAt& pose_at) {
  JointsToHumanoid humanoid(body_of(t_pose()));
  std::optional<HumanoidPose> before;
  double largest = 0;
  for (int step = 0; step <= steps; ++step) {
    const HumanoidPose pose = humanoid.pose(pose_at(step), step * step_s);
    if (before)
      for (const int bone : {humanoid::LeftUpperArm, humanoid::LeftLowerArm, humanoid::LeftHand}) {
        const auto b = static_cast<std::size_t>(bone);
        largest = std::max(largest, pose.rotation[b].angularDistance(before->rotation[b]) / degree);
      }
    before = pose;
  }
  return largest;
}

TEST(JointsToHumanoid, DoesNotFlipAnArmThatPassesStraight) {
  // The forearm goes from 60 degrees forwards to 60 degrees backwards, 1 degree per step: the plane in which
  // the arm is bent turns over at once. 12 rad/s are 5.7 degrees per step.
  const double step = largest_step(240, [](int s) {
    const double bend = (60 - 0.5 * s) * degree;
    return with_left_arm(Vec3::UnitX(), Vec3(std::cos(bend), 0, std::sin(bend)));
  });
  EXPECT_LT(step, 9);
}

TEST(JointsToHumanoid, DoesNotFlipAStraightArmThatPassesItsSingularity) {
  // Down, forwards, across the chest to the right, up and back over the head: 1 degree per step.
  const double step = largest_step(720, [](int s) {
    const Vec3 along = Rotation(Eigen::AngleAxisd(s * degree, Vec3(0, 0.02, 1).normalized())) * Vec3(1, 0, 0);
    return with_left_arm(along, along);
  });
  EXPECT_LT(step, 2.5);
}

TEST(JointsToHumanoid, DoesNotWindUpAnArmThatCirclesOverhead) {
  JointsToHumanoid humanoid(body_of(t_pose()));
  Rotation first, last;
  double largest = 0;
  for (int s = 0; s <= 2400; ++s) {  // 20 turns, one per second
    const double turn = 3 * s * degree;
    const Vec3 along = Vec3(std::cos(turn), 1, std::sin(turn)).normalized();
    const Rotation now =
        humanoid.pose(with_left_arm(along, along), s * step_s).rotation[humanoid::LeftUpperArm];
    if (s == 0) first = now;
    if (s > 0) largest = std::max(largest, now.angularDistance(last) / degree);
    last = now;
  }
  EXPECT_LT(largest, 4);
  EXPECT_LT(first.angularDistance(last) / degree, 60);
}

/// Largest angle between the directions of a bone of the 25 joints in two poses, of the bones given
/// [degrees].
double largest_turn(const Pose& before, const Pose& now, std::initializer_list<int> bones_by_end) {
  double largest = 0;
  for (const int joint : bones_by_end) {
    const int from = joint_parents[static_cast<std::size_t>(joint)];
    const Vec3 a = (before.row(joint) - before.row(from)).transpose(),
               b = (now.row(joint) - now.row(from)).transpose();
    largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)) / degree);
  }
  return largest;
}

TEST(JointsToHumanoid, TurnsNoBoneFasterThanPositionsDoInCapturedClips) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  using namespace joints;
  const std::initializer_list<int> arm = {LeftClavicle, LeftHumerus, LeftWrist, joints::LeftHand, LowerNeck};
  const std::initializer_list<int> leg = {LeftHipJoint,     LeftFemur,        LeftTibia,
                                          joints::LeftFoot, joints::LeftToes, LowerBack};
  for (const char* name : {"60_01.amc", "61_01.amc"}) {
    ImportOptions options;
    options.fps = 60;
    const Clip clip = load_motion((data / "cmu_salsa" / name).string(), "", options).value().front().clip;
    JointsToHumanoid humanoid(body_of(clip.poses));
    std::optional<HumanoidPose> before;
    double most_excess = -1e9;
    for (std::size_t f = 0; f < clip.poses.size(); ++f) {
      const HumanoidPose pose = humanoid.pose(clip.poses[f], static_cast<double>(f) / clip.fps);
      if (before) {
        const auto compare = [&](int first, int last, const std::initializer_list<int>& limb) {
          // 12 rad/s are 11.5 degrees per frame; sideways motion of the lower part turns the plane of a limb
          // that is bent by 20 degrees three times as far.
          const double justified = 11.5 + 4 * largest_turn(clip.poses[f - 1], clip.poses[f], limb);
          for (int bone = first; bone <= last; ++bone) {
            const auto b = static_cast<std::size_t>(bone);
            const double turned = pose.rotation[b].angularDistance(before->rotation[b]) / degree;
            most_excess = std::max(most_excess, turned - justified);
            EXPECT_LT(turned, justified) << name << " frame " << f << " " << humanoid_bone_name(bone);
          }
        };
        compare(humanoid::LeftShoulder, humanoid::LeftHand, arm);
        compare(humanoid::LeftUpperLeg, humanoid::LeftToes, leg);
      }
      before = pose;
    }
    RecordProperty(std::string(name).substr(0, 5) + "_margin_degrees", std::to_string(-most_excess));
  }
}

TEST(JointsToHumanoid, SendsNoBonesOfTheFaceBecauseNoJointMovesThem) {
  JointsToHumanoid humanoid(body_of(t_pose()));
  const HumanoidPose pose = humanoid.pose(t_pose(), 0);
  for (std::size_t bone = 0; bone < static_cast<std::size_t>(humanoid::FirstFinger); ++bone) {
    const bool is_of_face = bone == humanoid::Jaw || bone == humanoid::LeftEye || bone == humanoid::RightEye;
    EXPECT_EQ(pose.present[bone], !is_of_face) << humanoid_bone_name(static_cast<int>(bone));
  }
}

}  // namespace
}  // namespace abrazo::joints_to_humanoid_test
