#include "core/selection/positive_solve.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>

#include "core/base/parallel.hpp"

namespace abrazo {

namespace {

constexpr Eigen::Index block = 192;
constexpr std::string_view doing = "learning partners";

/// Progress of the whole, by how much of the work is behind: the last columns are short.
Progress part_of(const Progress& progress, Eigen::Index at, Eigen::Index n) {
  if (!progress) return {};
  const double left = 1 - static_cast<double>(at) / static_cast<double>(n);
  return [&progress, done = 1 - left * left * left](double, std::string_view what) {
    return progress(done, what);
  };
}

}  // namespace

bool solve_positive(Eigen::MatrixXd& a, Eigen::MatrixXd& b, const Progress& progress) {
  const Eigen::Index n = a.rows();
  for (Eigen::Index k = 0; k < n; k += block) {
    const Eigen::Index width = std::min(block, n - k);
    auto diagonal = a.block(k, k, width, width);
    const Eigen::LLT<Eigen::MatrixXd> factor(diagonal);
    if (factor.info() != Eigen::Success) throw std::runtime_error("a system to learn from has no solution");
    diagonal = factor.matrixL();
    const Eigen::Index below = n - k - width;
    const auto blocks = static_cast<std::size_t>((below + block - 1) / block);
    const auto rows_of = [&](std::size_t i) {
      const Eigen::Index first = k + width + static_cast<Eigen::Index>(i) * block;
      return std::pair{first, std::min(block, n - first)};
    };
    const Progress part = part_of(progress, k, n);
    const bool panel = blocks == 0 || for_each_row(blocks, 1, part, doing, [&](std::size_t i) {
                         const auto [first, rows] = rows_of(i);
                         auto panel_rows = a.block(first, k, rows, width);
                         panel_rows = factor.matrixL().solve(panel_rows.transpose()).transpose().eval();
                       });
    const bool rest = !panel || blocks == 0 || for_each_row(blocks, 1, part, doing, [&](std::size_t i) {
      const auto [first, rows] = rows_of(i);
      const Eigen::Index columns = first + rows - k - width;
      a.block(first, k + width, rows, columns).noalias() -=
          a.block(first, k, rows, width) * a.block(k + width, k, columns, width).transpose();
    });
    if (!panel || !rest) return false;
  }
  // Few right-hand sides: by columns in groups, each core its own.
  constexpr Eigen::Index group = 16;
  const auto groups = static_cast<std::size_t>((b.cols() + group - 1) / group);
  return for_each_row(groups, 1, {}, doing, [&](std::size_t g) {
    const Eigen::Index first = static_cast<Eigen::Index>(g) * group;
    auto some = b.middleCols(first, std::min(group, b.cols() - first));
    a.triangularView<Eigen::Lower>().solveInPlace(some);
    a.triangularView<Eigen::Lower>().transpose().solveInPlace(some);
  });
}

}  // namespace abrazo
