#include "core/synthesis/edit/constraints.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::constraints_test {
namespace {

TEST(BoneRows, HoldAtTheIterateAndHaveItsDistanceGradient) {
  const PairPose pair = test::facing_pair(0.7);
  const RigidDistances lengths = rigid_distances(pair);
  std::vector<ConstraintRow> rows;
  add_bone_rows(pair, pair, lengths, rows);
  ASSERT_EQ(rows.size(), lengths.size());
  constexpr double h = 1e-6;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    EXPECT_NEAR(rows[n].value(pair), rows[n].target, 1e-12);
    for (int axis = 0; axis < 3; ++axis) {
      PairPose moved = pair;
      moved(lengths[n].a, axis) += h;
      const double slope =
          ((moved.row(lengths[n].a) - moved.row(lengths[n].b)).norm() - lengths[n].length_m) / h;
      EXPECT_NEAR(rows[n].coefficient(0)(axis), slope, 1e-4);
    }
  }
}

TEST(BoneRows, PelvisAndShoulderGirdleAreHeldToo) {
  const RigidDistances distances = rigid_distances(test::facing_pair(0.7));
  int hips = 0;
  int shoulders = 0;
  for (const RigidDistance& d : distances) {
    const auto is = [&](int a, int b) {
      return (d.a % joint_count == a && d.b % joint_count == b) ||
             (d.a % joint_count == b && d.b % joint_count == a);
    };
    hips += is(joints::left_hip, joints::right_hip);
    shoulders += is(joints::left_shoulder, joints::right_shoulder);
  }
  EXPECT_EQ(hips, 2);
  EXPECT_EQ(shoulders, 2);
}

TEST(BoneRows, AVanishedBoneTakesItsDirectionFromTheReference) {
  const PairPose reference = test::facing_pair(0.7);
  PairPose collapsed = reference;
  collapsed.row(joints::LeftHand) = collapsed.row(joints::LeftWrist);
  std::vector<ConstraintRow> rows;
  add_bone_rows(collapsed, reference, rigid_distances(reference), rows);
  for (const ConstraintRow& row : rows) EXPECT_TRUE(row.coefficient(0).allFinite());
  EXPECT_NEAR(rows[joints::LeftHand - 1].coefficient(0).norm(), 1, 1e-9);
}

TEST(BoneLengthError, IsTheLargestRelativeDifference) {
  const PairPose pair = test::facing_pair(0.7);
  const RigidDistances lengths = rigid_distances(pair);
  EXPECT_EQ(bone_length_error(pair, lengths), 0);
  PairPose longer = pair;
  const Vec3 forearm = pair.row(joints::LeftWrist) - pair.row(joints::LeftHumerus);
  for (const int joint : {joints::LeftWrist, joints::LeftHand})
    longer.row(joint) += 0.02 * forearm.transpose();
  EXPECT_NEAR(bone_length_error(longer, lengths), 0.02, 1e-9);
}

TEST(FloorRows, AllowWhatTheRecordingDoesItself) {
  PairPose pair = test::facing_pair(0.7);
  pair(joints::LeftToes, 1) = -0.03;
  std::vector<ConstraintRow> rows;
  add_floor_rows(pair, 0.01, rows);
  for (const ConstraintRow& row : rows) {
    EXPECT_TRUE(row.inequality);
    EXPECT_GE(row.value(pair), row.target) << "the recorded pair must satisfy its own floor";
    EXPECT_LE(row.target, 0.01);
  }
}

}  // namespace
}  // namespace abrazo::constraints_test
