#include "core/synthesis/edit/dense_kernels.hpp"

#include <atomic>

namespace abrazo::dense {

namespace {

// What one register holds. Functions that work with them are inlined into those that are compiled for the
// register's machine: nothing of AVX2 gets into a function that others could share.
template <int width>
struct RegisterOf;
template <>
struct RegisterOf<2> {
  using Type [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;
};
template <>
struct RegisterOf<4> {
  using Type [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;
};

template <int width>
struct Kernels {
  using Register = typename RegisterOf<width>::Type;
  static constexpr int wide = 2 * width;  ///< rows of a block: more does not fit into 16 registers

  /// Registers from x on, aligned as numbers are. The types are explicit, because deduced ones lose the
  /// alignment.
  [[gnu::always_inline]] static const Register* at(const double* x) {
    return reinterpret_cast<const Register*>(x);
  }
  [[gnu::always_inline]] static Register* at(double* x) { return reinterpret_cast<Register*>(x); }

  /// Rows i to i + blocks and columns j to j + 4 of A, minus the product of what is left of them.
  template <int blocks>
  [[gnu::always_inline]] static void reduce(const double* a, int i, int j, int stride,
                                            Register (&sum)[4][blocks]) {
    for (int q = 0; q < 4; ++q)
      for (int b = 0; b < blocks; ++b) sum[q][b] = at(a + (j + q) * stride + i)[b];
    for (int k = 0; k < j; ++k) {
      const double* column = a + k * stride;
      Register left[blocks];
      for (int b = 0; b < blocks; ++b) left[b] = at(column + i)[b];
      for (int q = 0; q < 4; ++q) {
        const double pivot = column[j + q];
        for (int b = 0; b < blocks; ++b) sum[q][b] -= left[b] * pivot;
      }
    }
  }

  template <int blocks>
  [[gnu::always_inline]] static void below_diagonal(double* a, int i, int j, int stride,
                                                    const double* inverse_diagonal) {
    Register sum[4][blocks];
    reduce<blocks>(a, i, j, stride, sum);
    for (int q = 0; q < 4; ++q) {
      for (int p = 0; p < q; ++p) {
        const double pivot = a[(j + p) * stride + j + q];
        for (int b = 0; b < blocks; ++b) sum[q][b] -= sum[p][b] * pivot;
      }
      for (int b = 0; b < blocks; ++b) {
        sum[q][b] *= inverse_diagonal[j + q];
        at(a + (j + q) * stride + i)[b] = sum[q][b];
      }
    }
  }

  [[gnu::always_inline]] static bool diagonal_block(double* a, int j, int stride, double* inverse_diagonal) {
    constexpr int blocks = 4 / width;
    Register sum[4][blocks];
    reduce<blocks>(a, j, j, stride, sum);
    for (int q = 0; q < 4; ++q) {
      double column[4];
      for (int b = 0; b < blocks; ++b) at(column)[b] = sum[q][b];
      for (int p = 0; p < q; ++p)
        for (int r = q; r < 4; ++r) column[r] -= a[(j + p) * stride + j + r] * a[(j + p) * stride + j + q];
      if (!(column[q] > 0) || column[q] > 1e300) return false;  // nor NaN
      inverse_diagonal[j + q] = 1 / __builtin_sqrt(column[q]);
      for (int r = q; r < 4; ++r) a[(j + q) * stride + j + r] = column[r] * inverse_diagonal[j + q];
    }
    return true;
  }

  [[gnu::always_inline]] static bool factor(double* a, int size, int stride, double* inverse_diagonal) {
    for (int j = 0; j < size; j += 4) {
      if (!diagonal_block(a, j, stride, inverse_diagonal)) return false;
      int i = j + 4;
      for (; i + wide <= size; i += wide) below_diagonal<2>(a, i, j, stride, inverse_diagonal);
      for (; i < size; i += width) below_diagonal<1>(a, i, j, stride, inverse_diagonal);
    }
    return true;
  }

  [[gnu::always_inline]] static void solve_lower(const double* l, int size, int stride,
                                                 const double* inverse_diagonal, double* x) {
    for (int j = 0; j < size; j += 4) {
      for (int q = 0; q < 4; ++q) {
        x[j + q] *= inverse_diagonal[j + q];
        for (int r = q + 1; r < 4; ++r) x[j + r] -= l[(j + q) * stride + j + r] * x[j + q];
      }
      for (int i = j + 4; i < size; i += width) {
        Register sum = *at(x + i);
        for (int q = 0; q < 4; ++q) sum -= *at(l + (j + q) * stride + i) * x[j + q];
        *at(x + i) = sum;
      }
    }
  }

