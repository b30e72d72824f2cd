#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads the markers of a C3D file (c3d.org): Intel, DEC and MIPS processors, scaled integers and floats,
/// more than 255 labels (LABELS2, ...) and more than 65535 frames (TRIAL:ACTUAL_*_FIELD, POINT:LONG_FRAMES).
/// A marker with residual -1, NaN, or exactly at the origin was not seen: NaN. Analog channels and model
/// outputs (angles, forces, ...) are left out. Several subjects give several motions.
Result<std::vector<NamedMotion>> read_c3d(std::string_view bytes, std::string_view where);

}  // namespace abrazo
