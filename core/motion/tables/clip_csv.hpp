#pragma once

#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"

namespace abrazo {

/// World positions of the 25 joints as CSV: header "frame,time,root_x,root_y,root_z,..."; with several clips,
/// columns are prefixed by the clip's name ("active.root_x"). Numbers read back to the same doubles.
Result<std::string> write_clip_csv(std::span<const Clip> clips);

}  // namespace abrazo
