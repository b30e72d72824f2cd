#include "core/library/build/capsule_calibration.hpp"

#include <gtest/gtest.h>

#include "core/mesh/capsules.hpp"
#include "tests/core/library/synthetic_takes.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::capsule_calibration_test {
namespace {

CapsuleRadii scaled_generic(const Body& body) {
  CapsuleRadii radii = generic_capsule_radii();
  for (double& radius : radii) radius *= body.height() / 1.75;
  return radii;
}

/// A take in which both stand still `distance_m` apart.
PairedTake standing_take(double distance_m, int frames) {
  PairedTake take;
  take.name = "standing";
  const PairPose pair = test::facing_pair(distance_m);
  take.a.poses.assign(static_cast<std::size_t>(frames), pair.topRows<joint_count>());
  take.b.poses.assign(static_cast<std::size_t>(frames), pair.bottomRows<joint_count>());
  return take;
}

struct Calibrated {
  std::vector<Body> bodies;
  std::vector<CapsuleRadii> radii;
};

Calibrated calibrated(const PairedTake& take) {
  Calibrated result;
  result.bodies = {body_of(std::span(take.a.poses)), body_of(std::span(take.b.poses))};
  const TakeBodies take_bodies{0, 1};
  result.radii = calibrate_capsules(std::span(&take, 1), std::span(&take_bodies, 1), result.bodies);
  return result;
}

double depth(const PairedTake& take, std::size_t frame, const Calibrated& of, int i, int j) {
  const auto at = [](const Pose& pose, int joint) { return Vec3(pose.row(joint).transpose()); };
  const Pose& a = take.a.poses[frame];
  const Pose& b = take.b.poses[frame];
  const double distance =
      closest_points(at(a, bone(i).first), at(a, bone(i).second), at(b, bone(j).first), at(b, bone(j).second))
          .distance;
  return of.radii[0][static_cast<std::size_t>(i)] + of.radii[1][static_cast<std::size_t>(j)] - distance;
}

TEST(CapsuleCalibration, KeepsScaledGenericRadiiWhenNobodyTouches) {
  const Calibrated result = calibrated(standing_take(3, 10));
  for (std::size_t body = 0; body < 2; ++body)
    EXPECT_EQ(result.radii[body], scaled_generic(result.bodies[body]));
}

TEST(CapsuleCalibration, AllowsOneCentimetreOfRecordedDepth) {
  // At 40 cm forearms and hands are within the partner's trunk: nothing but the lower limit can leave more
  // than 1 cm.
  const PairedTake take = standing_take(0.4, 10);
  const Calibrated result = calibrated(take);
  int shrunk = 0;
  for (int i = 0; i < bone_count; ++i)
    for (int j = 0; j < bone_count; ++j) {
      if (is_hand_or_forearm(i) && is_hand_or_forearm(j)) continue;
      const double r1 = result.radii[0][static_cast<std::size_t>(i)],
                   r2 = result.radii[1][static_cast<std::size_t>(j)];
      if (r1 == 0 || r2 == 0) continue;
      const double start1 = scaled_generic(result.bodies[0])[static_cast<std::size_t>(i)];
      const double start2 = scaled_generic(result.bodies[1])[static_cast<std::size_t>(j)];
      shrunk += r1 < start1 || r2 < start2 ? 1 : 0;
      const bool both_smallest = r1 < 0.4 * start1 + 1e-12 && r2 < 0.4 * start2 + 1e-12;
      if (!both_smallest) {
        EXPECT_LE(depth(take, 0, result, i, j), 0.01 + 1e-12)
            << joint_names[static_cast<std::size_t>(i + 1)] << " "
            << joint_names[static_cast<std::size_t>(j + 1)];
      }
    }
  EXPECT_GT(shrunk, 0);
}

TEST(CapsuleCalibration, NeverShrinksBelowFortyPercentOrGrows) {
  const Calibrated result = calibrated(standing_take(0.05, 5));
  for (std::size_t body = 0; body < 2; ++body) {
    const CapsuleRadii start = scaled_generic(result.bodies[body]);
    for (std::size_t b = 0; b < bone_count; ++b) {
      EXPECT_GE(result.radii[body][b], 0.4 * start[b] - 1e-12);
      EXPECT_LE(result.radii[body][b], start[b]);
    }
  }
}

TEST(CapsuleCalibration, IgnoresWhatHappensInLessThanOnePercentOfTheFrames) {
  PairedTake take = standing_take(3, 1000);
  const PairedTake near = standing_take(0.3, 5);
  for (std::size_t frame = 0; frame < 5; ++frame) take.b.poses[100 + frame] = near.b.poses[frame];
  const Calibrated result = calibrated(take);
  EXPECT_EQ(result.radii[0], scaled_generic(result.bodies[0]));
}

TEST(CapsuleCalibration, HoldingHandsDoesNotThinTheArms) {
  // Both hold hands out: at 0.64 m the hands, 0.32 m before the trunk, meet and nothing else does.
  const PairedTake take = standing_take(0.64, 10);
  const Calibrated result = calibrated(take);
  const auto hand = static_cast<std::size_t>(joints::left_hand - 1),
             forearm = static_cast<std::size_t>(joints::left_wrist - 1);
  EXPECT_GT(depth(take, 0, result, joints::left_hand - 1, joints::right_hand - 1), 0.03);
  EXPECT_EQ(result.radii[0][hand], scaled_generic(result.bodies[0])[hand]);
  EXPECT_EQ(result.radii[0][forearm], scaled_generic(result.bodies[0])[forearm]);
}

}  // namespace
}  // namespace abrazo::capsule_calibration_test
