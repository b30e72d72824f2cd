#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads the animated skeletons of an FBX, glTF or Collada file: one motion for each. Sampled at the rate of
/// its keys.
/// @param bytes      of the file; parts that stand in files beside it are read from there
/// @param animation name of the animation; empty = the longest, with a warning
Result<std::vector<NamedMotion>> read_scene(std::string_view bytes, MotionFormat format,
                                            const std::string& file, const std::string& animation = {});

}  // namespace abrazo