  /// Of four partial sums, each over every fourth element.
  [[gnu::always_inline]] static double total(const Register (&sums)[4 / width]) {
    double parts[4];
    for (int b = 0; b < 4 / width; ++b) at(parts)[b] = sums[b];
    return (parts[0] + parts[1]) + (parts[2] + parts[3]);
  }

  [[gnu::always_inline]] static void solve_upper(const double* l, int size, int stride,
                                                 const double* inverse_diagonal, double* x) {
    constexpr int blocks = 4 / width;
    for (int j = size - 4; j >= 0; j -= 4) {
      Register sums[4][blocks] = {};
      for (int i = j + 4; i < size; i += 4)
        for (int q = 0; q < 4; ++q)
          for (int b = 0; b < blocks; ++b) sums[q][b] += at(l + (j + q) * stride + i)[b] * at(x + i)[b];
      for (int q = 3; q >= 0; --q) {
        double sum = x[j + q] - total(sums[q]);
        for (int r = q + 1; r < 4; ++r) sum -= l[(j + q) * stride + j + r] * x[j + r];
        x[j + q] = sum * inverse_diagonal[j + q];
      }
    }
  }

  /// Entries from c on of row i of L^-1, after the rows above it; row i stands in column i of `inverse`.
  template <int blocks>
  [[gnu::always_inline]] static void inverse_row(const double* l, int i, int c, int stride,
                                                 double inverse_diagonal, double* inverse) {
    Register sum[blocks] = {};
    for (int k = c; k < i; ++k)
      for (int b = 0; b < blocks; ++b) sum[b] -= at(inverse + k * stride + c)[b] * l[k * stride + i];
    for (int b = 0; b < blocks; ++b) at(inverse + i * stride + c)[b] = sum[b] * inverse_diagonal;
    if (c <= i && i < c + width * blocks) inverse[i * stride + i] = inverse_diagonal;
  }

  /// The same of L^-T times the matrix whose row i stands there, after the rows below it.
  template <int blocks>
  [[gnu::always_inline]] static void product_row(const double* l, int i, int c, int size, int stride,
                                                 double inverse_diagonal, double* inverse) {
    Register sum[blocks];
    for (int b = 0; b < blocks; ++b) sum[b] = at(inverse + i * stride + c)[b];
    for (int k = i + 1; k < size; ++k)
      for (int b = 0; b < blocks; ++b) sum[b] -= at(inverse + k * stride + c)[b] * l[i * stride + k];
    for (int b = 0; b < blocks; ++b) at(inverse + i * stride + c)[b] = sum[b] * inverse_diagonal;
  }

  [[gnu::always_inline]] static void invert(const double* l, int size, int stride,
                                            const double* inverse_diagonal, double* inverse) {
    constexpr int step = 4 * width;
    for (int i = 0; i < size; ++i) {
      int c = 0;
      for (; c + step <= size; c += step) inverse_row<4>(l, i, c, stride, inverse_diagonal[i], inverse);
      for (; c < size; c += width) inverse_row<1>(l, i, c, stride, inverse_diagonal[i], inverse);
    }
    // The lower triangle of the inverse needs only that of L^-1.
    for (int i = size - 1; i >= 0; --i) {
      int c = 0;
      for (; c + step <= size && c <= i; c += step)
        product_row<4>(l, i, c, size, stride, inverse_diagonal[i], inverse);
      for (; c <= i; c += width) product_row<1>(l, i, c, size, stride, inverse_diagonal[i], inverse);
    }
    for (int i = 0; i < size; ++i)
      for (int c = 0; c < i; ++c) inverse[c * stride + i] = inverse[i * stride + c];
  }

  [[gnu::always_inline]] static double dot(const double* x, const double* y, int size) {
    Register sums[4 / width] = {};
    for (int i = 0; i < size; i += 4)
      for (int b = 0; b < 4 / width; ++b) sums[b] += at(x + i)[b] * at(y + i)[b];
    return total(sums);
  }

  [[gnu::always_inline]] static void add(double c, const double* x, int size, double* y) {
    for (int i = 0; i < size; i += width) *at(y + i) += *at(x + i) * c;
  }

  template <int blocks>
  [[gnu::always_inline]] static void add_outer_rows(const double* c, const double* x, int i, int size,
                                                    int stride, double* a) {
    Register rows[blocks];
    for (int b = 0; b < blocks; ++b) rows[b] = at(x + i)[b];
    for (int k = 0; k < size; ++k)
      for (int b = 0; b < blocks; ++b) at(a + k * stride + i)[b] += rows[b] * c[k];
  }

