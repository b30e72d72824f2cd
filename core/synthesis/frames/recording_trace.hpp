#pragma once

#include <string>

#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// As trace_frame_line of trace.hpp, of a frame that was not selected from a library: it has no candidates.
std::string trace_frame_line(const FrameResult& frame, long long input_frame, double time_s);

}  // namespace abrazo
