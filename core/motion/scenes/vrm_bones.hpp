#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Calls the points of a GLB as VRM lists its bones ("leftupperleg"), whatever its nodes are called. Nothing
/// changes in a file without such a list.
void name_by_vrm(std::string_view bytes, std::vector<NamedMotion>& motions);

/// The bones of a VRM character without animation, as one frame: its rest pose. Nothing for other files.
Result<std::optional<NamedMotion>> rest_pose_of_vrm(std::string_view bytes, const std::string& where);

}  // namespace abrazo
