#pragma once

#include <span>

#include "core/base/positions.hpp"
#include "widgets/scene/actors/joint_trails.hpp"

namespace abrazo::widgets {

/// Look-ahead of the scene and its step, fine enough for smooth curves of the hands [s].
inline constexpr double ahead_s = 1, ahead_step_s = 0.05;

/// Future paths of a body's root, head, hands and feet as trails: age 0 is now, 1 is the end of the
/// look-ahead.
/// @param poses  the first is now, the others follow each `ahead_step_s`
/// @param first_vertex  of the body in the pair
JointTrails::Lines ahead_lines(std::span<const Pose> poses, int first_vertex);

}  // namespace abrazo::widgets
