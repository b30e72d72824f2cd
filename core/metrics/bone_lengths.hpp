#pragma once

#include <span>

#include "core/motion/body/body.hpp"

namespace abrazo {

/// Deviation of a motion's bone lengths from a body's: |length - wanted| / wanted over all bones and frames.
struct BoneLengthError {
  double mean = 0;
  double max = 0;
};

/// Bones shorter than 1 um in the body and pseudo-bones are left out. Zero for no poses.
BoneLengthError measure_bone_lengths(std::span<const Pose> poses, const Body& wanted);

}  // namespace abrazo
