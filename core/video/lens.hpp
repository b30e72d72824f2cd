#pragma once

#include <limits>
#include <optional>

#include "core/video/camera_model.hpp"

namespace abrazo {

/// From a camera's space to its picture (OpenCV 4.6, calib3d, "Detailed Description": Brown's model with
/// rational radial terms), with what is worked out once for many points.
class Lens {
 public:
  explicit Lens(const CameraIntrinsics& intrinsics);

  /// Nothing behind the camera, or beyond the radius where the distortion folds back.
  std::optional<Pixel> project(const Vec3& in_camera) const;
  /// Of the ray through (x, y, 1), wherever it is.
  Pixel distorted(double x, double y) const;
  /// Straight lines are straight in the picture.
  bool is_straight() const { return is_straight_; }

 private:
  struct Radial {
    double factor, slope;  ///< slope by the squared radius
    double down;           ///< the denominator
  };
  Radial radial(double r2) const;
  /// How much farther out a ray is seen that is farther out: the derivative of the radius.
  double outward(double r) const;

  CameraIntrinsics intrinsics_;
  bool is_straight_ = true;
  double largest_radius_ = std::numeric_limits<double>::infinity();  ///< tangent of the angle to the axis
};

}  // namespace abrazo
