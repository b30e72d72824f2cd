#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/synthesis/edit/constraints.hpp"
#include "core/synthesis/edit/dense_kernels.hpp"

namespace abrazo {

/// One number per vertex, padded for the dense kernels; entries from 50 on are 0.
inline constexpr int padded_vertices = dense::padded(pair_vertex_count);
using VertexNumbers = std::array<double, padded_vertices>;
/// A symmetric 50 x 50 matrix in padded columns.
using PaddedMatrix = std::array<VertexNumbers, padded_vertices>;

/// x, y and z of the vertices, each contiguous [m].
struct VertexColumns {
  std::array<VertexNumbers, 3> axis{};

  void set(const PairPose& positions);
  PairPose get() const;
  /// axis a += sum_c weights[a][c] columns[c], columns of padded_vertices
  void add(std::span<const double* const> columns, const std::array<const double*, 3>& weights);
  double value_of(const ConstraintRow& row) const;
};

/// S = H (K^-1 (x) I_3) H^T + eps I for the binding rows, and the corrections that satisfy them. A row of H
/// is weights w of vertices along one direction u, so S_rs = (u_r . u_s) (w_r^T K^-1 w_s). The equalities'
/// part is factored once; inequalities are added and removed by its Schur complement. Does not allocate after
/// construction.
class DualSystem {
 public:
  static constexpr int max_rows = 176;

  DualSystem();

  /// Sets rows and K^-1; both must outlive the next call.
  void set(std::span<const ConstraintRow> rows, const PaddedMatrix& inverse);

  /// @param active per row; ignored for equalities, which always bind
  /// @return false when S is not positive definite, not even with a large eps
  bool factor(const std::vector<char>& active);

  /// Moves the positions by the smallest amount in the metric of K so that the binding rows hold up to eps
  /// times their multipliers. Adds the multipliers up per row.
  void correct(VertexColumns& positions, std::vector<double>& multipliers);

 private:
  /// A triangular factor in padded columns with stride max_rows.
  struct Factor {
    std::vector<double> columns;
    std::vector<double> inverse_diagonal;
    double* column(int at) { return columns.data() + at * max_rows; }
    bool factor(int size) { return dense::factor(columns.data(), size, max_rows, inverse_diagonal.data()); }
    void solve_lower(int size, double* x) const;
    void solve_upper(int size, double* x) const;
  };

  void spread(int row);
  void gather_equalities();
  void dual_column(const ConstraintRow& row, int first, double* column) const;
  bool factor_equalities();
  bool factor_rest();
  void couple(int row);
  double* coupling(int row) { return couplings_.data() + row * max_rows; }
  int equality_count() const { return static_cast<int>(equalities_.size()); }

  std::span<const ConstraintRow> rows_;
  const PaddedMatrix* inverse_ = nullptr;
  std::vector<int> equalities_;         ///< rows, in order
  std::vector<int> rest_;               ///< binding inequalities, in order
  double regularisation_ = 0;           ///< eps
  std::vector<VertexNumbers> spreads_;  ///< per row: K^-1 w
  std::vector<char> known_;             ///< per inequality: whether its spread and coupling are computed
  std::vector<double> by_vertex_;       ///< spreads of the equalities, contiguous per vertex
  std::array<std::vector<double>, 3> directions_;  ///< of the equalities, contiguous per axis
  Factor equalities_factor_;
  std::vector<double> couplings_;  ///< per inequality: L^-1 times its column of S, with L of the equalities
  Factor rest_factor_;             ///< of the Schur complement
  std::vector<double> right_;      ///< of the equalities
  std::vector<double> rest_right_;
  std::vector<const double*> moved_;          ///< spreads of the binding rows
  std::array<std::vector<double>, 3> moves_;  ///< their weights
};

}  // namespace abrazo
