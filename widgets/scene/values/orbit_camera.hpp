#pragma once

#include <optional>

#include "core/base/positions.hpp"
#include "widgets/scene/values/cut_plane.hpp"

namespace abrazo::widgets {

/// Shape of the picture.
struct PictureShape {
  double aspect = 1;          ///< width / height
  double used_height = 0.84;  ///< share of the height without overlays
};

/// A camera that orbits a target and keeps the world upright. Independent of Qt and VTK.
struct OrbitCamera {
  Vec3 target = Vec3(0, 0.9, 0);
  double azimuth_rad = 0.5;     ///< about +Y; 0 looks along -Z from +Z
  double elevation_rad = 0.12;  ///< above the horizon
  double distance_m = 4;
  double view_angle_rad = 0.52;  ///< vertical
  bool is_parallel = false;  ///< parallel instead of perspective projection; objects at the target keep their
                             ///< size
  bool cuts = false;         ///< clips everything nearer than the plane `cut_m` in front of the target
  double cut_m = 0;          ///< negative: behind the target
  std::optional<CutPlane> plane;  ///< clips everything beyond a plane of the world
  double shift_m = 0;  ///< centre of the picture, to the right of the target: room for objects beside it
  /// By this share of half the picture's height the target is drawn below the middle: room for controls
  /// above. Belongs to the picture, not to the view, so it is not compared.
  double lowered = 0;
  /// Compares the view without cutting planes.
  bool operator==(const OrbitCamera& other) const;

  Vec3 position() const;
  /// The point at the centre of the picture.
  Vec3 focus() const { return target + shift_m * right(); }
  Vec3 right() const;
  Vec3 up() const;
  /// Near limit along the view direction.
  double nearest_shown_m() const;

  /// A drag of (dx, dy) pixels to the right and down rotates the scene with the pointer.
  void orbit(double dx_px, double dy_px);
  /// Keeps the point of the target plane under the pointer.
  void pan(double dx_px, double dy_px, double view_height_px);
  /// One wheel notch is 1: nearer for positive.
  void zoom(double notches);
  /// Distance from the target at which bodies with these joints fit into the picture, in the present view
  /// direction.
  /// @param points N x 3; with a margin for the body around them
  double distance_for(const Positions& points, const PictureShape& picture) const;
};

}  // namespace abrazo::widgets
