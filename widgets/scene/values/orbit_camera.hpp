#pragma once

#include <optional>

#include "core/base/positions.hpp"
#include "widgets/scene/values/cut_plane.hpp"

namespace abrazo::widgets {

/// What a camera fills.
struct PictureShape {
  double aspect = 1;          ///< width / height
  double used_height = 0.84;  ///< share of the height that nothing is written over
};

/// A camera that circles a target and keeps the world upright. Plain arithmetic, no toolkit.
struct OrbitCamera {
  Vec3 target = Vec3(0, 0.9, 0);
  double azimuth_rad = 0.5;     ///< about +Y; 0 looks along -Z from +Z
  double elevation_rad = 0.12;  ///< above the horizon
  double distance_m = 4;
  double view_angle_rad = 0.52;  ///< vertical
  bool is_parallel = false;  ///< parallel instead of central projection; what is at the target keeps its size
  bool cuts = false;         ///< leaves out what is nearer than the plane `cut_m` before the target
  double cut_m = 0;          ///< negative: behind the target
  std::optional<CutPlane> plane;  ///< leaves out what is beyond a plane of the world
  double shift_m = 0;  ///< the picture's middle, to the right of the target: room for what stands beside it
  /// The same view; what is cut away does not count.
  bool operator==(const OrbitCamera& other) const;

  Vec3 position() const;
  /// What the picture has in its middle.
  Vec3 focus() const { return target + shift_m * right(); }
  Vec3 right() const;
  Vec3 up() const;
  /// Along the direction of view: what is nearer is not shown.
  double nearest_shown_m() const;

  /// A drag of (dx, dy) pixels to the right and down turns the scene with the pointer.
  void orbit(double dx_px, double dy_px);
  /// Keeps the point of the target plane under the pointer.
  void pan(double dx_px, double dy_px, double view_height_px);
  /// One wheel notch is 1: nearer for positive.
  void zoom(double notches);
  /// How far from the target bodies with these joints fit into the picture, in the direction the camera has.
  /// @param points  N x 3; the flesh around them is allowed for
  double distance_for(const Positions& points, const PictureShape& picture) const;
};

}  // namespace abrazo::widgets
