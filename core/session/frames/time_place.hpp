#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/session/frames/frame_history.hpp"

namespace abrazo {

/// A place to go to: a frame by its index, or a session time; or so far from here.
struct TimePlace {
  enum class Kind { Frame, Time };
  Kind kind = Kind::Time;
  bool relative = false;   ///< to the cursor
  std::int64_t frame = 0;  ///< of Kind::Frame
  double time_s = 0;       ///< of Kind::Time

  bool operator==(const TimePlace&) const = default;
};

/// Reads "690" (a frame), "11.5s", "250 ms", "2 min", "0:11.5" (minutes), "1:02:03" (hours), "00:00:11:15"
/// (timecode, the last field in frames of `rate_hz`); with + or - in front it is relative. The error says
/// what can be written instead.
Result<TimePlace> parse_time_place(std::string_view text, double rate_hz);

/// The session time of a place, seen from the cursor. The error says why there is no frame there, and which
/// there are.
Result<double> find_time(const TimePlace& place, const FrameHistory& history, double cursor_s);

/// How a time is written.
enum class TimeFormat { Clock, Seconds, Frames, Timecode };

/// "00:11.500"; hours only when there are any.
std::string clock_text(double time_s);
/// "00:00:11:15": hours, minutes, seconds, frames of `rate_hz` rounded to a whole number. Without a rate the
/// frames are missing.
std::string timecode_text(double time_s, double rate_hz);
/// @param frame  written by TimeFormat::Frames; -1 when there is none
std::string time_text(TimeFormat format, double time_s, std::int64_t frame, double rate_hz);

}  // namespace abrazo
