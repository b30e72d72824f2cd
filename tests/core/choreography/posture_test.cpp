#include "core/choreography/posture.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/motion/body/body.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo::posture_test {
namespace {

Vec3 joint(const Pose& pose, int index) {
  return pose.row(index).transpose();
}

Pose posed(const DancerBody& body, const TrunkPosture& trunk, const FootPosture& left,
           const FootPosture& right, const Vec3& left_hand, const Vec3& right_hand) {
  Pose pose = Pose::Zero();
  place_trunk(body, trunk, pose);
  place_leg(body, Side::Left, left, trunk.pelvis.yaw, pose);
  place_leg(body, Side::Right, right, trunk.pelvis.yaw, pose);
  place_arm(body, Side::Left, {left_hand, Vec3::Zero()}, trunk.chest, pose);
  place_arm(body, Side::Right, {right_hand, Vec3::Zero()}, trunk.chest, pose);
  return pose;
}

Pose standing(const DancerBody& body) {
  TrunkPosture trunk;
  trunk.root.y() = body.standing_root_height(0.95);
  const double rest = body.toe_rest_height;
  return posed(body, trunk, {.toe_base = {0.09, rest, 0.05}}, {.toe_base = {-0.09, rest, 0.05}},
               {0.3, 1.0, 0.3}, {-0.3, 1.0, 0.3});
}

TEST(Posture, BoneLengthsDoNotDependOnThePose) {
  const DancerBody body = follower_body(1.66);
  TrunkPosture bent;
  bent.root = {1.0, body.standing_root_height(0.9), -2.0};
  bent.pelvis = {2.0, 0.2, 0.1};
  bent.chest = {1.6, -0.1, -0.2};
  bent.head = {1.0, 0.3, 0.1};
  const double rest = body.toe_rest_height;
  const Pose pose =
      posed(body, bent, {.toe_base = {1.1, rest, -2.05}, .yaw = 2.2, .heel_pitch = 0.4},
            {.toe_base = {0.9, rest + 0.05, -2.1}, .yaw = 1.9, .heel_pitch = 0.1, .toe_pitch = 0.2},
            {1.3, 1.7, -2.1}, {5.0, 1.0, 5.0});
  EXPECT_LT(largest_length_difference(body_of(pose), body_of(standing(body))), 1e-9);
}

TEST(Posture, StandsOnTheFloorAtAboutTheHeightAskedFor) {
  for (const DancerBody& body : {leader_body(1.80), follower_body(1.66)}) {
    const Pose pose = standing(body);
    EXPECT_NEAR(pose(joints::left_toe_base, 1), body.toe_rest_height, 1e-12);
    EXPECT_NEAR(pose(joints::right_toe_tip, 1), body.toe_rest_height, 1e-12);
    EXPECT_NEAR(pose(joints::left_ankle, 1), body.ankle_rest_height(), 1e-12);
    // The end of the head bone is in the skull, some 15 cm below its top; knees are a little bent.
    EXPECT_NEAR(pose(joints::Head, 1) + 0.15, body.height, 0.04 * body.height);
  }
}

TEST(Posture, LeftIsToTheLeftOfWhereTheDancerFaces) {
  const Pose pose = standing(leader_body(1.80));
  EXPECT_GT(pose(joints::left_shoulder, 0), 0);
  EXPECT_LT(pose(joints::right_knee, 0), 0);
  EXPECT_GT(pose(joints::left_toe_tip, 2), pose(joints::left_ankle, 2));
}

TEST(Posture, KneesBendForwardAndElbowsBack) {
  const Pose pose = standing(leader_body(1.80));
  for (const auto& [hip, knee, ankle] :
       {std::array{joints::left_hip, joints::left_knee, joints::left_ankle},
        std::array{joints::right_hip, joints::right_knee, joints::right_ankle}})
    EXPECT_GT(pose(knee, 2), 0.5 * (pose(hip, 2) + pose(ankle, 2)));
  EXPECT_LT(pose(joints::left_elbow, 2),
            0.5 * (pose(joints::left_shoulder, 2) + pose(joints::left_wrist, 2)));
}

TEST(Posture, HandsAreWhereTheyShouldBe) {
  const Pose pose = standing(leader_body(1.80));
  EXPECT_NEAR((joint(pose, joints::left_hand) - Vec3(0.3, 1.0, 0.3)).norm(), 0, 1e-12);
  EXPECT_NEAR((joint(pose, joints::right_hand) - Vec3(-0.3, 1.0, 0.3)).norm(), 0, 1e-12);
}

TEST(Posture, RaisingTheHeelTurnsTheFootAboutTheToeBase) {
  const DancerBody body = leader_body(1.80);
  const FootPosture flat{.toe_base = {0, 0.04, 0}}, raised{.toe_base = {0, 0.04, 0}, .heel_pitch = 0.5};
  const Vec3 down = ankle_position(body, flat), up = ankle_position(body, raised);
  EXPECT_GT(up.y(), down.y() + 0.02);
  EXPECT_GT(up.z(), down.z());
  EXPECT_NEAR((up - raised.toe_base).norm(), (down - flat.toe_base).norm(), 1e-12);
}

TEST(Posture, PositiveYawTurnsLeftPitchLeansForwardRollRaisesTheLeftSide) {
  constexpr double quarter = std::numbers::pi / 2;
  EXPECT_NEAR((Turn{.yaw = quarter}.matrix() * Vec3::UnitZ() - Vec3::UnitX()).norm(), 0, 1e-12);
  EXPECT_NEAR((Turn{.pitch = quarter}.matrix() * Vec3::UnitY() - Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR((Turn{.roll = quarter}.matrix() * Vec3::UnitX() - Vec3::UnitY()).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace abrazo::posture_test
