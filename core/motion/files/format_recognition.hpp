#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/motion/joints/motion_format.hpp"

namespace abrazo {

/// What a file's bytes are, whatever its name; nothing when they do not tell.
/// @param head  the first few kilobytes suffice
std::optional<MotionFormat> format_of_content(std::string_view head);

/// Of a file that is no motion: what it is and what to do ("is a USD file; export FBX or BVH from ...");
/// empty when it cannot be told.
std::string foreign_kind(std::string_view head, std::string_view file);

}  // namespace abrazo
