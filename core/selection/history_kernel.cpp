#include "core/selection/history_kernel.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

constexpr Eigen::Index most_axes = 48;  ///< of a part
constexpr float kernel_width = 1;       ///< of the Gaussians, in usual squared distances a part
/// Moments of each part: now, the quarter of a second before, up to a second, up to two.
constexpr std::array<Eigen::Index, HistoryKernel::part_count> part_moments = {1, 4, 4, 4};
constexpr float least_distance = 1e-6F;  ///< squared [m^2]: a part that is the same in every motion

/// The median over pairs that are far apart in the list.
float usual_squared_distance(const HistoryKernel::Rows& points) {
  const Eigen::Index n = points.rows();
  std::vector<float> squared;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index other = (i * 7919 + n / 2) % n;
    if (other != i) squared.push_back((points.row(i) - points.row(other)).squaredNorm());
  }
  if (squared.empty()) return least_distance;
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return std::max(*middle, least_distance);
}

/// Over the parts up to this one. @param squared  distance of them
float gaussian(float squared, std::size_t part) {
  return std::exp(-squared / (kernel_width * static_cast<float>(part + 1)));
}

}  // namespace

void HistoryKernel::sample(const MotionHistory& history, Raw& raw) {
  for (std::size_t lag = 0; lag < lags_s.size(); ++lag)
    history.sample(lags_s[lag],
                   std::span<float, MotionHistory::coordinates>(raw.data() + lag * MotionHistory::coordinates,
                                                                MotionHistory::coordinates));
}

HistoryKernel::HistoryKernel(const Rows& motions) {
  Eigen::Index first = 0;
  for (const Eigen::Index moments : part_moments) {
    Part part;
    part.first = first;
    part.count = moments * static_cast<Eigen::Index>(MotionHistory::coordinates);
    first += part.count;
    const auto columns = motions.middleCols(part.first, part.count);
    part.mean = columns.colwise().mean().transpose();
    const Rows centred = columns.rowwise() - part.mean.transpose();
    const Eigen::MatrixXd spread = (centred.transpose() * centred).cast<double>();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(spread);
    part.axes = found.eigenvectors().rightCols(most_axes).rowwise().reverse().transpose().cast<float>();
    part.axes /= std::sqrt(usual_squared_distance(centred * part.axes.transpose()));
    part.at = size_;
    size_ += static_cast<int>(part.axes.rows());
    parts_.push_back(std::move(part));
  }
}

void HistoryKernel::describe(const Raw& raw, std::span<float> description) const {
  std::array<float, raw_size> off;
  for (const Part& part : parts_) {
    Eigen::Map<Eigen::VectorXf> from_mean(off.data() + part.first, part.count);
    from_mean = Eigen::Map<const Eigen::VectorXf>(raw.data() + part.first, part.count) - part.mean;
    Eigen::Map<Eigen::VectorXf>(description.data() + part.at, part.axes.rows()).noalias() =
        part.axes * from_mean;
  }
}

HistoryKernel::Rows HistoryKernel::describe(const Rows& motions) const {
  Rows described(motions.rows(), size_);
  for (const Part& part : parts_) {
    const Rows centred = motions.middleCols(part.first, part.count).rowwise() - part.mean.transpose();
    described.middleCols(part.at, part.axes.rows()).noalias() = centred * part.axes.transpose();
  }
  return described;
}

float HistoryKernel::operator()(std::span<const float> a, std::span<const float> b) const {
  float squared = 0, sum = 0;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Eigen::Map<const Eigen::VectorXf> x(a.data() + parts_[p].at, parts_[p].axes.rows());
    const Eigen::Map<const Eigen::VectorXf> y(b.data() + parts_[p].at, parts_[p].axes.rows());
    squared += (x - y).squaredNorm();
    sum += gaussian(squared, p);
  }
  return sum / part_count;
}

HistoryKernel::Compared HistoryKernel::to_compare(const Rows& descriptions) const {
  Compared compared;
  compared.squares.resize(descriptions.rows(), part_count);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    compared.parts[p] = descriptions.middleCols(parts_[p].at, parts_[p].axes.rows());
    compared.squares.col(static_cast<Eigen::Index>(p)) = compared.parts[p].rowwise().squaredNorm();
  }
  return compared;
}

void HistoryKernel::compare(const Compared& with, std::span<const float> description, std::span<float> kernel,
                            std::span<float> work) const {
  const auto count = static_cast<Eigen::Index>(kernel.size());
  Eigen::Map<Eigen::ArrayXf> sum(kernel.data(), count);
  Eigen::Map<Eigen::ArrayXf> squared(work.data(), count);
  sum.setZero();
  squared.setZero();
  for (int p = 0; p < part_count; ++p) {
    const Part& part = parts_[static_cast<std::size_t>(p)];
    const Eigen::Map<const Eigen::VectorXf> own(description.data() + part.at, part.axes.rows());
    squared.matrix().noalias() -= 2 * (with.parts[static_cast<std::size_t>(p)].topRows(count) * own);
    squared += with.squares.col(p).head(count).array() + own.squaredNorm();
    sum += (squared.max(0.0F) * (-1 / (kernel_width * static_cast<float>(p + 1)))).exp();
  }
  sum /= part_count;
}

}  // namespace abrazo
