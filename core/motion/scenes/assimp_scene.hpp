#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads the animated skeletons of an FBX, glTF or Collada file: one motion for each. Of several animations
/// the longest is taken, and said. Sampled at the rate of its keys.
/// @param bytes  of the file; parts that stand in files beside it are read from there
Result<std::vector<NamedMotion>> read_scene(std::string_view bytes, MotionFormat format,
                                            const std::string& file);

}  // namespace abrazo
