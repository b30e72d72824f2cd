#pragma once

#include <Eigen/Core>

#include "core/base/progress.hpp"

namespace abrazo {

/// Solves A X = B in place for a symmetric positive definite A, blockwise on all processor cores.
/// @param a  n x n, its lower triangle; becomes L with L L^T = A
/// @param b  n x m; becomes X
/// @return false if `progress` cancelled. @throws std::runtime_error when A is not positive definite
bool solve_positive(Eigen::MatrixXd& a, Eigen::MatrixXd& b, const Progress& progress = {});

}  // namespace abrazo