  [[gnu::always_inline]] static void add_outer(const double* c, const double* x, int size, int stride,
                                               double* a) {
    constexpr int step = 4 * width;
    int i = 0;
    for (; i + step <= size; i += step) add_outer_rows<4>(c, x, i, size, stride, a);
    for (; i < size; i += width) add_outer_rows<1>(c, x, i, size, stride, a);
  }

  [[gnu::always_inline]] static void combine(const Combination& of, int size, double* y) {
    for (int i = 0; i < size; i += width) {
      Register sum = {};
      for (int k = 0; k < of.count; ++k) sum += *at(of.vectors[k] + i) * of.weights[k];
      *at(y + i) = sum;
    }
  }

  [[gnu::always_inline]] static void combine_scaled(const Combination& of, const double* u,
                                                    const double* const* a, int size, double* y) {
    for (int i = 0; i < size; i += width) {
      Register sum = {};
      for (int k = 0; k < of.count; ++k) sum += *at(of.vectors[k] + i) * of.weights[k];
      *at(y + i) = sum * ((*at(a[0] + i) * u[0] + *at(a[1] + i) * u[1]) + *at(a[2] + i) * u[2]);
    }
  }

  template <int blocks>
  [[gnu::always_inline]] static void add_to_rows(const double* const* columns, int count,
                                                 const double* const* weights, int i, double* const* y) {
    Register sum[3][blocks];
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < blocks; ++b) sum[a][b] = at(y[a] + i)[b];
    for (int c = 0; c < count; ++c)
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < blocks; ++b) sum[a][b] += at(columns[c] + i)[b] * weights[a][c];
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < blocks; ++b) at(y[a] + i)[b] = sum[a][b];
  }

