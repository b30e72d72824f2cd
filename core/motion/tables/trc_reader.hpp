#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Reads a TRC file (Motion Analysis, OpenSim): tab-separated markers, empty fields for gaps. Its counts are
/// checked; the actual content takes precedence. Several subjects ("Anna:LASI") give several motions.
Result<std::vector<NamedMotion>> read_trc(std::string_view text, std::string_view where);

}  // namespace abrazo
