#pragma once

#include <array>
#include <optional>

#include "widgets/scene/values/orbit_camera.hpp"
#include "widgets/scene/values/picture_projection.hpp"

namespace abrazo::widgets {

/// Corners of the outline of a plane, in order: a square of 1.8 m about its point.
std::array<Vec3, 4> outline_of(const CutPlane& plane);

/// What of a cutting plane the pointer holds.
enum class CutGrip { None, Move, Turn };

/// The handles of a cutting plane in a picture. Its outline and the shaft along its normal move it, the knob
/// at the tip of the shaft turns it about its point. Places are pixels from the upper left corner.
class CutHandles {
 public:
  /// @param width_px, height_px  of the picture
  CutHandles(const CutPlane& plane, const OrbitCamera& camera, double width_px, double height_px);

  CutGrip at(double x, double y) const;
  /// How far along the normal a drag moves the plane [m]: what is held follows the pointer. The more the
  /// normal points to the eye or away from it, the more the vertical part of the drag counts instead, by the
  /// size of a pixel at what is held. A pixel never moves the plane by more than two such sizes.
  double moved_m(double from_x, double from_y, double to_x, double to_y) const;
  /// The unit normal that has the knob at this place; beyond the knob's sphere the nearest.
  Vec3 turned(double x, double y) const;

  /// Corners, middle and knob; none where they are behind the eye.
  std::array<std::optional<PicturePoint>, 4> outline;
  std::optional<PicturePoint> middle, knob;

 private:
  CutPlane plane_;
  PictureProjection projection_;
};

}  // namespace abrazo::widgets
