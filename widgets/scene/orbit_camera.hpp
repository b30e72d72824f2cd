#pragma once

#include "core/base/positions.hpp"

namespace abrazo::widgets {

/// A camera that circles a target and keeps the world upright. Plain arithmetic, no toolkit.
struct OrbitCamera {
  Vec3 target = Vec3(0, 0.9, 0);
  double azimuth_rad = 0.5;     ///< about +Y; 0 looks along -Z from +Z
  double elevation_rad = 0.12;  ///< above the horizon
  double distance_m = 4;
  double view_angle_rad = 0.52;  ///< vertical

  Vec3 position() const;
  Vec3 right() const;
  Vec3 up() const;

  /// A drag of (dx, dy) pixels to the right and down turns the scene with the pointer.
  void orbit(double dx_px, double dy_px);
  /// Keeps the point of the target plane under the pointer.
  void pan(double dx_px, double dy_px, double view_height_px);
  /// One wheel notch is 1: nearer for positive.
  void zoom(double notches);
  /// Moves back until a ball fits, keeping the direction.
  void frame(const Vec3& centre, double radius_m, double aspect);
};

}  // namespace abrazo::widgets