  [[gnu::always_inline]] static void add_columns(const double* const* columns, int count,
                                                 const double* const* weights, int size, double* const* y) {
    int i = 0;
    for (; i + wide <= size; i += wide) add_to_rows<2>(columns, count, weights, i, y);
    for (; i < size; i += width) add_to_rows<1>(columns, count, weights, i, y);
  }
};

struct Table {
  bool (*factor)(double* a, int size, int stride, double* inverse_diagonal);
  void (*solve_lower)(const double* l, int size, int stride, const double* inverse_diagonal, double* x);
  void (*solve_upper)(const double* l, int size, int stride, const double* inverse_diagonal, double* x);
  void (*invert)(const double* l, int size, int stride, const double* inverse_diagonal, double* inverse);
  double (*dot)(const double* x, const double* y, int size);
  void (*add)(double c, const double* x, int size, double* y);
  void (*add_outer)(const double* c, const double* x, int size, int stride, double* a);
  void (*combine)(const Combination& of, int size, double* y);
  void (*combine_scaled)(const Combination& of, const double* u, const double* const* a, int size, double* y);
  void (*add_columns)(const double* const* columns, int count, const double* const* weights, int size,
                      double* const* y);
};

struct OfTwo {
  static bool factor(double* a, int size, int stride, double* inverse_diagonal) {
    return Kernels<2>::factor(a, size, stride, inverse_diagonal);
  }
  static void solve_lower(const double* l, int size, int stride, const double* inverse_diagonal, double* x) {
    return Kernels<2>::solve_lower(l, size, stride, inverse_diagonal, x);
  }
  static void solve_upper(const double* l, int size, int stride, const double* inverse_diagonal, double* x) {
    return Kernels<2>::solve_upper(l, size, stride, inverse_diagonal, x);
  }
  static void invert(const double* l, int size, int stride, const double* inverse_diagonal, double* inverse) {
    return Kernels<2>::invert(l, size, stride, inverse_diagonal, inverse);
  }
  static double dot(const double* x, const double* y, int size) { return Kernels<2>::dot(x, y, size); }
  static void add(double c, const double* x, int size, double* y) { return Kernels<2>::add(c, x, size, y); }
  static void add_outer(const double* c, const double* x, int size, int stride, double* a) {
    return Kernels<2>::add_outer(c, x, size, stride, a);
  }
  static void combine(const Combination& of, int size, double* y) { return Kernels<2>::combine(of, size, y); }
  static void combine_scaled(const Combination& of, const double* u, const double* const* a, int size,
                             double* y) {
    return Kernels<2>::combine_scaled(of, u, a, size, y);
  }
  static void add_columns(const double* const* columns, int count, const double* const* weights, int size,
                          double* const* y) {
    return Kernels<2>::add_columns(columns, count, weights, size, y);
  }
};

#ifdef __x86_64__
struct OfFour {
  [[gnu::target("avx2")]] static bool factor(double* a, int size, int stride, double* inverse_diagonal) {
    return Kernels<4>::factor(a, size, stride, inverse_diagonal);
  }
  [[gnu::target("avx2")]] static void solve_lower(const double* l, int size, int stride,
                                                  const double* inverse_diagonal, double* x) {
    return Kernels<4>::solve_lower(l, size, stride, inverse_diagonal, x);
  }
  [[gnu::target("avx2")]] static void solve_upper(const double* l, int size, int stride,
                                                  const double* inverse_diagonal, double* x) {
    return Kernels<4>::solve_upper(l, size, stride, inverse_diagonal, x);
  }
  [[gnu::target("avx2")]] static void invert(const double* l, int size, int stride,
                                             const double* inverse_diagonal, double* inverse) {
    return Kernels<4>::invert(l, size, stride, inverse_diagonal, inverse);
  }
  [[gnu::target("avx2")]] static double dot(const double* x, const double* y, int size) {
    return Kernels<4>::dot(x, y, size);
  }
  [[gnu::target("avx2")]] static void add(double c, const double* x, int size, double* y) {
    return Kernels<4>::add(c, x, size, y);
  }
  [[gnu::target("avx2")]] static void add_outer(const double* c, const double* x, int size, int stride,
                                                double* a) {
    return Kernels<4>::add_outer(c, x, size, stride, a);
  }
  [[gnu::target("avx2")]] static void combine(const Combination& of, int size, double* y) {
    return Kernels<4>::combine(of, size, y);
  }
  [[gnu::target("avx2")]] static void combine_scaled(const Combination& of, const double* u,
                                                     const double* const* a, int size, double* y) {
    return Kernels<4>::combine_scaled(of, u, a, size, y);
  }
  [[gnu::target("avx2")]] static void add_columns(const double* const* columns, int count,
                                                  const double* const* weights, int size, double* const* y) {
    return Kernels<4>::add_columns(columns, count, weights, size, y);
  }
};
#else
using OfFour = OfTwo;
#endif

template <typename Ways>
constexpr Table table_of = {
    Ways::factor, Ways::solve_lower, Ways::solve_upper, Ways::invert,         Ways::dot,
    Ways::add,    Ways::add_outer,   Ways::combine,     Ways::combine_scaled, Ways::add_columns};

bool has_four() {
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

const Table& table_for(Width width) {
  return width == Width::Four ? table_of<OfFour> : table_of<OfTwo>;
}

std::atomic<Width>& chosen() {
  static std::atomic<Width> width = has_four() ? Width::Four : Width::Two;
  return width;
}

const Table& table() {
  return table_for(chosen().load(std::memory_order_relaxed));
}

/// What is beyond n in padded columns neither changes what is before it nor stops the factorisation.
void pad(double* a, int n, int stride) {
  const int size = padded(n);
  for (int column = 0; column < n; ++column)
    for (int row = n; row < size; ++row) a[column * stride + row] = 0;
  for (int column = n; column < size; ++column)
    for (int row = column; row < size; ++row) a[column * stride + row] = row == column ? 1 : 0;
}

}  // namespace

Width width() {
  return chosen();
}

bool use(Width width) {
  if (width == Width::Four && !has_four()) return false;
  chosen() = width;
  return true;
}

bool factor(double* a, int n, int stride, double* inverse_diagonal) {
  pad(a, n, stride);
  return table().factor(a, padded(n), stride, inverse_diagonal);
}

void solve_lower(const double* l, int n, int stride, const double* inverse_diagonal, double* x) {
  table().solve_lower(l, padded(n), stride, inverse_diagonal, x);
}

void solve_upper(const double* l, int n, int stride, const double* inverse_diagonal, double* x) {
  table().solve_upper(l, padded(n), stride, inverse_diagonal, x);
}

void invert(const double* l, int n, int stride, const double* inverse_diagonal, double* inverse) {
  table().invert(l, padded(n), stride, inverse_diagonal, inverse);
}

double dot(const double* x, const double* y, int n) {
  return table().dot(x, y, padded(n));
}

void add_outer(const double* c, const double* x, int n, int stride, double* a) {
  table().add_outer(c, x, padded(n), stride, a);
}

void add(double c, const double* x, int n, double* y) {
  table().add(c, x, padded(n), y);
}

void combine(const Combination& of, int n, double* y) {
  table().combine(of, padded(n), y);
}

void combine_scaled(const Combination& of, const double* u, const std::array<const double*, 3>& a, int n,
                    double* y) {
  table().combine_scaled(of, u, a.data(), padded(n), y);
}

void add_columns(std::span<const double* const> columns, const std::array<const double*, 3>& weights, int n,
                 const std::array<double*, 3>& y) {
  table().add_columns(columns.data(), static_cast<int>(columns.size()), weights.data(), padded(n), y.data());
}

}  // namespace abrazo::dense
