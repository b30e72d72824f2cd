#include "core/synthesis/bodies/pair_fit.hpp"

#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/edit/hold_springs.hpp"
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

TEST(PairFit, DoesNotDependOnTheFitBefore) {
  const CapsuleRadii thick = all(0.1);
  const Standing far(1.2, 0.5), near(1.2, 0.15);
  for (const auto& [before, task] : {std::pair(&near, &far), {&far, &near}, {&near, &near}}) {
    PairFit fresh({thick, thick, thick, thick}), used({thick, thick, thick, thick});
    used.fit(before->task());
    const PairFit::Outcome wanted = fresh.fit(task->task()), outcome = used.fit(task->task());
    EXPECT_EQ(outcome.let_go, wanted.let_go);
    EXPECT_EQ(outcome.pose, wanted.pose);
  }
}

TEST(PairFit, BesideItsOwnResultItStaysThere) {
  const Standing two(0.75, 0.6);
  const std::vector<HandHold> holds{{true, false, 1, Vec3::Zero()}};
  FitTask task = two.task();
  task.holds = holds;
  task.hold_weight = 50;
  PairFit fit({all(0.01), all(0.01), all(0.01), all(0.01)});
  const PairPose first = fit.fit(task).pose;
  ASSERT_GT((first - two.rebuilt).cwiseAbs().maxCoeff(), 0.05);
  task.smoothed = &first;
  EXPECT_LT((fit.fit(task).pose - first).cwiseAbs().maxCoeff(), 1e-3);
}

/// The gradient of a fit's energy at its result, by the formulas of its headers.
PairPose gradient(const PairFit& fit, const FitTask& task, const PairPose& at) {
  const FitWeights weights;
  VertexMatrix energy = fit.mesh().energy();
  PairPose linear = fit.mesh().linear(1);
  const auto anchor = [&](int vertex, double weight) {
    energy(vertex, vertex) += weight;
    linear.row(vertex) += weight * task.rebuilt.row(vertex);
  };
  for (int vertex = 0; vertex < 2 * joint_count; ++vertex) anchor(vertex, weights.place);
  for (const int first : {0, joint_count})
    for (const int toe_base : {joints::left_toe_base, joints::right_toe_base})
      for (const int foot : {toe_base - 1, toe_base, toe_base + 1}) anchor(first + foot, weights.foot);
  add_posture(task.rebuilt, weights.posture, energy, linear);
  add_hold_springs(task.holds, task.hold_weight, energy, linear);
  return energy * at - linear;
}

/// Were there a force across its bone, it could turn and the energy fall.
TEST(PairFit, AHandIsPulledOnlyAlongItsBone) {
  for (const double apart_m : {0.9, 1.2, 1.6}) {
    const Standing two(apart_m, apart_m);
    const std::vector<HandHold> holds{{true, false, 1, Vec3::Zero()}};
    FitTask task = two.task();
    task.holds = holds;
    task.hold_weight = 1;
    PairFit fit({all(0.01), all(0.01), all(0.01), all(0.01)});
    const PairPose pose = fit.fit(task).pose;
    ASSERT_GT((pose - two.rebuilt).row(joints::left_hand).norm(), 0.01)
        << "it must be moved to test anything";
    const PairPose forces = gradient(fit, task, pose);
    for (const int hand : {joints::left_hand, joint_count + joints::right_hand}) {
      const Vec3 along = (pose.row(hand) - pose.row(hand - 1)).normalized(), force = forces.row(hand);
      EXPECT_LT((force - force.dot(along) * along).norm(), 1e-6 * force.norm()) << apart_m;
    }
  }
}

}  // namespace
}  // namespace abrazo::pair_fit_test
