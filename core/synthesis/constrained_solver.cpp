#include "core/synthesis/constrained_solver.hpp"

#include <stdexcept>

namespace abrazo {

namespace {

constexpr double dual_regularisation = 1e-9;
constexpr double violation_tolerance_m = 1e-6;
constexpr int active_set_passes = 3;

PairPose spread_of(const ConstraintRow& row, const VertexMatrix& inverse) {
  PairPose spread = PairPose::Zero();
  for (int i = 0; i < row.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    spread.noalias() += inverse.col(row.vertices[at]) * row.coefficients[at].transpose();
  }
  return spread;
}

}  // namespace

ConstrainedSolver::ConstrainedSolver()
    : spread_(max_rows),
      spread_known_(max_rows),
      dual_(max_rows, max_rows),
      dual_factor_(max_rows, max_rows),
      right_(max_rows),
      multipliers_(max_rows) {
  used_.reserve(max_rows);
}

bool ConstrainedSolver::set_energy(const VertexMatrix& energy) {
  energy_factor_.compute(energy);
  if (energy_factor_.info() != Eigen::Success) return false;
  energy_inverse_ = energy_factor_.solve(VertexMatrix::Identity());
  relax();
  return inverse_.allFinite();
}

void ConstrainedSolver::relax() {
  inverse_ = energy_inverse_;
}

void ConstrainedSolver::stiffen(int a, int b, double c) {
  // Sherman-Morrison with e = e_a - e_b.
  const Eigen::Matrix<double, pair_vertex_count, 1> column = inverse_.col(a) - inverse_.col(b);
  const double compliance = column(a) - column(b);
  inverse_.noalias() -= (c / (1.0 + c * compliance)) * column * column.transpose();
}

double ConstrainedSolver::stiffness(int a, int b) const {
  return 1.0 / (inverse_(a, a) + inverse_(b, b) - 2.0 * inverse_(a, b));
}

bool ConstrainedSolver::solve(const PairPose& linear, std::span<const ConstraintRow> rows,
                              std::vector<char>& active, PairPose& positions) {
  unconstrained_.noalias() = inverse_ * linear;
  return solve_from_unconstrained(rows, active, positions);
}

bool ConstrainedSolver::project(const PairPose& from, std::span<const ConstraintRow> rows,
                                std::vector<char>& active, PairPose& positions) {
  unconstrained_ = from;
  return solve_from_unconstrained(rows, active, positions);
}

bool ConstrainedSolver::solve_from_unconstrained(std::span<const ConstraintRow> rows,
                                                 std::vector<char>& active, PairPose& positions) {
  if (rows.size() > max_rows)
    throw std::invalid_argument("ConstrainedSolver: more than max_rows constraint rows");
  active.resize(rows.size(), 0);
  std::fill(spread_known_.begin(), spread_known_.end(), char{0});
  bool any_inequality = false;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (!rows[r].inequality) active[r] = 1;
    any_inequality |= rows[r].inequality;
  }
  for (int pass = 0;; ++pass) {
    if (!solve_active(rows, active, positions)) return false;
    if (!any_inequality || pass == active_set_passes) return true;
    bool changed = false;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (!rows[r].inequality) continue;
      const bool binds =
          active[r] ? multipliers_[r] > 0 : rows[r].value(positions) < rows[r].target - violation_tolerance_m;
      // A row let go in the last pass could be violated by the answer: the last pass only adds.
      if (pass == active_set_passes - 1 && active[r]) continue;
      changed |= binds != (active[r] != 0);
      active[r] = binds ? 1 : 0;
    }
    if (!changed) return true;
  }
}

bool ConstrainedSolver::factor_dual(int count) {
  for (double regularisation = dual_regularisation; regularisation < 1e-2; regularisation *= 1e3) {
    Eigen::Ref<Eigen::MatrixXd> corner = dual_factor_.topLeftCorner(count, count);
    corner.triangularView<Eigen::Lower>() = dual_.topLeftCorner(count, count);
    corner.diagonal().array() += regularisation;
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(corner);
    if (in_place.info() == Eigen::Success) return true;
  }
  return false;
}

void ConstrainedSolver::solve_dual(int count) {
  const auto lower = dual_factor_.topLeftCorner(count, count).triangularView<Eigen::Lower>();
  lower.solveInPlace(right_.head(count));
  lower.transpose().solveInPlace(right_.head(count));
}

bool ConstrainedSolver::solve_active(std::span<const ConstraintRow> rows, const std::vector<char>& active,
                                     PairPose& positions) {
  used_.clear();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    multipliers_[r] = 0;
    if (!active[r]) continue;
    used_.push_back(static_cast<int>(r));
    if (!spread_known_[r]) spread_[r] = spread_of(rows[r], inverse_);
    spread_known_[r] = 1;
  }
  const int count = static_cast<int>(used_.size());
  positions = unconstrained_;
  if (count == 0) return positions.allFinite();

  for (int c = 0; c < count; ++c) {
    const PairPose& spread = spread_[static_cast<std::size_t>(used_[static_cast<std::size_t>(c)])];
    for (int r = c; r < count; ++r)
      dual_(r, c) = rows[static_cast<std::size_t>(used_[static_cast<std::size_t>(r)])].value(spread);
  }
  if (!factor_dual(count)) return false;

  // The first turn solves; the second takes out the residual that the regularisation leaves.
  for (int turn = 0; turn < 2; ++turn) {
    for (int r = 0; r < count; ++r) {
      const ConstraintRow& row = rows[static_cast<std::size_t>(used_[static_cast<std::size_t>(r)])];
      right_(r) = row.target - row.value(positions);
    }
    solve_dual(count);
    for (int r = 0; r < count; ++r) {
      const auto row = static_cast<std::size_t>(used_[static_cast<std::size_t>(r)]);
      positions.noalias() += right_(r) * spread_[row];
      multipliers_[row] += right_(r);
    }
  }
  return positions.allFinite();
}

}  // namespace abrazo
