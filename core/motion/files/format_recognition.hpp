#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/motion/joints/motion_format.hpp"

namespace abrazo {

/// Format of a file by its content, regardless of its name; none if unknown.
/// @param head  the first few kilobytes suffice
std::optional<MotionFormat> format_of_content(std::string_view head);

/// For a file that is not a supported motion: what it is and what to do ("is a USD file; export FBX or BVH
/// from ..."); empty if unknown.
std::string foreign_kind(std::string_view head, std::string_view file);

}  // namespace abrazo
