#pragma once

#include <array>
#include <span>

namespace abrazo::dense {

// Small dense systems in padded columns, with AVX2 where the machine has it. Every element is summed up in
// the same order and without fused steps whatever the width of the registers: results are the same bits on
// all of them. `stride`: from one column to the next.

inline constexpr int lanes = 4;
constexpr int padded(int n) {
  return (n + lanes - 1) / lanes * lanes;
}

/// L with L L^T = A, lower triangles, in place; what is above the diagonal is not read and not kept.
/// @param a  padded(n) columns; rows and columns from n on are overwritten so that they do no harm
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

/// Vectors of padded(n) and what each is multiplied with.
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

/// Which of the two ways is taken on this machine; both give the same bits. For tests and figures.
enum class Width { Two, Four };
Width width();
/// The way from now on. @return false when the machine cannot
bool use(Width width);

}  // namespace abrazo::dense
