#include "core/motion/scenes/limb_reach.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace abrazo::limb_reach_test {
namespace {

constexpr double upper_m = 0.3, lower_m = 0.25;

/// An arm along +X that bends forwards.
LimbReach arm() {
  return {upper_m, lower_m, -Vec3::UnitY()};
}

Vec3 bent(double angle) {
  return {std::cos(angle), 0, std::sin(angle)};
}

struct Reached {
  Vec3 upper, lower;
  Vec3 end() const { return upper_m * upper + lower_m * lower; }
};

Reached bring(LimbReach& limb, const Vec3& upper, const Vec3& lower, const Vec3& to) {
  const auto by = limb.bring(upper, lower, Eigen::Matrix3d::Identity(), to);
  return {by.upper * upper, by.lower * lower};
}

TEST(LimbReach, ItsEndIsAtThePlaceIfThatIsInReach) {
  for (const Vec3& to : {Vec3(0.4, 0.1, 0.1), Vec3(0, -0.45, 0.1), Vec3(-0.2, 0.2, 0.2), Vec3(0.07, 0, 0)}) {
    LimbReach limb = arm();
    const Reached reached = bring(limb, Vec3::UnitX(), bent(0.6), to);
    EXPECT_LT((reached.end() - to).norm(), 1e-9) << to.transpose();
  }
}

TEST(LimbReach, ALimbThatIsThereAlreadyStays) {
  LimbReach limb = arm();
  const Vec3 lower = bent(0.6);
  const Reached reached = bring(limb, Vec3::UnitX(), lower, upper_m * Vec3::UnitX() + lower_m * lower);
  EXPECT_LT((reached.upper - Vec3::UnitX()).norm(), 0.01);
  EXPECT_LT((reached.lower - lower).norm(), 0.01);
}

TEST(LimbReach, APlaceOutOfReachIsPointedAtWithAStraightLimb) {
  LimbReach limb = arm();
  const Vec3 to(0.2, 0.9, 0.3);
  const Reached reached = bring(limb, Vec3::UnitX(), bent(1), to);
  EXPECT_LT(reached.end().normalized().cross(to.normalized()).norm(), 1e-9);
  EXPECT_NEAR(reached.end().norm(), upper_m + lower_m, 1e-4);
}

TEST(LimbReach, TheElbowDoesNotJumpWhileTheLimbStraightens) {
  LimbReach limb = arm();
  Vec3 before = Vec3::Zero();
  for (int step = 0; step <= 400; ++step) {
    // The performer's arm straightens and bends to the other side by a little, as noise does.
    const double bend = 0.02 * std::cos(step * 0.05);
    const Vec3 to(0.52 + 0.04 * step / 400, 0, 0.01);
    const Vec3 elbow = upper_m * bring(limb, Vec3::UnitX(), bent(bend), to).upper;
    if (step > 0) {
      EXPECT_LT((elbow - before).norm(), 0.004) << step;
    }
    before = elbow;
  }
}

TEST(LimbReach, ALimbWithoutLengthStays) {
  LimbReach limb(0, 0.2, Vec3::UnitY());
  const auto by = limb.bring(Vec3::UnitX(), Vec3::UnitX(), Eigen::Matrix3d::Identity(), {1, 1, 1});
  EXPECT_TRUE(by.upper.isIdentity());
  EXPECT_TRUE(by.lower.isIdentity());
}

}  // namespace
}  // namespace abrazo::limb_reach_test
