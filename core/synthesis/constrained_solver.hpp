#pragma once

#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/mesh/laplacian.hpp"
#include "core/synthesis/constraints.hpp"
#include "core/synthesis/dual_system.hpp"

namespace abrazo {

/// Minimises 1/2 tr(V^T K V) - tr(R^T V) subject to hard rows H V = h (Eq. 11), for 50 vertices.
/// The three coordinates share K, so K is factored once as 50 x 50; the multipliers come from the Schur
/// complement S = H (K^-1 (x) I_3) H^T + eps I. The dual regularisation makes redundant rows harmless (two
/// feet pinned and their bones, say); one step of refinement takes out what eps leaves of the consistent
/// rows. Does not allocate after construction.
class ConstrainedSolver {
 public:
  static constexpr int max_rows = DualSystem::max_rows;

  ConstrainedSolver();

  /// @return false when K is not positive definite; nothing can be solved then
  bool set_energy(const VertexMatrix& energy);

  /// Forgets what stiffen() added.
  void relax();

  /// Adds c/2 |v_a - v_b - (a's minus b's place in the iterate)|^2 to the energy; the caller adds c times
  /// that difference to R. A rank-one change of K^-1.
  void stiffen(int a, int b, double c);
  /// 1 / |e_a - e_b|^2 in the metric of K^-1: how stiff the energy holds a against b.
  double stiffness(int a, int b) const;

  /// Equalities hold; of the inequalities those that bind do, found by a few active-set passes.
  /// @param linear       R, 50 x 3
  /// @param rows         at most max_rows
  /// @param[in,out] active  per row: whether it binds; read as the first guess for inequalities, equalities
  /// are always active
  /// @param[out] positions  V
  /// @return false when the result is not finite
  bool solve(const PairPose& linear, std::span<const ConstraintRow> rows, std::vector<char>& active,
             PairPose& positions);

  /// The nearest point to `from`, in the metric of K, at which the rows hold. @see solve
  bool project(const PairPose& from, std::span<const ConstraintRow> rows, std::vector<char>& active,
               PairPose& positions);

  /// Multiplier of a row after solve(); 0 for one that does not bind.
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
