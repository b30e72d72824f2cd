#include "core/synthesis/edit/dense_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/support/dense_algebra.hpp"

namespace abrazo::dense_kernels_test {
namespace {

/// The way for wide registers where there is one, else the other once more; the choice is put back.
class DenseKernels : public testing::TestWithParam<dense::Width> {
 protected:
  void SetUp() override {
    if (!dense::use(GetParam())) GTEST_SKIP() << "not on this machine";
  }
  void TearDown() override { dense::use(before_); }

 private:
  dense::Width before_ = dense::width();
};

/// Symmetric and positive definite, in padded columns of which only the lower triangle holds numbers.
struct System {
  explicit System(int size) : n(size), stride(dense::padded(size) + 4) {
    std::mt19937 random(static_cast<unsigned>(size));
    std::normal_distribution<double> normal;
    Eigen::MatrixXd half(n, n);
    for (auto& x : half.reshaped()) x = normal(random);
    a = half * half.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
    columns.assign(static_cast<std::size_t>(stride * dense::padded(n)), std::nan(""));
    for (int column = 0; column < n; ++column)
      for (int row = column; row < n; ++row)
        columns[static_cast<std::size_t>(column * stride + row)] = a(row, column);
    inverse_diagonal.resize(static_cast<std::size_t>(dense::padded(n)));
  }
  bool factor() { return dense::factor(columns.data(), n, stride, inverse_diagonal.data()); }

  int n, stride;
  Eigen::MatrixXd a;
  std::vector<double> columns, inverse_diagonal;
};

std::vector<double> numbers(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> x(static_cast<std::size_t>(dense::padded(n)), 0.0);
  for (int i = 0; i < n; ++i) x[static_cast<std::size_t>(i)] = normal(random);
  return x;
}

Eigen::VectorXd first(const std::vector<double>& x, int n) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), n);
}

TEST_P(DenseKernels, SolveWhatEigenSolvesForEverySize) {
  for (int n = 1; n <= 70; ++n) {
    System system(n);
    ASSERT_TRUE(system.factor()) << n;
    std::vector<double> x = numbers(n, 1);
    const Eigen::VectorXd wanted = test::solve_by_cholesky(system.a, first(x, n));
    dense::solve_lower(system.columns.data(), n, system.stride, system.inverse_diagonal.data(), x.data());
    dense::solve_upper(system.columns.data(), n, system.stride, system.inverse_diagonal.data(), x.data());
    EXPECT_LT((first(x, n) - wanted).norm(), 1e-9 * (1 + wanted.norm())) << n;
    for (int i = n; i < dense::padded(n); ++i) EXPECT_EQ(x[static_cast<std::size_t>(i)], 0) << n;
  }
}

TEST_P(DenseKernels, InvertBothTriangles) {
  for (const int n : {1, 4, 5, 17, 50}) {
    System system(n);
    ASSERT_TRUE(system.factor());
    std::vector<double> inverse(static_cast<std::size_t>(system.stride * dense::padded(n)));
    dense::invert(system.columns.data(), n, system.stride, system.inverse_diagonal.data(), inverse.data());
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> found(
        inverse.data(), n, n, Eigen::OuterStride<>(system.stride));
    EXPECT_LT((system.a * found - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-9) << n;
    EXPECT_EQ(found, found.transpose()) << n;
  }
}

TEST_P(DenseKernels, RefuseWhatIsNotPositiveDefinite) {
  for (const double bad : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN(), 1e308}) {
    System system(9);
    system.columns[static_cast<std::size_t>(6 * system.stride + 6)] = bad;
    EXPECT_FALSE(system.factor()) << bad;
  }
}

TEST_P(DenseKernels, SumUpAsTheyAreDefined) {
  const int n = 13;
  const auto x = numbers(n, 1), y = numbers(n, 2), z = numbers(n, 3);
  EXPECT_NEAR(dense::dot(x.data(), y.data(), n), first(x, n).dot(first(y, n)), 1e-12);
  std::vector<double> sum = z;
  dense::add(2.5, x.data(), n, sum.data());
  EXPECT_LT((first(sum, n) - (first(z, n) + 2.5 * first(x, n))).norm(), 1e-12);

  std::vector<double> matrix(static_cast<std::size_t>(dense::padded(n) * dense::padded(n)), 1.0);
  dense::add_outer(y.data(), x.data(), n, dense::padded(n), matrix.data());
  const Eigen::Map<const Eigen::MatrixXd> outer(matrix.data(), dense::padded(n), dense::padded(n));
  const Eigen::MatrixXd wanted = Eigen::MatrixXd::Ones(n, n) + first(x, n) * first(y, n).transpose();
  EXPECT_LT((outer.topLeftCorner(n, n) - wanted).norm(), 1e-12);

  const dense::Combination of{{x.data(), y.data()}, {2, -3}, 2};
  const Eigen::VectorXd combined = 2 * first(x, n) - 3 * first(y, n);
  dense::combine(of, n, sum.data());
  EXPECT_LT((first(sum, n) - combined).norm(), 1e-12);
  const std::array<double, 3> u = {0.5, -1, 2};
  dense::combine_scaled(of, u.data(), {x.data(), y.data(), z.data()}, n, sum.data());
  const Eigen::VectorXd along = 0.5 * first(x, n) - first(y, n) + 2 * first(z, n);
  EXPECT_LT((first(sum, n) - along.cwiseProduct(combined)).norm(), 1e-12);

  std::array<std::vector<double>, 3> sums = {x, y, z};
  const std::array<const double*, 2> columns = {x.data(), y.data()};
  const std::array<std::array<double, 2>, 3> weights = {{{1, 2}, {3, 4}, {5, 6}}};
  dense::add_columns(columns, {weights[0].data(), weights[1].data(), weights[2].data()}, n,
                     {sums[0].data(), sums[1].data(), sums[2].data()});
  EXPECT_LT((first(sums[2], n) - (first(z, n) + 5 * first(x, n) + 6 * first(y, n))).norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(EachWidth, DenseKernels, testing::Values(dense::Width::Two, dense::Width::Four));

TEST(DenseKernelWidths, GiveTheSameBitsAtEitherWidth) {
  const auto before = dense::width();
  if (!dense::use(dense::Width::Four)) GTEST_SKIP() << "this machine has one width";
  const auto all_of = [](dense::Width width, int n) {
    dense::use(width);
    System system(n);
    EXPECT_TRUE(system.factor());
    std::vector<double> inverse(system.columns.size());
    dense::invert(system.columns.data(), n, system.stride, system.inverse_diagonal.data(), inverse.data());
    std::vector<double> all;
    for (int column = 0; column < n; ++column)
      for (int row = column; row < n; ++row) {
        all.push_back(system.columns[static_cast<std::size_t>(column * system.stride + row)]);
        all.push_back(inverse[static_cast<std::size_t>(column * system.stride + row)]);
      }
    std::vector<double> x = numbers(n, 1);
    dense::solve_lower(system.columns.data(), n, system.stride, system.inverse_diagonal.data(), x.data());
    dense::solve_upper(system.columns.data(), n, system.stride, system.inverse_diagonal.data(), x.data());
    all.insert(all.end(), x.begin(), x.end());
    all.push_back(dense::dot(x.data(), numbers(n, 2).data(), n));
    return all;
  };
  for (int n = 1; n <= 70; ++n) EXPECT_EQ(all_of(dense::Width::Two, n), all_of(dense::Width::Four, n)) << n;
  dense::use(before);
}

}  // namespace
}  // namespace abrazo::dense_kernels_test
