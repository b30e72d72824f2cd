#include "core/choreography/balance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abrazo::balance_test {
namespace {

constexpr double fps = 60, height_m = 0.95, gravity = 9.81;

TEST(PendulumPath, StandsOverAPointThatRests) {
  const std::vector<Vec3> path = pendulum_path(std::vector<Vec3>(50, Vec3(0.3, 0, -0.2)), height_m, fps);
  for (const Vec3& centre : path) EXPECT_LT((centre - Vec3(0.3, 0, -0.2)).norm(), 1e-12);
}

TEST(PendulumPath, HasTheZeroMomentPointAskedFor) {
  std::vector<Vec3> wanted;
  for (int f = 0; f < 200; ++f) wanted.emplace_back(f < 80 ? 0.0 : 0.4, 0, 0.1 * std::sin(0.1 * f));
  const std::vector<Vec3> path = pendulum_path(wanted, height_m, fps);
  for (std::size_t f = 1; f + 1 < path.size(); ++f) {
    const Vec3 acceleration = (path[f + 1] - 2 * path[f] + path[f - 1]) * fps * fps;
    EXPECT_LT((path[f] - height_m / gravity * acceleration - wanted[f]).norm(), 1e-9) << f;
  }
}

TEST(PendulumPath, SwaysLessThanTheWeightTheFasterTheLess) {
  // p = sin(w t) has the bounded solution c = sin(w t) / (1 + h w^2 / g).
  const double w = 2 * std::numbers::pi * 1.5;
  std::vector<Vec3> wanted;
  for (int f = 0; f < 1200; ++f) wanted.emplace_back(0.1 * std::sin(w * f / fps), 0, 0);
  const std::vector<Vec3> path = pendulum_path(wanted, height_m, fps);
  double widest = 0;
  for (std::size_t f = 400; f < 800; ++f) widest = std::max(widest, std::abs(path[f].x()));
  EXPECT_NEAR(widest, 0.1 / (1 + height_m * w * w / gravity), 2e-4);  // differences over 1/60 s
}

/// Stands on both feet, then lifts the left foot and puts it down 40 cm ahead.
FeetTrack one_step() {
  FeetTrack feet;
  for (int f = 0; f < 120; ++f) {
    const double way = std::clamp((f - 50) / 20.0, 0.0, 1.0);
    feet.left.push_back({.toe_base = Vec3(0.1, 0.04 + 0.2 * way * (1 - way), 0.4 * way)});
    feet.right.push_back({.toe_base = Vec3(-0.1, 0.04, 0)});
  }
  return feet;
}

TEST(WeightPath, IsBetweenStandingFeetAndOnTheOneThatStands) {
  const std::vector<Vec3> path = weight_path(one_step(), fps);
  EXPECT_NEAR(path[10].x(), 0, 1e-9);
  EXPECT_NEAR(path[60].x(), -0.1, 2e-3);  // the left foot is in the air
  EXPECT_NEAR(path[115].x(), 0, 1e-9);
  EXPECT_NEAR(path[115].z() - path[10].z(), 0.2, 1e-9);
  for (std::size_t f = 1; f < path.size(); ++f) EXPECT_LT((path[f] - path[f - 1]).norm(), 0.04) << f;
}

TEST(BalanceTrunks, BringsATrunkThatLeansAwayBackOverItsFeet) {
  const DancerBody body = leader_body(1.80);
  const FeetTrack feet = one_step();
  std::vector<TrunkPosture> straight(120), away(120);
  for (std::size_t f = 0; f < straight.size(); ++f) {
    straight[f].root = Vec3(0, 1, 0);
    away[f].root = Vec3(0.5, 1, -0.3);
  }
  balance_trunks(body, feet, fps, 1, straight);
  balance_trunks(body, feet, fps, 1, away);
  for (std::size_t f = 0; f < straight.size(); ++f) {
    EXPECT_LT((straight[f].root - away[f].root).norm(), 1e-9);  // wherever they began
    EXPECT_DOUBLE_EQ(away[f].root.y(), 1);
  }
  EXPECT_LT(std::abs(away[10].root.x()), 0.01);  // the step to come is felt a little already
  EXPECT_NEAR(away.back().root.z() - away.front().root.z(), 0.2, 0.02);  // half way between the feet again
}

TEST(BalanceTrunks, GoesTheShareOfTheWay) {
  const DancerBody body = leader_body(1.80);
  std::vector<TrunkPosture> half(120), whole(120);
  for (std::size_t f = 0; f < half.size(); ++f) half[f].root = whole[f].root = Vec3(0.5, 1, -0.3);
  const Vec3 before = half[40].root;
  balance_trunks(body, one_step(), fps, 0.5, half);
  balance_trunks(body, one_step(), fps, 1, whole);
  EXPECT_LT((half[40].root - 0.5 * (before + whole[40].root)).norm(), 1e-12);
}

}  // namespace
}  // namespace abrazo::balance_test
