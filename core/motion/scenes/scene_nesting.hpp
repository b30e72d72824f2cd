#pragma once

#include <cstddef>
#include <string_view>

#include "core/motion/joints/motion_format.hpp"

namespace abrazo {

/// How deep the elements of an FBX or Collada file stand inside each other: brackets of text, tags, records.
/// Read without recursion, for readers that descend by it. Counts up to the first place where the file is
/// damaged. 0 for glTF, whose JSON has bounds of its own.
std::size_t scene_nesting(std::string_view bytes, MotionFormat format);

}  // namespace abrazo
