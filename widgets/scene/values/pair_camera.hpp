#pragma once

#include "core/base/positions.hpp"
#include "widgets/scene/values/orbit_camera.hpp"

namespace abrazo::widgets {

/// Keeps a camera on a dancing pair: from the side, so that the space between the bodies is visible, with
/// heads and feet in view, and smoothly: small movements of the pair do not move it. Manual changes are
/// preserved. Independent of Qt and VTK.
class PairCamera {
 public:
  /// Jumps to the pair, and then follows its direction and distance.
  void start(OrbitCamera& camera, const PairPose& pair, const PictureShape& picture);
  /// Follows the pair by one step. @param elapsed_s since the last call
  void follow(OrbitCamera& camera, const PairPose& pair, const PictureShape& picture, double elapsed_s);
  /// As start, in the present view direction.
  void show_all(OrbitCamera& camera, const PairPose& pair, const PictureShape& picture);

  void turned_by_hand() { turns_ = false; }
  void zoomed_by_hand() { zooms_ = false; }

 private:
  void turn(OrbitCamera& camera, const PairPose& pair, double elapsed_s) const;

  Vec3 anchor_ = Vec3::Zero();  ///< followed point: the smoothed middle of the pair on the floor
  bool turns_ = true;
  bool zooms_ = true;
};

}  // namespace abrazo::widgets
