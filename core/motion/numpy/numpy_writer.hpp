#pragma once

#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/joints/joint_order.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Positions (frames, joints, 3) of one clip as a .npy: float64, C order, no names and no rate. They read
/// back to the same doubles.
Result<std::string> write_npy(const Clip& clip, const JointOrder& order);

/// A .npz as `read_numpy` reads it: `positions` of one clip, `person1`, `person2`, ... of several, with
/// joint_names, fps, up and metres_per_unit. Clips that differ in rate are an Error.
Result<std::string> write_npz(std::span<const Clip> clips, const JointOrder& order, UpAxis up,
                              double metres_per_unit);

}  // namespace abrazo
