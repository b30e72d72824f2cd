#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/session/frames/frame_history.hpp"

namespace abrazo {

/// A target for the time cursor: a frame index or a session time, absolute or relative.
struct TimePlace {
  enum class Kind { Frame, Time };
  Kind kind = Kind::Time;
  bool relative = false;   ///< to the cursor
  std::int64_t frame = 0;  ///< of Kind::Frame
  double time_s = 0;       ///< of Kind::Time

  bool operator==(const TimePlace&) const = default;
};

/// Reads "690" (a frame), "11.5s", "250 ms", "2 min", "0:11.5" (minutes), "1:02:03" (hours), "00:00:11:15"
/// (timecode, the last field in frames of `rate_hz`); a leading + or - makes it relative. The Error lists the
/// accepted forms.
Result<TimePlace> parse_time_place(std::string_view text, double rate_hz);

/// The session time of a place, relative to the cursor if it is relative. The Error says why there is no
/// frame there, and lists the available range.
Result<double> find_time(const TimePlace& place, const FrameHistory& history, double cursor_s);

/// Text format of a time.
enum class TimeFormat { Clock, Seconds, Frames, Timecode };

/// "00:11.500"; hours only if not zero, with a minus before the beginning.
std::string clock_text(double time_s);
/// "00:00:11:15": hours, minutes, seconds, frames of `rate_hz` rounded to a whole number. Without a rate the
/// frames field is omitted.
std::string timecode_text(double time_s, double rate_hz);
/// @param frame used by TimeFormat::Frames; -1 if there is none
std::string time_text(TimeFormat format, double time_s, std::int64_t frame, double rate_hz);

}  // namespace abrazo
