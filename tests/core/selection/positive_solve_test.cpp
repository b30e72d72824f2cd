#include "core/selection/positive_solve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/support/dense_algebra.hpp"

namespace abrazo::positive_solve_test {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd made(rows, columns);
  for (Eigen::Index c = 0; c < columns; ++c)
    for (Eigen::Index r = 0; r < rows; ++r) made(r, c) = normal(random);
  return made;
}

/// Eigenvalues of about 1 to 5: no solution of it rounds by more than some 1e-14.
Eigen::MatrixXd random_positive(Eigen::Index n, std::mt19937& random) {
  const Eigen::MatrixXd half = random_matrix(n, n, random);
  return test::product(half, half.transpose()) / static_cast<double>(n) + Eigen::MatrixXd::Identity(n, n);
}

// Blocks are of 192: within one, one to the full, one more, and several.
TEST(SolvePositive, SolvesAsADenseSolverDoes) {
  std::mt19937 random(1);
  for (const Eigen::Index n : {1, 2, 191, 192, 193, 384, 500})
    for (const Eigen::Index columns : {1, 16, 37}) {
      const Eigen::MatrixXd system = random_positive(n, random), right = random_matrix(n, columns, random);
      const Eigen::MatrixXd expected = test::solve_by_cholesky(system, right);
      Eigen::MatrixXd a = system, b = right;
      // Only the lower triangle is read.
      a.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);
      ASSERT_TRUE(solve_positive(a, b));
      EXPECT_LT((b - expected).cwiseAbs().maxCoeff(), 1e-11) << n << " x " << columns;
      const Eigen::MatrixXd lower = a.triangularView<Eigen::Lower>();
      EXPECT_LT((test::product(lower, lower.transpose()) - system).cwiseAbs().maxCoeff(), 1e-11) << n;
    }
}

TEST(SolvePositive, GivesTheSameBitsEveryTime) {
  std::mt19937 random(2);
  const Eigen::MatrixXd system = random_positive(450, random), right = random_matrix(450, 40, random);
  Eigen::MatrixXd a = system, b = right;
  ASSERT_TRUE(solve_positive(a, b));
  for (int again = 0; again < 3; ++again) {
    Eigen::MatrixXd other_a = system, other_b = right;
    ASSERT_TRUE(solve_positive(other_a, other_b));
    EXPECT_EQ(other_b, b);
  }
}

TEST(SolvePositive, RefusesASystemThatIsNotPositiveDefinite) {
  std::mt19937 random(3);
  for (const Eigen::Index at : {0, 100, 191, 192, 300, 449}) {
    Eigen::MatrixXd a = random_positive(450, random), b = random_matrix(450, 2, random);
    a(at, at) = -1;
    EXPECT_THROW(solve_positive(a, b), std::runtime_error) << at;
  }
}

TEST(SolvePositive, StopsWhenProgressAsksForIt) {
  std::mt19937 random(4);
  Eigen::MatrixXd a = random_positive(1200, random), b = random_matrix(1200, 2, random);
  EXPECT_FALSE(solve_positive(a, b, [](double, std::string_view) { return false; }));
}

TEST(SolvePositive, ProgressGoesUpToTheEnd) {
  std::mt19937 random(5);
  Eigen::MatrixXd a = random_positive(1200, random), b = random_matrix(1200, 2, random);
  std::vector<double> fractions;
  ASSERT_TRUE(solve_positive(a, b, [&](double fraction, std::string_view) {
    fractions.push_back(fraction);
    return true;
  }));
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0);
  EXPECT_LE(fractions.back(), 1);
}

}  // namespace
}  // namespace abrazo::positive_solve_test
