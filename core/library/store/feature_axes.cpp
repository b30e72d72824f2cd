#include "core/library/store/feature_axes.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abrazo {

namespace {

constexpr std::size_t axes_sample_rows = 16384;  ///< enough for the directions in which poses differ
constexpr double largest_extent = 1e60;
constexpr double farthest_query = 1e4;  ///< extents; beyond, rounding is as large as what poses differ by

}  // namespace

FeatureAxes::FeatureAxes(std::span<const Features> features) {
  if (features.empty()) return;
  const std::size_t stride = std::max<std::size_t>(1, features.size() / axes_sample_rows);
  std::size_t samples = 0;
  for (std::size_t i = 0; i < features.size(); i += stride, ++samples) centre_ += features[i];
  centre_ /= static_cast<double>(samples);
  Eigen::Matrix<double, 15, 15> spread = Eigen::Matrix<double, 15, 15>::Zero();
  for (std::size_t i = 0; i < features.size(); i += stride)
    spread += (features[i] - centre_) * (features[i] - centre_).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 15, 15>> principal(spread);
  // Implausible features (1e200) have no axes and are used unchanged.
  if (principal.info() == Eigen::Success && principal.eigenvectors().allFinite())
    axes_ = principal.eigenvectors().rowwise().reverse().transpose();
  double extent = 0;
  for (const Features& one : features) extent = std::max(extent, (one - centre_).cwiseAbs().sum());
  // Beyond, squares of differences leave what a double holds.
  if (extent > largest_extent || (extent > 0 && extent < 1 / largest_extent)) return;
  int exponent = 0;
  std::frexp(extent, &exponent);
  scale_ = std::ldexp(1.0, -exponent);
  is_usable_ = true;
}

FeatureAxes::Point FeatureAxes::of(const Features& features) const {
  Point point;
  point.head<15>() = (scale_ * (axes_ * (features - centre_))).cast<float>().array();
  point(15) = 0;
  return point;
}

bool FeatureAxes::can_tell(const Features& query) const {
  return is_usable_ && scale_ * (query - centre_).cwiseAbs().sum() <= farthest_query;
}

double FeatureAxes::slack_for(const Features& query) const {
  // Each coordinate of both points was rounded to 24 bits, and turned with errors of the double's.
  const double largest = std::max(1.0, scale_ * (query - centre_).cwiseAbs().sum());
  return 4 * std::sqrt(15.0) * static_cast<double>(std::numeric_limits<float>::epsilon()) * largest;
}

SearchReach::SearchReach(const FeatureAxes& axes, const Features& query, double relative_error)
    : scale_(axes.scale()),
      slack_(axes.slack_for(query)),
      factor_(1 + relative_error),
      limit_(std::numeric_limits<float>::max()) {}

void SearchReach::shrink_to(double distance_m) {
  const double reached = scale_ * distance_m + slack_;
  limit_ = std::min(limit_, static_cast<float>(reached * reached * factor_));
}

}  // namespace abrazo
