#pragma once

#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/mesh/laplacian.hpp"
#include "core/synthesis/edit/constraints.hpp"
#include "core/synthesis/edit/dual_system.hpp"

namespace abrazo {

/// Minimises 1/2 tr(V^T K V) - tr(R^T V) subject to hard rows H V = h (Eq. 11), for 50 vertices.
/// The three coordinates share K, so K is factored once as 50 x 50; the multipliers come from the Schur
/// complement S = H (K^-1 (x) I_3) H^T + eps I. The dual regularisation makes redundant rows harmless (two
/// feet pinned and their bones, say); one step of iterative refinement removes the residual that eps leaves
/// in consistent rows. Does not allocate after construction.
class ConstrainedSolver {
 public:
  static constexpr int max_rows = DualSystem::max_rows;

  ConstrainedSolver();

  /// @return false if K is not positive definite; nothing can be solved then
  bool set_energy(const VertexMatrix& energy);

  /// Removes everything that stiffen() added.
  void relax();

  /// Adds c/2 |v_a - v_b - d|^2 to the energy, with d = v_a - v_b at the iterate; the caller adds c d to R. A
  /// rank-one change of K^-1.
  void stiffen(int a, int b, double c);
  /// 1 / |e_a - e_b|^2 in the metric of K^-1: the stiffness of the energy between a and b.
  double stiffness(int a, int b) const;

  /// Solves with all equalities and the binding inequalities, found by a few active-set passes.
  /// @param linear       R, 50 x 3
  /// @param rows         at most max_rows
  /// @param[in,out] active per row: whether it binds; initial guess for inequalities on input, equalities are
  /// always active
  /// @param[out] positions  V
  /// @return false if the result is not finite
  bool solve(const PairPose& linear, std::span<const ConstraintRow> rows, std::vector<char>& active,
             PairPose& positions);

  /// The point nearest to `from` in the metric of K that satisfies the rows. @see solve
  bool project(const PairPose& from, std::span<const ConstraintRow> rows, std::vector<char>& active,
               PairPose& positions);

  /// Multiplier of a row after solve(); 0 for a row that does not bind.
  double multiplier(std::size_t row) const { return multipliers_[row]; }

 private:
  bool solve_from_unconstrained(std::span<const ConstraintRow> rows, std::vector<char>& active,
                                PairPose& positions);
  bool solve_active(std::span<const ConstraintRow> rows, const std::vector<char>& active);
  bool should_bind(const ConstraintRow& row, bool binds, double multiplier) const;

  PaddedMatrix energy_inverse_;
  PaddedMatrix inverse_;  ///< energy_inverse_ with what stiffen() added
  VertexColumns unconstrained_;
  VertexColumns solved_;
  DualSystem dual_;
  std::vector<double> multipliers_;
};

}  // namespace abrazo
