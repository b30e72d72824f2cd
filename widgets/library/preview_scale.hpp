#pragma once

#include <memory>
#include <vector>

#include "core/motion/body/clip.hpp"

namespace abrazo::widgets {

/// A clip with its first used frame.
struct PreviewedClip {
  std::shared_ptr<const Clip> clip;
  int start = 0;

  int frames() const;
  /// The pose of a frame counted from the start, clamped to the end; null without a clip.
  const Pose* pose(int frame) const;
};

/// Scale and axis for drawing two people. Constant over a take, so that only the people move.
struct PreviewScale {
  double extent_m = 2.2;  ///< largest extent of the two in any direction, in one frame
  int side_axis = 0;      ///< 0 = x, 2 = z: the horizontal axis along which they are farther apart
};

/// @param b may have no clip
PreviewScale preview_scale(const PreviewedClip& a, const PreviewedClip& b);

/// Number of common frames; of the only clip if there is one.
int common_frames(const PreviewedClip& a, const PreviewedClip& b);

/// Middle of the people's bounding box in a frame [m].
Vec3 middle_of(const PreviewedClip& a, const PreviewedClip& b, int frame);

}  // namespace abrazo::widgets
