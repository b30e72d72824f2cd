#pragma once

#include <optional>

#include "widgets/scene/values/orbit_camera.hpp"

namespace abrazo::widgets {

/// A point in the picture: pixels from the upper left corner, and depth along the view direction [m].
struct PicturePoint {
  double x = 0, y = 0, depth_m = 0;
};

/// Projection of world points to a picture.
class PictureProjection {
 public:
  /// @param width_px, height_px  of the picture
  PictureProjection(const OrbitCamera& camera, double width_px, double height_px);

  /// None for a point before the near limit, or clipped.
  std::optional<PicturePoint> project(const Vec3& world) const;
  /// What lies under a place of the picture: points `from + t * along`, with a unit vector along.
  struct Ray {
    Vec3 from, along;
  };
  Ray ray(double x, double y) const;
  /// Of an object at this depth that faces the eye.
  double pixels_per_metre(double depth_m) const { return is_parallel_ ? focal_px_ : focal_px_ / depth_m; }

 private:
  Vec3 eye_, forward_, right_, up_;
  double width_px_, middle_y_px_;  ///< of the picture; where the target lies in it
  double focal_px_;                ///< pixels per unit of slope; parallel: pixels per metre
  double nearest_m_;               ///< of the camera
  bool is_parallel_;
  std::optional<CutPlane> plane_;
};

}  // namespace abrazo::widgets
