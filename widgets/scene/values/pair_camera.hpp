#pragma once

#include "core/base/positions.hpp"
#include "widgets/scene/values/orbit_camera.hpp"

namespace abrazo::widgets {

/// Keeps a camera on a dancing pair: from the side, so that the space between the bodies is seen, with heads
/// and feet in view, and calmly: small movements of the pair do not move it. What a person has changed by
/// hand is left as it is. Plain arithmetic, no toolkit.
class PairCamera {
 public:
  /// Jumps to the pair, and then follows its direction and distance.
  void start(OrbitCamera& camera, const PairPose& pair, const PictureShape& picture);
  /// Moves on a little. @param elapsed_s  since the last call
  void follow(OrbitCamera& camera, const PairPose& pair, const PictureShape& picture, double elapsed_s);
  /// As start, in the direction the camera has.
  void show_all(OrbitCamera& camera, const PairPose& pair, const PictureShape& picture);

  void turned_by_hand() { turns_ = false; }
  void zoomed_by_hand() { zooms_ = false; }

 private:
  void turn(OrbitCamera& camera, const PairPose& pair, double elapsed_s) const;

  Vec3 anchor_ = Vec3::Zero();  ///< what is followed: the middle of the pair on the floor, calmed
  bool turns_ = true;
  bool zooms_ = true;
};

}  // namespace abrazo::widgets
