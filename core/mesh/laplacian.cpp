#include "core/mesh/laplacian.hpp"

#include <algorithm>

namespace abrazo {

namespace {
constexpr double shortest_edge_m = 1e-3;
}

void Laplacian::build(std::span<const MeshEdge> edges, const PairPose& reference, EdgeWeights weights) {
  weights_.setZero();
  neighbour_count_.fill(0);
  for (const MeshEdge& edge : edges) {
    const double d = std::max(shortest_edge_m, (reference.row(edge[0]) - reference.row(edge[1])).norm());
    const double w = weights == EdgeWeights::Uniform ? 1.0 : 1.0 / d;
    weights_(edge[0], edge[1]) = weights_(edge[1], edge[0]) = w;
    neighbours_[edge[0]][neighbour_count_[edge[0]]++] = edge[1];
    neighbours_[edge[1]][neighbour_count_[edge[1]]++] = edge[0];
  }
  for (int j = 0; j < pair_vertex_count; ++j) {
    const auto n = neighbour_count_[static_cast<std::size_t>(j)];
    const double scale = weights == EdgeWeights::Inverse ? weights_.row(j).sum() : n;
    if (n > 0) weights_.row(j) /= scale;
    diagonal_(j) = weights_.row(j).sum();
  }
  // M has about a dozen entries in a row: the product is summed over those alone, for its lower triangle.
  gram_.setZero();
  const auto add = [&](int a, int b, double product) { gram_(std::max(a, b), std::min(a, b)) += product; };
  for (int j = 0; j < pair_vertex_count; ++j) {
    const auto& around = neighbours_[static_cast<std::size_t>(j)];
    const int n = neighbour_count_[static_cast<std::size_t>(j)];
    const double own = diagonal_(j);
    std::array<double, pair_vertex_count> shares;
    for (int a = 0; a < n; ++a)
      shares[static_cast<std::size_t>(a)] = weights_(j, around[static_cast<std::size_t>(a)]);
    gram_(j, j) += own * own;
    for (int a = 0; a < n; ++a) {
      const int va = around[static_cast<std::size_t>(a)];
      const double wa = shares[static_cast<std::size_t>(a)];
      add(j, va, -(own * wa));
      for (int b = 0; b <= a; ++b)
        add(va, around[static_cast<std::size_t>(b)], wa * shares[static_cast<std::size_t>(b)]);
    }
  }
  for (int column = 1; column < pair_vertex_count; ++column)
    for (int row = 0; row < column; ++row) gram_(row, column) = gram_(column, row);
}

PairPose Laplacian::apply(const PairPose& positions) const {
  PairPose result;
  for (int j = 0; j < pair_vertex_count; ++j) {
    Eigen::RowVector3d sum = diagonal_(j) * positions.row(j);
    const auto& around = neighbours_[static_cast<std::size_t>(j)];
    for (int a = 0; a < neighbour_count_[static_cast<std::size_t>(j)]; ++a) {
      const int v = around[static_cast<std::size_t>(a)];
      sum -= weights_(j, v) * positions.row(v);
    }
    result.row(j) = sum;
  }
  return result;
}

double Laplacian::deformation_energy(const PairPose& positions, const PairPose& reference) const {
  return 0.5 * apply(positions - reference).squaredNorm();
}

}  // namespace abrazo
