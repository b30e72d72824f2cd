#include "tests/support/dense_algebra.hpp"

#include <Eigen/Dense>

namespace abrazo::test {

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a * b;
}

Eigen::MatrixXd solve_by_cholesky(const Eigen::MatrixXd& a, const Eigen::MatrixXd& right) {
  return a.llt().solve(right);
}

Eigen::MatrixXd solve_by_lu(const Eigen::MatrixXd& a, const Eigen::MatrixXd& right) {
  return a.fullPivLu().solve(right);
}

Eigen::MatrixXd solve_by_least_length(const Eigen::MatrixXd& a, const Eigen::MatrixXd& right) {
  return a.completeOrthogonalDecomposition().solve(right);
}

Eigen::Index rank_of(const Eigen::MatrixXd& a) {
  return a.fullPivLu().rank();
}

Eigen::MatrixXd null_space_of(const Eigen::MatrixXd& a) {
  return a.fullPivLu().kernel();
}

}  // namespace abrazo::test
