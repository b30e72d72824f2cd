#include "core/metrics/support_polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace abrazo::support_polygon_test {
namespace {

TEST(SupportPolygon, HasTheCornersOfItsPointsCounterClockwise) {
  const std::vector<Vec2> hull =
      convex_hull({{1, 1}, {0, 0}, {0.5, 0.5}, {1, 0}, {0, 1}, {0.5, 0}, {1, 0.5}, {0, 0}});
  ASSERT_EQ(hull.size(), 4U);
  EXPECT_EQ(hull[0], Vec2(0, 0));
  EXPECT_EQ(hull[1], Vec2(1, 0));
  EXPECT_EQ(hull[2], Vec2(1, 1));
  EXPECT_EQ(hull[3], Vec2(0, 1));
}

TEST(SupportPolygon, OfPointsOnALineIsTheirEnds) {
  const std::vector<Vec2> hull = convex_hull({{1, 1}, {3, 3}, {2, 2}, {0, 0}});
  ASSERT_EQ(hull.size(), 2U);
  EXPECT_EQ(distance_outside(hull, {1.5, 1.5}), 0);
  EXPECT_NEAR(distance_outside(hull, {2, 1}), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(distance_outside(hull, {3, 5}), 2, 1e-12) << "beyond the end";
}

TEST(SupportPolygon, OfOnePlaceIsThatPlace) {
  const std::vector<Vec2> hull = convex_hull({{2, 1}, {2, 1}, {2, 1}});
  ASSERT_EQ(hull.size(), 1U);
  EXPECT_NEAR(distance_outside(hull, {5, 5}), 5, 1e-12);
}

TEST(SupportPolygon, IsZeroInsideAndMeasuredToEdgesAndCorners) {
  const std::vector<Vec2> hull = convex_hull({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  EXPECT_EQ(distance_outside(hull, {1, 0.5}), 0);
  EXPECT_EQ(distance_outside(hull, {1, 0}), 0) << "on the border";
  EXPECT_NEAR(distance_outside(hull, {1, -0.3}), 0.3, 1e-12);
  EXPECT_NEAR(distance_outside(hull, {2.3, 1.4}), 0.5, 1e-12);
}

TEST(SupportPolygon, HoldsEveryPointOfWhichItIsMade) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> metre(-0.2, 0.2);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vec2> points;
    points.reserve(6);
    for (int n = 0; n < 6; ++n) points.emplace_back(metre(random), metre(random));
    const std::vector<Vec2> hull = convex_hull(points);
    for (const Vec2& point : points) EXPECT_LT(distance_outside(hull, point), 1e-12);
  }
}

TEST(SupportPolygon, NeedsAPoint) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_THROW(distance_outside({}, {0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::support_polygon_test
