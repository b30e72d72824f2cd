#pragma once

#include <optional>

#include "widgets/scene/values/orbit_camera.hpp"

namespace abrazo::widgets {

/// A point in the picture: pixels from the upper left corner, and how far along the direction of view [m].
struct PicturePoint {
  double x = 0, y = 0, depth_m = 0;
};

/// Where world points come to lie in a picture.
class PictureProjection {
 public:
  /// @param width_px, height_px  of the picture
  PictureProjection(const OrbitCamera& camera, double width_px, double height_px);

  /// Nothing for a point that is nearer than the camera shows, or cut away.
  std::optional<PicturePoint> project(const Vec3& world) const;

 private:
  Vec3 eye_, forward_, right_, up_;
  double width_px_, height_px_;
  double focal_px_;   ///< pixels per unit of slope; parallel: pixels per metre
  double nearest_m_;  ///< of the camera
  bool is_parallel_;
  std::optional<CutPlane> plane_;
};

}  // namespace abrazo::widgets
