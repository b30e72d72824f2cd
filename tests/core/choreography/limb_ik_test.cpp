#include "core/choreography/limb_ik.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <stdexcept>

namespace abrazo::limb_ik_test {
namespace {

constexpr double upper = 0.42, lower = 0.40;
const Vec3 hip(0.1, 0.95, 0.2), ankle(0.15, 0.20, 0.05);

TEST(LimbIk, KneeIsAtTheBoneLengthsFromBothEnds) {
  const Vec3 knee = middle_joint(hip, ankle, upper, lower, Vec3::UnitZ());
  EXPECT_NEAR((knee - hip).norm(), upper, 1e-12);
  EXPECT_NEAR((knee - ankle).norm(), lower, 1e-12);
}

TEST(LimbIk, KneeLiesTowardsThePole) {
  const Vec3 middle = 0.5 * (hip + ankle);
  for (const Vec3& pole : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(-2, 0.3, -1)}) {
    const Vec3 aside = middle_joint(hip, ankle, upper, lower, pole) - middle;
    EXPECT_GT(aside.dot(pole), 0);
    // In the plane of limb and pole: no part along their common normal.
    EXPECT_NEAR(aside.dot(pole.cross(ankle - hip).normalized()), 0, 1e-12);
  }
}

TEST(LimbIk, RightAngledLimbIsTheThreeFourFiveTriangle) {
  const Vec3 elbow = middle_joint(Vec3::Zero(), Vec3(5, 0, 0), 3, 4, Vec3::UnitY());
  EXPECT_NEAR((elbow - Vec3(1.8, 2.4, 0)).norm(), 0, 1e-12);
}

TEST(LimbIk, RefusesWhatNoLimbCanDo) {
  EXPECT_THROW(middle_joint(hip, hip + Vec3(0, -0.83, 0), upper, lower, Vec3::UnitZ()),
               std::invalid_argument);
  EXPECT_THROW(middle_joint(hip, hip + Vec3(0, -0.01, 0), upper, lower, Vec3::UnitZ()),
               std::invalid_argument);
  EXPECT_THROW(middle_joint(hip, hip + Vec3(0, -0.6, 0), upper, lower, Vec3::UnitY()), std::invalid_argument);
}

TEST(LimbIk, TargetsWithinReachStayWhereTheyAre) {
  const Vec3 target = hip + Vec3(0.3, -0.2, 0.1);
  EXPECT_EQ(within_reach(hip, target, upper + lower), target);
}

TEST(LimbIk, FarTargetsAreReachedForInTheirDirection) {
  for (const double distance : {0.78, 0.82, 1.0, 5.0}) {
    const Vec3 reached = within_reach(hip, hip + Vec3(0, 0, distance), upper + lower) - hip;
    EXPECT_LE(reached.norm(), 0.98 * (upper + lower) + 1e-12);
    EXPECT_GT(reached.norm(), 0.93 * (upper + lower));
    EXPECT_NEAR(reached.normalized().z(), 1, 1e-12);
  }
}

TEST(LimbIk, ReachHasNoKink) {
  // Slopes on both sides of the onset agree (to the step's order).
  const double onset = 0.93 * (upper + lower), step = 1e-6;
  const auto reach = [](double distance) {
    return within_reach(Vec3::Zero(), Vec3(distance, 0, 0), upper + lower).x();
  };
  EXPECT_NEAR((reach(onset + step) - reach(onset)) / step, (reach(onset) - reach(onset - step)) / step, 1e-4);
}

TEST(LimbIk, NearTargetsDoNotFoldTheLimbFlat) {
  EXPECT_GE(within_reach(hip, hip + Vec3(0, -0.01, 0), upper + lower).y(), -1.0);
  EXPECT_GE((within_reach(hip, hip + Vec3(0, -0.01, 0), upper + lower) - hip).norm(), 0.30 * (upper + lower));
}

}  // namespace
}  // namespace abrazo::limb_ik_test
