#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads a BVH file: one motion for every ROOT. Points are the joints and the end sites ("<parent>_End").
/// Tolerates and reports common defects (glued numbers, wrong frame counts, CR line ends, ...).
Result<std::vector<NamedMotion>> read_bvh(std::string_view text, std::string_view where);

/// Writes clips of equal length and rate as one BVH with a ROOT for each, in metres or in `units_per_metre`.
/// Rotations are computed from positions; reading the file back gives the same joint positions if the clip's
/// bone lengths are constant (BVH has constant bone lengths). Joint names are those of the joint set,
/// prefixed by "<clip name>:" if there are several clips.
Result<std::string> write_bvh(std::span<const Clip> clips, double units_per_metre = 1.0);

}  // namespace abrazo
