#pragma once

#include <Eigen/Core>

namespace abrazo::test {

// What tests compare the engine's solvers with. Compiled once and optimised: these templates take most of the
// time that such tests take to compile, and unoptimised they take minutes to run.

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// Cholesky: `a` symmetric and positive definite.
Eigen::MatrixXd solve_by_cholesky(const Eigen::MatrixXd& a, const Eigen::MatrixXd& right);
/// LU with full pivoting.
Eigen::MatrixXd solve_by_lu(const Eigen::MatrixXd& a, const Eigen::MatrixXd& right);
/// The solution of least length, also where `a` has not full rank.
Eigen::MatrixXd solve_by_least_length(const Eigen::MatrixXd& a, const Eigen::MatrixXd& right);
Eigen::Index rank_of(const Eigen::MatrixXd& a);
/// Columns that span what `a` takes to nought.
Eigen::MatrixXd null_space_of(const Eigen::MatrixXd& a);

}  // namespace abrazo::test
