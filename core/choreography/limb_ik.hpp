#pragma once

#include "core/base/positions.hpp"

namespace abrazo {

/// A knee or elbow: the point at `upper` from `base` and `lower` from `end` that lies towards `pole` (a
/// direction, need not be normal to the limb nor of unit length).
/// @throws std::invalid_argument if no such point exists (limb too short or folded too far) or the pole is
/// parallel to the limb
Vec3 middle_joint(const Vec3& base, const Vec3& end, double upper, double lower, const Vec3& pole);

/// `target`, drawn towards `base` if the limb would be stretched more than 93 %, so that it never exceeds 98
/// %, with continuous velocity; pushed away if it would fold below 30 %.
Vec3 within_reach(const Vec3& base, const Vec3& target, double limb_length);

}  // namespace abrazo
