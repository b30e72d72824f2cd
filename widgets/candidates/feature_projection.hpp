#pragma once

#include <Eigen/Core>
#include <span>

#include "core/library/store/motion_library.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo::widgets {

/// The plane of largest variance of the 15-D features of a library: their first two principal components, so
/// that distances in it are metres and never larger than the feature distance.
class FeatureProjection {
 public:
  /// @param features  at least one; all finite
  explicit FeatureProjection(std::span<const Features> features);

  Eigen::Vector2d operator()(const Features& features) const {
    return axes_.transpose() * (features - mean_);
  }
  const Features& mean() const { return mean_; }
  /// Orthonormal columns, the larger spread first. The largest component of each is positive, so that the
  /// same library gives the same picture.
  const Eigen::Matrix<double, 15, 2>& axes() const { return axes_; }
  /// Explained share of the variance of all 15 dimensions [0, 1]; 1 without variance.
  double explained() const { return explained_; }

 private:
  Features mean_ = Features::Zero();
  Eigen::Matrix<double, 15, 2> axes_;
  double explained_ = 1;
};

/// Features used for comparison: those of the body that plays the user, relative to its root.
Features user_features(const MotionLibrary& library, int pair, UserRole role);

/// A pair of the library as a point of the plane.
struct CloudPoint {
  Eigen::Vector2d at;
  int pair = -1;
};

/// The projected library, computed once per library.
struct FeatureCloud {
  FeatureProjection projection;
  std::vector<CloudPoint> points;  ///< every n-th pair, at most `most_points`
  Eigen::Vector2d low, high;       ///< bounds of all pairs

  static constexpr int most_points = 3000;
  /// @param library  with at least one pair
  FeatureCloud(const MotionLibrary& library, UserRole role);

 private:
  explicit FeatureCloud(std::span<const Features> features);
};

/// Mapping from metres of the plane to pixels: equal scale, centred, y up.
struct PlaneView {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double pixels_per_metre = 1;
  double centre_x = 0, centre_y = 0;  ///< position of `middle` [px]

  /// Shows low..high within a rectangle, with a margin; 1 m if there is no extent.
  static PlaneView fitting(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double width,
                           double height, double margin);
  /// Zoomed by `factor`, centred on a point of the plane.
  PlaneView nearer(double factor, const Eigen::Vector2d& point) const;
  Eigen::Vector2d pixel(const Eigen::Vector2d& point) const;
};

}  // namespace abrazo::widgets
