#pragma once

#include <span>

#include "core/base/positions.hpp"
#include "widgets/scene/actors/joint_trails.hpp"

namespace abrazo::widgets {

/// How far ahead the scene looks, and in which steps: fine enough that a hand's way is a curve.
inline constexpr double ahead_s = 1, ahead_step_s = 0.05;

/// Where a body's root, head, hands and feet will go, as trails into the future: age 0 is now, 1 is the end
/// of what is looked at.
/// @param poses  the first is now, the others follow each `ahead_step_s`
/// @param first_vertex  of the body in the pair
JointTrails::Lines ahead_lines(std::span<const Pose> poses, int first_vertex);

}  // namespace abrazo::widgets
