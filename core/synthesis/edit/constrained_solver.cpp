#include "core/synthesis/edit/constrained_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace abrazo {

namespace {

constexpr double violation_tolerance_m = 1e-6;
constexpr int active_set_passes = 3;

bool is_finite(const VertexColumns& columns) {
  return std::all_of(columns.axis.begin(), columns.axis.end(), [](const VertexNumbers& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  });
}

}  // namespace

ConstrainedSolver::ConstrainedSolver() : energy_inverse_{}, inverse_{}, multipliers_(max_rows) {}

bool ConstrainedSolver::set_energy(const VertexMatrix& energy) {
  PaddedMatrix factor;
  for (int column = 0; column < pair_vertex_count; ++column)
    for (int row = column; row < pair_vertex_count; ++row)
      factor[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] = energy(row, column);
  VertexNumbers inverse_diagonal;
  double* const first = factor.front().data();
  if (!dense::factor(first, pair_vertex_count, padded_vertices, inverse_diagonal.data())) return false;
  dense::invert(first, pair_vertex_count, padded_vertices, inverse_diagonal.data(),
                energy_inverse_.front().data());
  relax();
  return std::all_of(inverse_.begin(), inverse_.end(), [](const VertexNumbers& column) {
    return std::all_of(column.begin(), column.end(), [](double x) { return std::isfinite(x); });
  });
}

void ConstrainedSolver::relax() {
  inverse_ = energy_inverse_;
}

void ConstrainedSolver::stiffen(int a, int b, double c) {
  // Sherman-Morrison with e = e_a - e_b.
  const auto at_a = static_cast<std::size_t>(a);
  const auto at_b = static_cast<std::size_t>(b);
  VertexNumbers column = inverse_[at_a];
  dense::add(-1, inverse_[at_b].data(), padded_vertices, column.data());
  const double share = c / (1.0 + c * (column[at_a] - column[at_b]));
  VertexNumbers shares;
  for (std::size_t v = 0; v < shares.size(); ++v) shares[v] = -share * column[v];
  dense::add_outer(shares.data(), column.data(), padded_vertices, padded_vertices, inverse_.front().data());
}

double ConstrainedSolver::stiffness(int a, int b) const {
  const VertexNumbers& column_a = inverse_[static_cast<std::size_t>(a)];
  const VertexNumbers& column_b = inverse_[static_cast<std::size_t>(b)];
  return 1.0 / (column_a[static_cast<std::size_t>(a)] + column_b[static_cast<std::size_t>(b)] -
                2.0 * column_b[static_cast<std::size_t>(a)]);
}

bool ConstrainedSolver::solve(const PairPose& linear, std::span<const ConstraintRow> rows,
                              std::vector<char>& active, PairPose& positions) {
  VertexColumns right;
  right.set(linear);
  std::array<const double*, pair_vertex_count> columns;
  for (std::size_t v = 0; v < columns.size(); ++v) columns[v] = inverse_[v].data();
  unconstrained_ = {};
  unconstrained_.add(columns, {right.axis[0].data(), right.axis[1].data(), right.axis[2].data()});
  return solve_from_unconstrained(rows, active, positions);
}

bool ConstrainedSolver::project(const PairPose& from, std::span<const ConstraintRow> rows,
                                std::vector<char>& active, PairPose& positions) {
  unconstrained_.set(from);
  return solve_from_unconstrained(rows, active, positions);
}

bool ConstrainedSolver::solve_from_unconstrained(std::span<const ConstraintRow> rows,
                                                 std::vector<char>& active, PairPose& positions) {
  if (rows.size() > max_rows)
    throw std::invalid_argument("ConstrainedSolver: more than max_rows constraint rows");
  active.resize(rows.size(), 0);
  bool any_inequality = false;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (!rows[r].inequality) active[r] = 1;
    any_inequality |= rows[r].inequality;
  }
  dual_.set(rows, inverse_);
  for (int pass = 0;; ++pass) {
    if (!solve_active(rows, active)) return false;
    bool changed = false;
    // A row released in the last pass could be violated by the result: the last pass only adds rows.
    const bool only_adds = pass == active_set_passes - 1;
    for (std::size_t r = 0; any_inequality && pass < active_set_passes && r < rows.size(); ++r) {
      if (!rows[r].inequality || (only_adds && active[r])) continue;
      const bool binds = should_bind(rows[r], active[r] != 0, multipliers_[r]);
      changed |= binds != (active[r] != 0);
      active[r] = binds ? 1 : 0;
    }
    if (!changed) break;
  }
  positions = solved_.get();
  return true;
}

bool ConstrainedSolver::should_bind(const ConstraintRow& row, bool binds, double multiplier) const {
  return binds ? multiplier > 0 : solved_.value_of(row) < row.target - violation_tolerance_m;
}

bool ConstrainedSolver::solve_active(std::span<const ConstraintRow> rows, const std::vector<char>& active) {
  std::fill_n(multipliers_.begin(), rows.size(), 0.0);
  if (!dual_.factor(active)) return false;
  solved_ = unconstrained_;
  // The first turn solves; the second takes out the residual that the regularisation leaves.
  for (int turn = 0; turn < 2; ++turn) dual_.correct(solved_, multipliers_);
  return is_finite(solved_);
}

}  // namespace abrazo
