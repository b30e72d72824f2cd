#include "core/session/frames/frame_gaps.hpp"

#include <algorithm>

namespace abrazo {

double gap_beyond_s(double left_out_s) {
  constexpr double gap_s = 0.5;   // of frames that are all read
  constexpr double uneven = 1.5;  // frames thinned evenly by index are not quite even in time
  return std::max(gap_s, uneven * left_out_s);
}

FrameInterval FrameGaps::next(const FrameSnapshot& frame, std::uint64_t frames_each) {
  // The first frames of an input come before its rate is measured.
  if (frame.input_rate_hz > 0) rate_hz_ = frame.input_rate_hz;
  FrameInterval interval;
  if (last_) {
    const std::uint64_t apart = frame.index > last_->index ? frame.index - last_->index : 1;
    interval.since_s = frame.time_s - last_->time_s;
    interval.is_adjacent = apart == 1;
    // The time that they took, not that of a gap among them.
    const std::uint64_t read_over = std::min(apart, frames_each);
    if (read_over > 1)
      interval.left_out_s = rate_hz_ > 0
                                ? std::min(interval.since_s, static_cast<double>(read_over) / rate_hz_)
                                : interval.since_s;
  }
  last_ = Last{frame.index, frame.time_s};
  return interval;
}

}  // namespace abrazo
