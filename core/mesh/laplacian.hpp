#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

#include "core/mesh/interaction_mesh.hpp"

namespace abrazo {

/// Weights of the neighbours of a vertex; d is the distance in the reference pose.
enum class EdgeWeights {
  Inverse,      ///< w_jl = (1/d_jl) / sum_k (1/d_jk): weights of a vertex add up to 1
  InverseMean,  ///< w_jl = 1 / (n_j d_jl) [1/m]: not normalised, so energies depend on the length unit
  Uniform       ///< w_jl = 1 / n_j
};

using VertexMatrix = Eigen::Matrix<double, pair_vertex_count, pair_vertex_count>;

/// Laplacian coordinates of a pair under a mesh, with weights frozen at a reference pose:
///   L(v_j) = sum_{l in N(j)} w_jl (v_j - v_l),   as a matrix L(V) = M V.
/// Zero for a translation of everything; not invariant under rotation. Source: Ho, Komura, Tai 2010.
/// Fixed size: rebuilding it for another mesh does not allocate.
class Laplacian {
 public:
  /// Distances below 1 mm count as 1 mm, so that touching joints do not get all the weight.
  void build(std::span<const MeshEdge> edges, const PairPose& reference, EdgeWeights weights);

  double weight(int vertex, int neighbour) const { return weights_(vertex, neighbour); }
  const VertexMatrix& gram() const { return gram_; }  ///< M^T M

  /// Laplacian coordinates M V [m; dimensionless for InverseMean].
  PairPose apply(const PairPose& positions) const;

  /// E_L = 1/2 sum_j |L(reference_j) - L(v_j)|^2.
  double deformation_energy(const PairPose& positions, const PairPose& reference) const;

 private:
  Eigen::Matrix<double, pair_vertex_count, pair_vertex_count, Eigen::RowMajor> weights_;
  std::array<std::array<std::uint8_t, pair_vertex_count>, pair_vertex_count> neighbours_{};
  std::array<std::uint8_t, pair_vertex_count> neighbour_count_{};
  Eigen::Matrix<double, pair_vertex_count, 1> diagonal_;  ///< sum of a vertex's weights
  VertexMatrix gram_;
};

}  // namespace abrazo
