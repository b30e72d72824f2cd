#include "core/retarget/body_retargeter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "tests/support/bodies.hpp"

namespace abrazo::body_retargeter_test {
namespace {

using namespace joints;

Pose scaled_pose(double factor) {
  return factor * test::standing_pose();
}

/// A library body with legs, arms and trunk in other proportions than the standing pose.
Body other_body() {
  Body body = body_of(test::standing_pose());
  for (const int joint : {LeftFemur, LeftTibia, RightFemur, RightTibia})
    body.bone_lengths[static_cast<std::size_t>(joint - 1)] *= 1.1;
  for (const int joint : {LeftHumerus, LeftWrist, RightHumerus, RightWrist})
    body.bone_lengths[static_cast<std::size_t>(joint - 1)] *= 0.9;
  for (const int joint : {LowerBack, UpperBack, Thorax})
    body.bone_lengths[static_cast<std::size_t>(joint - 1)] *= 1.05;
  return body;
}

TEST(BodyRetargeter, IsTheIdentityForEqualBodies) {
  const Pose pose = test::moved(test::standing_pose(), 0.4, Vec3(1, 0, 2));
  const Body body = body_of(pose);
  const BodyRetargeter retargeter(body, body);
  EXPECT_TRUE(retargeter.is_identity());
  EXPECT_EQ(retargeter.apply(pose), pose);
}

TEST(BodyRetargeter, AnEqualBodyOnAnotherFloorIsSetOnTheLibrarysFloor) {
  const Pose raised = test::moved(test::standing_pose(), 0, Vec3(0, 0.1, 0));
  const BodyRetargeter retargeter(body_of(raised), body_of(test::standing_pose()));
  EXPECT_FALSE(retargeter.is_identity());
  EXPECT_LT((retargeter.apply(raised) - test::standing_pose()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(BodyRetargeter, GivesExactlyTheLibraryBodysBoneLengths) {
  std::mt19937 random(4);
  const Body library = other_body();
  const BodyRetargeter retargeter(body_of(test::standing_pose()), library);
  ASSERT_FALSE(retargeter.is_identity());
  for (int trial = 0; trial < 100; ++trial) {
    const Pose result = retargeter.apply(test::shaken(test::standing_pose(), 0.05, random));
    EXPECT_LT(largest_length_difference(body_of(result), library), 1e-9);
  }
}

TEST(BodyRetargeter, AUniformlyScaledUserBecomesTheLibraryPose) {
  for (const double factor : {0.85, 1.15}) {
    const Pose user = test::moved(scaled_pose(factor), 0.7, Vec3::Zero());
    Body user_body = body_of(user);
    Body library = body_of(test::standing_pose());
    const BodyRetargeter retargeter(user_body, library);
    const Pose expected = test::moved(test::standing_pose(), 0.7, Vec3::Zero());
    EXPECT_LT((retargeter.apply(user) - expected).cwiseAbs().maxCoeff(), 1e-9) << factor;
  }
}

TEST(BodyRetargeter, APlantedFootStaysPlantedWhileTheBodyMoves) {
  const BodyRetargeter retargeter(body_of(test::standing_pose()), other_body());
  const Pose first = test::standing_pose();
  Pose second = first;
  for (int joint = 0; joint < joint_count; ++joint)  // everything above the ankles sways
    if (first(joint, 1) > 0.2) second.row(joint) += Eigen::RowVector3d(0.03, -0.02, 0.02);
  const Pose a = retargeter.apply(first);
  const Pose b = retargeter.apply(second);
  for (const int joint :
       {left_ankle, left_toe_base, left_toe_tip, right_ankle, right_toe_base, right_toe_tip})
    EXPECT_LT((a.row(joint) - b.row(joint)).norm(), 1e-9) << joint_names[static_cast<std::size_t>(joint)];
}

TEST(BodyRetargeter, LongArmsDoNotFakeAnotherPose) {
  // The same person with arms 30 % longer, the hand reaching the same share of the arm's length.
  Pose long_armed = test::standing_pose();
  for (const int shoulder : {left_shoulder, right_shoulder})
    for (int joint = shoulder + 1; joint <= shoulder + 3; ++joint)
      long_armed.row(joint) = long_armed.row(shoulder) +
                              1.3 * (test::standing_pose().row(joint) - test::standing_pose().row(shoulder));
  const BodyRetargeter retargeter(body_of(long_armed), body_of(test::standing_pose()));
  EXPECT_LT((retargeter.apply(long_armed) - test::standing_pose()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(BodyRetargeter, LowersTheRootWhenALegCannotReachItsFoot) {
  Body short_legged = body_of(test::standing_pose());
  for (const int joint : {LeftFemur, LeftTibia, RightFemur, RightTibia})
    short_legged.bone_lengths[static_cast<std::size_t>(joint - 1)] *= 0.9;
  // Hip bones much longer: the scaled root stands too high for these legs.
  short_legged.bone_lengths[LeftHipJoint - 1] = short_legged.bone_lengths[RightHipJoint - 1] = 0.02;
  const BodyRetargeter retargeter(body_of(test::standing_pose()), short_legged);
  const Pose result = retargeter.apply(test::standing_pose());
  EXPECT_NEAR(result(left_toe_base, 1), test::standing_pose()(left_toe_base, 1), 1e-9)
      << "the foot must stay on the floor";
  EXPECT_LT(largest_length_difference(body_of(result), short_legged), 1e-9);
}

TEST(TwoBoneJoint, MeetsBothLengthsAndBendsTowardsTheHint) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 root(coordinate(random), coordinate(random), coordinate(random));
    Vec3 end = root + 0.5 * Vec3(coordinate(random), coordinate(random), coordinate(random));
    const Vec3 hint(coordinate(random), coordinate(random), coordinate(random));
    const Vec3 middle = two_bone_joint(root, end, 0.41, 0.39, hint);
    EXPECT_NEAR((middle - root).norm(), 0.41, 1e-9);
    EXPECT_NEAR((end - middle).norm(), 0.39, 1e-9);
    const Vec3 along = (end - root).normalized();
    const auto sideways = [&](const Vec3& p) -> Vec3 { return (p - root) - (p - root).dot(along) * along; };
    EXPECT_GE(sideways(middle).dot(sideways(hint)), -1e-9);
  }
}

TEST(TwoBoneJoint, AnEndOutOfReachIsApproached) {
  Vec3 end(0, -2, 0);
  const Vec3 middle = two_bone_joint(Vec3::Zero(), end, 0.4, 0.4, Vec3(0, 0, 1));
  EXPECT_NEAR(end.norm(), 0.8 * 0.9999, 1e-9);
  EXPECT_GT(middle.z(), 0);
}

}  // namespace
}  // namespace abrazo::body_retargeter_test
