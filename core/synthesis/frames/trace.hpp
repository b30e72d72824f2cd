#pragma once

#include <string>

#include "core/base/json_text.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// The origin of a trace.
struct TraceHeader {
  std::string library;
  std::string input;
  double fps = 0;  ///< solved steps per second
  Settings settings;
};

/// First line of a trace, without the line end.
std::string trace_header_line(const TraceHeader& header);

/// One solved frame in the trace format, without the line end. Numbers read back to the same doubles; two
/// runs on the same input differ only in timing_us.
/// @param input_frame  0-based frame of the input;  @param time_s  of the input
std::string trace_frame_line(const FrameResult& frame, const MotionLibrary& library, long long input_frame,
                             double time_s);

}  // namespace abrazo
