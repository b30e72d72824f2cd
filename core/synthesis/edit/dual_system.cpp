#include "core/synthesis/edit/dual_system.hpp"

#include <algorithm>

namespace abrazo {

namespace {

constexpr double least_regularisation = 1e-9;
constexpr double most_regularisation = 1e-2;
constexpr double regularisation_step = 1e3;

/// w^T n
double weighed(const ConstraintRow& row, const VertexNumbers& numbers) {
  double sum = 0;
  for (int i = 0; i < row.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    sum += row.weights[at] * numbers[static_cast<std::size_t>(row.vertices[at])];
  }
  return sum;
}

/// Rows of a matrix with one in a piece for each vertex, as a row of H weighs them.
dense::Combination combination(const ConstraintRow& row, const double* rows, int stride) {
  dense::Combination of;
  of.count = row.count;
  of.weights = row.weights;
  for (int i = 0; i < row.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    of.vectors[at] = rows + row.vertices[at] * stride;
  }
  return of;
}

}  // namespace

void VertexColumns::set(const PairPose& positions) {
  for (int vertex = 0; vertex < pair_vertex_count; ++vertex)
    for (int a = 0; a < 3; ++a)
      axis[static_cast<std::size_t>(a)][static_cast<std::size_t>(vertex)] = positions(vertex, a);
}

PairPose VertexColumns::get() const {
  PairPose positions;
  for (int vertex = 0; vertex < pair_vertex_count; ++vertex)
    for (int a = 0; a < 3; ++a)
      positions(vertex, a) = axis[static_cast<std::size_t>(a)][static_cast<std::size_t>(vertex)];
  return positions;
}

void VertexColumns::add(std::span<const double* const> columns, const std::array<const double*, 3>& weights) {
  dense::add_columns(columns, weights, padded_vertices, {axis[0].data(), axis[1].data(), axis[2].data()});
}

double VertexColumns::value_of(const ConstraintRow& row) const {
  return row.direction.dot(Vec3(weighed(row, axis[0]), weighed(row, axis[1]), weighed(row, axis[2])));
}

void DualSystem::Factor::solve_lower(int size, double* x) const {
  dense::solve_lower(columns.data(), size, max_rows, inverse_diagonal.data(), x);
}

void DualSystem::Factor::solve_upper(int size, double* x) const {
  dense::solve_upper(columns.data(), size, max_rows, inverse_diagonal.data(), x);
}

DualSystem::DualSystem()
    : spreads_(max_rows),
      known_(max_rows),
      by_vertex_(static_cast<std::size_t>(padded_vertices * max_rows)),
      couplings_(static_cast<std::size_t>(max_rows * max_rows)),
      right_(max_rows),
      rest_right_(max_rows) {
  static_assert(dense::padded(max_rows) == max_rows);
  equalities_.reserve(max_rows);
  rest_.reserve(max_rows);
  moved_.reserve(max_rows);
  for (auto& axis : directions_) axis.resize(max_rows);
  for (auto& axis : moves_) axis.resize(max_rows);
  for (Factor* factor : {&equalities_factor_, &rest_factor_}) {
    factor->columns.resize(static_cast<std::size_t>(max_rows * max_rows));
    factor->inverse_diagonal.resize(max_rows);
  }
}

void DualSystem::set(std::span<const ConstraintRow> rows, const PaddedMatrix& inverse) {
  rows_ = rows;
  inverse_ = &inverse;
  equalities_.clear();
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (!rows[r].inequality) equalities_.push_back(static_cast<int>(r));
  for (const int row : equalities_) spread(row);
  gather_equalities();
  regularisation_ = 0;
}

void DualSystem::spread(int row) {
  const ConstraintRow& of = rows_[static_cast<std::size_t>(row)];
  dense::combine(combination(of, inverse_->front().data(), padded_vertices), padded_vertices,
                 spreads_[static_cast<std::size_t>(row)].data());
}

void DualSystem::gather_equalities() {
  static constexpr VertexNumbers nothing{};
  const auto count = static_cast<std::size_t>(equality_count());
  const auto size = static_cast<std::size_t>(dense::padded(equality_count()));
  for (std::size_t first = 0; first < size; first += dense::lanes) {
    std::array<const double*, dense::lanes> numbers;
    for (std::size_t lane = 0; lane < numbers.size(); ++lane) {
      const std::size_t c = first + lane;
      const auto row = static_cast<std::size_t>(c < count ? equalities_[c] : 0);
      numbers[lane] = c < count ? spreads_[row].data() : nothing.data();
      for (std::size_t a = 0; a < 3; ++a)
        directions_[a][c] = c < count ? rows_[row].direction(static_cast<Eigen::Index>(a)) : 0;
    }
    double* to = by_vertex_.data() + first;
    for (std::size_t vertex = 0; vertex < pair_vertex_count; ++vertex, to += max_rows)
      for (std::size_t lane = 0; lane < numbers.size(); ++lane) to[lane] = numbers[lane][vertex];
  }
}

/// Of S, without eps: entries of the equalities from `first` on.
void DualSystem::dual_column(const ConstraintRow& row, int first, double* column) const {
  const int from = first / dense::lanes * dense::lanes;
  const int size = dense::padded(equality_count()) - from;
  if (size <= 0) return;
  dense::combine_scaled(
      combination(row, by_vertex_.data() + from, max_rows), row.direction.data(),
      {directions_[0].data() + from, directions_[1].data() + from, directions_[2].data() + from}, size,
      column + from);
}

bool DualSystem::factor_equalities() {
  for (int c = 0; c < equality_count(); ++c) {
    double* column = equalities_factor_.column(c);
    dual_column(rows_[static_cast<std::size_t>(equalities_[static_cast<std::size_t>(c)])], c, column);
    column[c] += regularisation_;
  }
  std::fill(known_.begin(), known_.end(), char{0});
  return equalities_factor_.factor(equality_count());
}

void DualSystem::couple(int row) {
  if (known_[static_cast<std::size_t>(row)]) return;
  known_[static_cast<std::size_t>(row)] = 1;
  spread(row);
  dual_column(rows_[static_cast<std::size_t>(row)], 0, coupling(row));
  equalities_factor_.solve_lower(equality_count(), coupling(row));
}

bool DualSystem::factor_rest() {
  const int size = dense::padded(equality_count());
  for (const int row : rest_) couple(row);
  for (std::size_t c = 0; c < rest_.size(); ++c) {
    const ConstraintRow& one = rows_[static_cast<std::size_t>(rest_[c])];
    const VertexNumbers& spread = spreads_[static_cast<std::size_t>(rest_[c])];
    double* column = rest_factor_.column(static_cast<int>(c));
    for (std::size_t r = c; r < rest_.size(); ++r) {
      const ConstraintRow& other = rows_[static_cast<std::size_t>(rest_[r])];
      column[r] = one.direction.dot(other.direction) * weighed(other, spread) -
                  dense::dot(coupling(rest_[c]), coupling(rest_[r]), size);
    }
    column[c] += regularisation_;
  }
  return rest_factor_.factor(static_cast<int>(rest_.size()));
}

bool DualSystem::factor(const std::vector<char>& active) {
  rest_.clear();
  for (std::size_t r = 0; r < rows_.size(); ++r)
    if (rows_[r].inequality && active[r]) rest_.push_back(static_cast<int>(r));
  if (regularisation_ > 0 && factor_rest()) return true;
  double next = regularisation_ > 0 ? regularisation_ * regularisation_step : least_regularisation;
  for (; next < most_regularisation; next *= regularisation_step) {
    regularisation_ = next;
    if (factor_equalities() && factor_rest()) return true;
  }
  return false;
}

void DualSystem::correct(VertexColumns& positions, std::vector<double>& multipliers) {
  const int size = equality_count();
  std::fill_n(right_.begin(), dense::padded(size), 0.0);
  std::fill_n(rest_right_.begin(), dense::padded(static_cast<int>(rest_.size())), 0.0);
  const auto residual = [&](int row) {
    const ConstraintRow& of = rows_[static_cast<std::size_t>(row)];
    return of.target - positions.value_of(of);
  };
  std::transform(equalities_.begin(), equalities_.end(), right_.begin(), residual);
  std::transform(rest_.begin(), rest_.end(), rest_right_.begin(), residual);

  equalities_factor_.solve_lower(size, right_.data());
  for (std::size_t c = 0; c < rest_.size(); ++c)
    rest_right_[c] -= dense::dot(coupling(rest_[c]), right_.data(), dense::padded(size));
  rest_factor_.solve_lower(static_cast<int>(rest_.size()), rest_right_.data());
  rest_factor_.solve_upper(static_cast<int>(rest_.size()), rest_right_.data());
  for (std::size_t c = 0; c < rest_.size(); ++c)
    dense::add(-rest_right_[c], coupling(rest_[c]), dense::padded(size), right_.data());
  equalities_factor_.solve_upper(size, right_.data());

  moved_.clear();
  const auto apply = [&](int row, double change) {
    const auto at = static_cast<std::size_t>(row);
    for (std::size_t a = 0; a < 3; ++a)
      moves_[a][moved_.size()] = change * rows_[at].direction(static_cast<Eigen::Index>(a));
    moved_.push_back(spreads_[at].data());
    multipliers[at] += change;
  };
  for (std::size_t c = 0; c < equalities_.size(); ++c) apply(equalities_[c], right_[c]);
  for (std::size_t c = 0; c < rest_.size(); ++c) apply(rest_[c], rest_right_[c]);
  positions.add(moved_, {moves_[0].data(), moves_[1].data(), moves_[2].data()});
}

}  // namespace abrazo
