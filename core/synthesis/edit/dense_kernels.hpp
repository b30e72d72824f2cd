#pragma once

#include <array>
#include <span>

namespace abrazo::dense {

// Small dense systems in padded columns, with AVX2 if available. Elements are summed in the same order and
// without fused multiply-add for every register width, so results are identical to the bit on all machines.
// `stride`: distance of columns.

inline constexpr int lanes = 4;
constexpr int padded(int n) {
  return (n + lanes - 1) / lanes * lanes;
}

/// L with L L^T = A, lower triangles, in place; elements above the diagonal are not read and are overwritten.
/// @param a padded(n) columns; rows and columns from n on are overwritten with neutral values
/// @param inverse_diagonal  1 / L_ii, padded(n)
/// @return false when A is not positive definite
bool factor(double* a, int n, int stride, double* inverse_diagonal);

/// x <- L^-1 x. @param x  padded(n), 0 from n on
void solve_lower(const double* l, int n, int stride, const double* inverse_diagonal, double* x);
/// x <- L^-T x. @see solve_lower
void solve_upper(const double* l, int n, int stride, const double* inverse_diagonal, double* x);

/// (L L^T)^-1, both triangles, in padded(n) columns.
void invert(const double* l, int n, int stride, const double* inverse_diagonal, double* inverse);

/// sum_i x_i y_i over padded(n).
double dot(const double* x, const double* y, int n);

/// y <- y + c x over padded(n).
void add(double c, const double* x, int n, double* y);

/// A <- A + x c^T, over padded(n) rows and columns.
void add_outer(const double* c, const double* x, int n, int stride, double* a);

/// Vectors of padded(n) with their weights.
struct Combination {
  std::array<const double*, 4> vectors{};
  std::array<double, 4> weights{};
  int count = 0;
};

/// y <- sum_k w_k x_k over padded(n).
void combine(const Combination& of, int n, double* y);
/// y_i <- (u . (a_0i, a_1i, a_2i)) sum_k w_k x_ki over padded(n).
void combine_scaled(const Combination& of, const double* u, const std::array<const double*, 3>& a, int n,
                    double* y);

/// y_a <- y_a + sum_c w_ac x_c for three sums of the same columns at once. @param columns  padded(n) each
void add_columns(std::span<const double* const> columns, const std::array<const double*, 3>& weights, int n,
                 const std::array<double*, 3>& y);

/// Register width of the kernels; both give identical bits. For tests and benchmarks.
enum class Width { Two, Four };
Width width();
/// Selects a width. @return false if the machine does not support it
bool use(Width width);

}  // namespace abrazo::dense
