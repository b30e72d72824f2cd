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
/// Tolerates and reports what is found in the wild (glued numbers, wrong frame counts, CR line ends, ...).
Result<std::vector<NamedMotion>> read_bvh(std::string_view text, std::string_view where);

/// Writes clips of equal length and rate as one BVH with a ROOT for each, in metres or in `units_per_metre`.
/// Rotations are found from positions; reading the file back gives the same joint positions (bone lengths are
/// constant in BVH, so as far as they are constant in the clip). Joint names are those of the joint set,
/// prefixed by "<clip name>:" when there are several clips.
Result<std::string> write_bvh(std::span<const Clip> clips, double units_per_metre = 1.0);

}  // namespace abrazo
