#include "core/mesh/capsules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace abrazo::capsules_test {
namespace {

/// Smallest distance over a grid of both parameters.
double sampled_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  constexpr int steps = 200;
  double smallest = std::numeric_limits<double>::max();
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      smallest = std::min(smallest, ((a + i * (b - a) / steps) - (c + j * (d - c) / steps)).norm());
  return smallest;
}

TEST(Capsules, CrossingSegmentsAreNearestWhereTheyCross) {
  const SegmentApproach approach = closest_points({-1, 0.2, 0}, {1, 0.2, 0}, {0, 0, -1}, {0, 0, 3});
  EXPECT_NEAR(approach.s, 0.5, 1e-12);
  EXPECT_NEAR(approach.t, 0.25, 1e-12);
  EXPECT_NEAR(approach.distance, 0.2, 1e-12);
  EXPECT_LT((approach.normal - Vec3(0, 1, 0)).norm(), 1e-12) << "from the second segment to the first";
}

TEST(Capsules, NoSampledPointsAreNearer) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> metre(-1, 1);
  const auto point = [&] { return Vec3(metre(random), metre(random), metre(random)); };
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 a = point(), b = point(), c = point(), d = point();
    const double sampled = sampled_distance(a, b, c, d);
    const double exact = closest_points(a, b, c, d).distance;
    EXPECT_LE(exact, sampled + 1e-12);
    // The nearest grid point is at most half a step along both segments away from the closest points.
    EXPECT_GE(exact, sampled - 0.5 * ((b - a).norm() + (d - c).norm()) / 200);
  }
}

TEST(Capsules, ParametersGiveTheDistanceAndTheNormal) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> metre(-1, 1);
  const auto point = [&] { return Vec3(metre(random), metre(random), metre(random)); };
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 a = point(), b = point(), c = point(), d = point();
    const SegmentApproach approach = closest_points(a, b, c, d);
    EXPECT_TRUE(approach.s >= 0 && approach.s <= 1 && approach.t >= 0 && approach.t <= 1);
    const Vec3 gap = a + approach.s * (b - a) - c - approach.t * (d - c);
    EXPECT_LT((gap - approach.distance * approach.normal).norm(), 1e-12);
  }
}

TEST(Capsules, SwappingTheSegmentsTurnsTheNormal) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0.3, 0.5, 0.2), d(0.6, 0.9, -0.4);
  const SegmentApproach one = closest_points(a, b, c, d);
  const SegmentApproach other = closest_points(c, d, a, b);
  EXPECT_NEAR(one.distance, other.distance, 1e-12);
  EXPECT_LT((one.normal + other.normal).norm(), 1e-12);
}

TEST(Capsules, ParallelSegmentsHaveTheDistanceOfTheirLines) {
  EXPECT_NEAR(closest_points({0, 0, 0}, {1, 0, 0}, {0.2, 0.3, 0}, {0.8, 0.3, 0}).distance, 0.3, 1e-12);
  EXPECT_NEAR(closest_points({0, 0, 0}, {1, 0, 0}, {0.8, 0.3, 0}, {0.2, 0.3, 0}).distance, 0.3, 1e-12);
  EXPECT_NEAR(closest_points({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}).distance, 1.0, 1e-12)
      << "one behind the other";
}

TEST(Capsules, ABoneWithoutLengthIsAPoint) {
  EXPECT_NEAR(closest_points({2, 1, 0}, {2, 1, 0}, {-1, 0, 0}, {1, 0, 0}).distance, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(closest_points({0, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}).distance, 1, 1e-12);
  EXPECT_NEAR(closest_points({-1, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, 0}).s, 0.75, 1e-12);
  EXPECT_NEAR(closest_points({0, 0, 0}, {0, 0, 0}, {0, 0, 2}, {0, 0, 2}).distance, 2, 1e-12);
}

TEST(Capsules, MeetingSegmentsHaveNoNormal) {
  const SegmentApproach approach = closest_points({-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0});
  EXPECT_NEAR(approach.distance, 0, 1e-12);
  EXPECT_EQ(approach.normal, Vec3(Vec3::Zero()));
}

TEST(Capsules, RadiiAreTheSameOnBothSides) {
  for (int b = 0; b < bone_count; ++b)
    EXPECT_EQ(generic_capsule_radii()[static_cast<std::size_t>(b)],
              generic_capsule_radii()[static_cast<std::size_t>(mirrored_joint(b + 1) - 1)])
        << joint_names[static_cast<std::size_t>(b + 1)];
}

TEST(Capsules, HandsAndForearmsAreFourBones) {
  int count = 0;
  for (int b = 0; b < bone_count; ++b) count += is_hand_or_forearm(b) ? 1 : 0;
  EXPECT_EQ(count, 4);
  EXPECT_TRUE(is_hand_or_forearm(joints::right_hand - 1));
  EXPECT_TRUE(is_hand_or_forearm(joints::left_wrist - 1));
  EXPECT_FALSE(is_hand_or_forearm(joints::left_elbow - 1));
}

TEST(Hands, HoldOneAnotherWithin13CentimetresOfTheirEnds) {
  PairPose pair = PairPose::Zero();
  pair.row(joints::left_hand + joint_count) << 0, 9, 0;
  pair.row(joints::right_hand) << 0, 5, 0.129;
  pair.row(joints::right_hand + joint_count) << 0, 5, 0;
  EXPECT_TRUE(hands_hold(pair, {joints::right_hand, joints::right_hand}));
  EXPECT_NEAR(hands_apart(pair, {joints::right_hand, joints::left_hand}), std::hypot(4, 0.129), 1e-12);
  pair(joints::right_hand, 2) = 0.131;
  for (const HandEnds& hands : all_hand_ends) EXPECT_FALSE(hands_hold(pair, hands));
}

}  // namespace
}  // namespace abrazo::capsules_test
