#pragma once

#include <span>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// The frames in which a foot stands: its toe base less than 3.5 cm above its rest (the 5th percentile of its
/// height) and slower than 0.5 m/s over the floor, without gaps and runs shorter than 1/15 s.
std::vector<char> standing_frames(std::span<const Vec3> toe_base, double fps);

/// Offset of a foot from its recorded (and scaled) path: constant while it stands, at the mean of the wanted
/// offsets, so that a foot that stood still stands still; from one stand to the next a cubic that begins and
/// ends at rest. For a foot that never stands, the wanted offset itself.
std::vector<Vec3> stepwise(std::span<const Vec3> wanted, std::span<const char> standing);

}  // namespace abrazo
