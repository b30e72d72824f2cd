#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads the animated skeletons of an FBX, glTF or Collada file: one motion for each. Sampled at the rate of
/// its keys. In this process and without limits: for the separate program that reads scenes
/// (scene_process.hpp).
/// @param bytes      of the file; parts of a .gltf in other files are read from its folder
/// @param animation  name of the animation if there are several; empty: the longest, with a warning
/// @throws std::bad_alloc
Result<std::vector<NamedMotion>> read_scene(std::string_view bytes, MotionFormat format,
                                            const std::string& file, const std::string& animation = {});

}  // namespace abrazo
