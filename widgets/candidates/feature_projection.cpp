#include "widgets/candidates/feature_projection.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <stdexcept>

namespace abrazo::widgets {

FeatureProjection::FeatureProjection(std::span<const Features> features) {
  if (features.empty()) throw std::invalid_argument("a projection needs at least one feature vector");
  const auto count = static_cast<double>(features.size());
  for (const Features& feature : features) mean_ += feature;
  mean_ /= count;
  Eigen::Matrix<double, 15, 15> covariance = Eigen::Matrix<double, 15, 15>::Zero();
  for (const Features& feature : features) {
    const Features centred = feature - mean_;
    covariance.selfadjointView<Eigen::Lower>().rankUpdate(centred, 1 / count);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 15, 15>> solver(covariance);
  // Eigenvalues ascend.
  axes_.col(0) = solver.eigenvectors().col(14);
  axes_.col(1) = solver.eigenvectors().col(13);
  for (int axis = 0; axis < 2; ++axis) {
    Eigen::Index largest = 0;
    axes_.col(axis).cwiseAbs().maxCoeff(&largest);
    if (axes_(largest, axis) < 0) axes_.col(axis) *= -1;
  }
  const double all = solver.eigenvalues().sum();
  if (all > 0) explained_ = std::clamp(solver.eigenvalues().tail<2>().sum() / all, 0.0, 1.0);
}

Features user_features(const MotionLibrary& library, int pair, UserRole role) {
  if (role == UserRole::Active) return library.features(pair);
  const Pose passive = library.pose(pair).bottomRows<joint_count>();
  return pose_features(to_normalized(passive, root_frame(passive)));
}

namespace {

std::vector<Features> all_user_features(const MotionLibrary& library, UserRole role) {
  std::vector<Features> features;
  features.reserve(static_cast<std::size_t>(library.pair_count()));
  for (int pair = 0; pair < library.pair_count(); ++pair)
    features.push_back(user_features(library, pair, role));
  return features;
}

}  // namespace

FeatureCloud::FeatureCloud(const MotionLibrary& library, UserRole role)
    : FeatureCloud(all_user_features(library, role)) {}

FeatureCloud::FeatureCloud(std::span<const Features> features) : projection(features) {
  const std::size_t stride = (features.size() + most_points - 1) / most_points;
  low = high = projection(features.front());
  for (std::size_t pair = 0; pair < features.size(); ++pair) {
    const Eigen::Vector2d at = projection(features[pair]);
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
    if (pair % stride == 0) points.push_back({at, static_cast<int>(pair)});
  }
}

PlaneView PlaneView::fitting(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double width,
                             double height, double margin) {
  PlaneView view;
  view.middle = (low + high) / 2;
  view.centre_x = width / 2;
  view.centre_y = height / 2;
  const Eigen::Vector2d extent = high - low;
  const double across = std::max(1.0, width - 2 * margin), up = std::max(1.0, height - 2 * margin);
  constexpr double smallest = 1e-9;
  if (extent.maxCoeff() < smallest)
    view.pixels_per_metre = std::min(across, up);
  else
    view.pixels_per_metre =
        std::min(across / std::max(extent.x(), smallest), up / std::max(extent.y(), smallest));
  return view;
}

PlaneView PlaneView::nearer(double factor, const Eigen::Vector2d& point) const {
  PlaneView view = *this;
  view.middle = point;
  view.pixels_per_metre *= factor;
  return view;
}

Eigen::Vector2d PlaneView::pixel(const Eigen::Vector2d& point) const {
  return {centre_x + pixels_per_metre * (point.x() - middle.x()),
          centre_y - pixels_per_metre * (point.y() - middle.y())};
}

}  // namespace abrazo::widgets
