#include "core/synthesis/bodies/pair_fit.hpp"

#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::pair_fit_test {
namespace {

CapsuleRadii all(double radius_m) {
  CapsuleRadii radii{};
  radii.fill(radius_m);
  return radii;
}

/// Two people who were recorded at `recorded_m` and are rebuilt at `rebuilt_m`, on both feet.
struct Standing {
  PairPose recorded, rebuilt;
  std::vector<MeshEdge> edges;

  Standing(double recorded_m, double rebuilt_m)
      : recorded(test::facing_pair(recorded_m)),
        rebuilt(test::facing_pair(rebuilt_m)),
        edges(tetrahedralize(recorded).edges) {}

  FitTask task() const {
    return {.edges = edges, .recorded = recorded, .rebuilt = rebuilt, .stands = {true, true, true, true}};
  }
};

TEST(PairFit, BodiesThatCannotPartWithoutLeavingTheirPlacesOverlapOnStandingFeet) {
  const Standing two(1.2, 0.15);
  PairFit fit({all(0.1), all(0.1), all(0.1), all(0.1)});
  const PairFit::Outcome outcome = fit.fit(two.task());
  EXPECT_EQ(outcome.let_go, PairFit::LetGo::Capsules);
  EXPECT_GT(outcome.excess_m, 0.01);
  EXPECT_LT(outcome.foot_drift_m, 1e-3);
  EXPECT_LT(outcome.bone_error, 1e-3);
}

TEST(PairFit, WhatWasNotLetGoIsKept) {
  int kept = 0, let_go = 0;
  for (double rebuilt_m = 0.1; rebuilt_m < 0.6; rebuilt_m += 0.02)
    for (const double radius_m : {0.03, 0.06, 0.09, 0.12}) {
      const Standing two(1.2, rebuilt_m);
      PairFit fit({all(0.03), all(0.03), all(radius_m), all(radius_m)});
      const PairFit::Outcome outcome = fit.fit(two.task());
      EXPECT_LE(outcome.bone_error, 1e-3) << rebuilt_m << ' ' << radius_m;
      if (outcome.let_go < PairFit::LetGo::StandingFeet) {
        EXPECT_LE(outcome.foot_drift_m, 1e-3) << rebuilt_m << ' ' << radius_m;
      }
      if (outcome.let_go < PairFit::LetGo::Capsules) {
        EXPECT_LE(outcome.excess_m, 0.01) << rebuilt_m << ' ' << radius_m;
      }
      ++(outcome.let_go == PairFit::LetGo::Nothing ? kept : let_go);
    }
  EXPECT_GT(kept, 10);
  EXPECT_GT(let_go, 10);
}

TEST(PairFit, HandsThatHoldOneAnotherAreDrawnTogether) {
  const Standing two(0.75, 0.75);
  const int active_hand = joints::left_hand, passive_hand = joint_count + joints::right_hand;
  const auto apart_m = [&](double weight) {
    const std::vector<HandHold> holds{{true, false, 1, Vec3::Zero()}};
    FitTask task = two.task();
    task.holds = holds;
    task.hold_weight = weight;
    PairFit fit({all(0.01), all(0.01), all(0.01), all(0.01)});
    const PairPose pose = fit.fit(task).pose;
    return (pose.row(passive_hand) - pose.row(active_hand)).norm();
  };
  const double without_m = apart_m(0);
  ASSERT_GT(without_m, 0.1);
  EXPECT_LT(apart_m(200), 0.2 * without_m);
}

}  // namespace
}  // namespace abrazo::pair_fit_test
