#pragma once

#include <Eigen/Core>
#include <span>

#include "core/library/store/motion_library.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo::widgets {

/// The plane through the 15-D features of a library in which they spread most: their first two principal
/// components, so that distances in it are metres and never larger than the feature distance.
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
  /// Of the variance of all 15 dimensions [0, 1]; 1 when there is none.
  double explained() const { return explained_; }

 private:
  Features mean_ = Features::Zero();
  Eigen::Matrix<double, 15, 2> axes_;
  double explained_ = 1;
};

/// What a pair is compared by: the features of the body that plays the user, relative to its own root.
Features user_features(const MotionLibrary& library, int pair, UserRole role);

/// A pair of the library as a point of the plane.
struct CloudPoint {
  Eigen::Vector2d at;
  int pair = -1;
};

/// The library as a picture: what is computed once per library.
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

/// Metres of the plane to pixels, the same in both directions, the middle in the middle, y up.
struct PlaneView {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double pixels_per_metre = 1;
  double centre_x = 0, centre_y = 0;  ///< where `middle` is [px]

  /// Shows low..high within a rectangle, with a margin; of no extent at all 1 m.
  static PlaneView fitting(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double width,
                           double height, double margin);
  /// `factor` times nearer, about a point of the plane that moves to the middle.
  PlaneView nearer(double factor, const Eigen::Vector2d& point) const;
  Eigen::Vector2d pixel(const Eigen::Vector2d& point) const;
};

}  // namespace abrazo::widgets
