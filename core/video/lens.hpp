#pragma once

#include <limits>
#include <optional>

#include "core/video/camera_model.hpp"

namespace abrazo {

/// From a camera's space to its picture (OpenCV 4.6, calib3d, "Detailed Description": Brown's model with
/// rational radial terms), with precomputed values for many points.
class Lens {
 public:
  explicit Lens(const CameraIntrinsics& intrinsics);

  /// None behind the camera, or beyond the radius where the distortion folds back.
  std::optional<Pixel> project(const Vec3& in_camera) const;
  /// Pixel of the ray through (x, y, 1), without checks.
  Pixel distorted(double x, double y) const;
  /// Whether the lens has no distortion.
  bool is_straight() const { return is_straight_; }

 private:
  struct Radial {
    double factor, slope;  ///< derivative by the squared radius
    double down;           ///< the denominator
  };
  Radial radial(double r2) const;
  /// Derivative of the distorted radius by the undistorted radius.
  double outward(double r) const;

  CameraIntrinsics intrinsics_;
  bool is_straight_ = true;
  double largest_radius_ = std::numeric_limits<double>::infinity();  ///< tangent of the angle to the axis
};

}  // namespace abrazo
