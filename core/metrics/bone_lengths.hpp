#pragma once

#include <span>

#include "core/motion/body/body.hpp"

namespace abrazo {

/// How far a motion's bones are from a body's, |length - wanted| / wanted over all bones and frames.
struct BoneLengthError {
  double mean = 0;
  double max = 0;
};

/// Bones that the body has no length for (under 1 um) and pseudo-bones are left out. Zero for no poses.
BoneLengthError measure_bone_lengths(std::span<const Pose> poses, const Body& wanted);

}  // namespace abrazo
