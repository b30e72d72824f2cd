#include "core/synthesis/bodies/split_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::split_mesh_test {
namespace {

PairPose scaled_halves(const PairPose& pair, double active, double passive) {
  PairPose scaled = pair;
  scaled.topRows<joint_count>() *= active;
  scaled.bottomRows<joint_count>() *= passive;
  return scaled;
}

/// q_as: the recorded vector of an arm; otherwise its height is half recorded, half rebuilt.
Eigen::RowVector3d kept(int a, int s, const PairPose& recorded, const PairPose& rebuilt) {
  using namespace joints;
  const Eigen::RowVector3d was = recorded.row(a) - recorded.row(s), own = rebuilt.row(a) - rebuilt.row(s);
  for (const int joint : {a % joint_count, s % joint_count})
    for (const int of_arm : {left_elbow, left_wrist, left_hand, right_elbow, right_wrist, right_hand})
      if (joint == of_arm) return was;
  return {was.x(), 0.5 * (was.y() + own.y()), was.z()};
}

/// The energy of the header, summed edge by edge.
double energy_by_hand(const std::vector<MeshEdge>& edges, const PairPose& recorded, const PairPose& rebuilt,
                      const RelationWeights& weights, const PairPose& at) {
  double energy = 0;
  for (int j = 0; j < pair_vertex_count; ++j) {
    double total = 0;
    Eigen::RowVector3d residual = Eigen::RowVector3d::Zero();
    for (const MeshEdge& edge : edges) {
      if (edge[0] != j && edge[1] != j) continue;
      const int l = edge[0] == j ? edge[1] : edge[0];
      const Eigen::RowVector3d was = recorded.row(j) - recorded.row(l), own = rebuilt.row(j) - rebuilt.row(l);
      const double d = was.norm();
      const bool between = (j < joint_count) != (l < joint_count);
      const double share = between ? std::exp(-std::pow(d / weights.mesh_width_m, 2)) : 0;
      residual += (at.row(j) - at.row(l) - share * kept(j, l, recorded, rebuilt) - (1 - share) * own) / d;
      total += 1 / d;
    }
    energy += 0.5 * (residual / total).squaredNorm();
  }
  for (int a = 0; a < joint_count; ++a)
    for (int s = joint_count; s < pair_vertex_count; ++s) {
      const Eigen::RowVector3d was = recorded.row(a) - recorded.row(s);
      energy += 0.5 * relation_weight(weights, was.norm()) *
                (at.row(a) - at.row(s) - kept(a, s, recorded, rebuilt)).squaredNorm();
    }
  return energy;
}

TEST(SplitMesh, ItsQuadraticFormIsTheSumOverEdges) {
  std::mt19937 random(3);
  PairPose recorded = test::facing_pair(0.5);
  recorded.topRows<joint_count>() = test::shaken(recorded.topRows<joint_count>(), 0.03, random);
  const PairPose rebuilt = scaled_halves(recorded, 1.2, 0.9);
  const InteractionMesh mesh = tetrahedralize(recorded);
  const RelationWeights weights;
  SplitMesh split;
  split.build(mesh.edges, recorded, rebuilt, weights);
  const auto form = [&](const PairPose& at) {
    return 0.5 * (at.transpose() * split.energy() * at).trace() - (split.linear(1).transpose() * at).trace();
  };
  const auto by_hand = [&](const PairPose& at) {
    return energy_by_hand(mesh.edges, recorded, rebuilt, weights, at);
  };
  // Equal but for a constant.
  const double difference = form(recorded) - by_hand(recorded);
  for (const PairPose& at : {rebuilt, PairPose(1.1 * recorded), PairPose(0.5 * (rebuilt + recorded))})
    EXPECT_NEAR(form(at) - by_hand(at), difference, 1e-9);
}

TEST(SplitMesh, BodiesThatDoNotChangeAreAtItsMinimum) {
  const PairPose recorded = test::facing_pair(0.4);
  SplitMesh split;
  split.build(tetrahedralize(recorded).edges, recorded, recorded, {});
  for (const double fraction : {0.0, 0.5, 1.0})
    EXPECT_LT((split.energy() * recorded - split.linear(fraction)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SplitMesh, BeginsAtTheRebuiltPair) {
  const PairPose recorded = test::facing_pair(0.4);
  const PairPose rebuilt = scaled_halves(recorded, 1.3, 0.85);
  SplitMesh split;
  split.build(tetrahedralize(recorded).edges, recorded, rebuilt, {});
  EXPECT_LT((split.energy() * rebuilt - split.linear(0)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT((split.energy() * rebuilt - split.linear(1)).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(SplitMesh, ARelationFadesWithDistanceAndEndsWithoutAJump) {
  const RelationWeights weights;
  double before = relation_weight(weights, 0);
  const auto at_limit = [&weights](double width_m) {
    return std::exp(-std::pow(weights.far_m / width_m, 2));
  };
  EXPECT_NEAR(before,
              weights.contact * (1 - at_limit(weights.contact_width_m)) +
                  weights.near * (1 - at_limit(weights.near_width_m)),
              1e-12);
  for (double d = 0.01; d < weights.far_m; d += 0.01) {
    const double now = relation_weight(weights, d);
    EXPECT_LT(now, before);
    before = now;
  }
  EXPECT_LT(relation_weight(weights, weights.far_m - 1e-4), 1e-3) << "no jump";
  EXPECT_EQ(relation_weight(weights, weights.far_m), 0);
}

}  // namespace
}  // namespace abrazo::split_mesh_test
