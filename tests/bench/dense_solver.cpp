// Compiled for this very processor, with Eigen under a name of its own so that none of it reaches the
// library (see CMakeLists.txt).
#include "tests/bench/dense_solver.hpp"

#include <Eigen/LU>
#include <type_traits>

namespace abrazo::bench {

namespace {

using ExtendedMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

template <typename Matrix, typename Factorisation>
class DenseSolver : public KktSolver {
 public:
  bool solve(const KktSystem& system, std::vector<double>& solution) override {
    matrix_.setZero(system.size, system.size);
    for (int column = 0; column < system.size; ++column)
      for (int entry = system.column_starts[static_cast<std::size_t>(column)];
           entry < system.column_starts[static_cast<std::size_t>(column) + 1]; ++entry)
        matrix_(system.rows[static_cast<std::size_t>(entry)], column) =
            system.values[static_cast<std::size_t>(entry)];
    factorisation_.compute(matrix_);
    solution.resize(static_cast<std::size_t>(system.size));
    Eigen::Map<Eigen::VectorXd> all(solution.data(), system.size);
    all = answer(system.right);
    refinement_side(system, solution, right_);
    all += answer(right_);
    return all.allFinite();
  }

 private:
  Eigen::VectorXd answer(const std::vector<double>& right) const {
    const Eigen::Map<const Eigen::VectorXd> side(right.data(), static_cast<Eigen::Index>(right.size()));
    if constexpr (std::is_same_v<typename Matrix::Scalar, double>)
      return factorisation_.solve(side);
    else
      return factorisation_.solve(side.cast<typename Matrix::Scalar>().eval()).template cast<double>();
  }

  Matrix matrix_;
  Factorisation factorisation_;
  std::vector<double> right_;
};

}  // namespace

std::unique_ptr<KktSolver> dense_solver(Pivoting pivoting) {
  using Full = Eigen::FullPivLU<Eigen::MatrixXd>;
  using Partial = Eigen::PartialPivLU<Eigen::MatrixXd>;
  if (pivoting == Pivoting::Full) return std::make_unique<DenseSolver<Eigen::MatrixXd, Full>>();
  return std::make_unique<DenseSolver<Eigen::MatrixXd, Partial>>();
}

std::unique_ptr<KktSolver> reference_solver() {
  return std::make_unique<DenseSolver<ExtendedMatrix, Eigen::PartialPivLU<ExtendedMatrix>>>();
}

}  // namespace abrazo::bench
