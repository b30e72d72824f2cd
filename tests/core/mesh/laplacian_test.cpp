#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/mesh/laplacian.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::laplacian_test {
namespace {

struct Case {
  PairPose reference = test::facing_pair(0.6);
  InteractionMesh mesh;
  Laplacian laplacian;
  explicit Case(EdgeWeights weights = EdgeWeights::Inverse) {
    std::mt19937 random(2);
    reference.topRows<joint_count>() = test::shaken(reference.topRows<joint_count>(), 0.03, random);
    mesh = tetrahedralize(reference);
    laplacian.build(mesh.edges, reference, weights);
  }
};

/// M written down from its definition, entry by entry.
Eigen::MatrixXd dense_operator(const Case& c, EdgeWeights weights) {
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(pair_vertex_count, pair_vertex_count);
  for (int j = 0; j < pair_vertex_count; ++j) {
    std::vector<std::pair<int, double>> inverse_distances;
    for (const MeshEdge& edge : c.mesh.edges) {
      if (edge[0] != j && edge[1] != j) continue;
      const int l = edge[0] == j ? edge[1] : edge[0];
      inverse_distances.emplace_back(l, 1.0 / (c.reference.row(j) - c.reference.row(l)).norm());
    }
    double sum = 0;
    for (const auto& [l, w] : inverse_distances) sum += w;
    const auto n = static_cast<double>(inverse_distances.size());
    for (const auto& [l, inverse] : inverse_distances) {
      const double w = weights == EdgeWeights::Inverse       ? inverse / sum
                       : weights == EdgeWeights::InverseMean ? inverse / n
                                                             : 1 / n;
      m(j, l) -= w;
      m(j, j) += w;
    }
  }
  return m;
}

class EveryWeighting : public testing::TestWithParam<EdgeWeights> {};
INSTANTIATE_TEST_SUITE_P(Laplacian, EveryWeighting,
                         testing::Values(EdgeWeights::Inverse, EdgeWeights::InverseMean,
                                         EdgeWeights::Uniform));

TEST_P(EveryWeighting, CoordinatesAndGramMatrixFollowTheDefinition) {
  const Case c(GetParam());
  const Eigen::MatrixXd m = dense_operator(c, GetParam());
  EXPECT_LT((c.laplacian.apply(c.reference) - m * c.reference).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((c.laplacian.gram() - m.transpose() * m).cwiseAbs().maxCoeff(), 1e-10);
}

TEST_P(EveryWeighting, ATranslationOfBothBodiesCostsNothing) {
  const Case c(GetParam());
  PairPose moved = c.reference;
  moved.rowwise() += Eigen::RowVector3d(3, -1, 2);
  EXPECT_NEAR(c.laplacian.deformation_energy(moved, c.reference), 0, 1e-20);
}

TEST_P(EveryWeighting, EnergyGradientMatchesFiniteDifferences) {
  const Case c(GetParam());
  std::mt19937 random(9);
  PairPose at = c.reference;
  at.bottomRows<joint_count>() = test::shaken(at.bottomRows<joint_count>(), 0.1, random);
  const PairPose gradient = c.laplacian.gram() * (at - c.reference);
  constexpr double h = 1e-5;
  for (int v = 0; v < pair_vertex_count; v += 7)
    for (int axis = 0; axis < 3; ++axis) {
      PairPose more = at;
      PairPose less = at;
      more(v, axis) += h;
      less(v, axis) -= h;
      const double slope = (c.laplacian.deformation_energy(more, c.reference) -
                            c.laplacian.deformation_energy(less, c.reference)) /
                           (2 * h);
      EXPECT_NEAR(gradient(v, axis), slope, 1e-7 * (1 + std::abs(slope)));
    }
}

TEST(Laplacian, InverseWeightsOfAVertexAddUpToOne) {
  const Case c;
  for (int j = 0; j < pair_vertex_count; ++j) {
    double sum = 0;
    for (int l = 0; l < pair_vertex_count; ++l) sum += l == j ? 0 : c.laplacian.weight(j, l);
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(Laplacian, ATouchingNeighbourDoesNotTakeAllTheWeight) {
  Case c;
  c.reference.row(joint_count) = c.reference.row(0);  // one joint of each body in the same place
  std::vector<MeshEdge> edges = {{0, 1}, {0, joint_count}};
  c.laplacian.build(edges, c.reference, EdgeWeights::Inverse);
  EXPECT_TRUE(c.laplacian.gram().allFinite());
  EXPECT_GT(c.laplacian.weight(0, 1), 0.001);
}

TEST(Laplacian, ARotationIsCharged) {
  const Case c;
  const PairPose turned = c.reference * Eigen::AngleAxisd(0.3, Vec3::UnitY()).toRotationMatrix().transpose();
  EXPECT_GT(c.laplacian.deformation_energy(turned, c.reference), 1e-3);
}

}  // namespace
}  // namespace abrazo::laplacian_test
