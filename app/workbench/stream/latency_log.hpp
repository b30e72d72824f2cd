#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/session/frames/frame_history.hpp"
#include "widgets/common/latency_sample.hpp"

namespace abrazo::app {

/// The latency of the session's frames: times stored in the frames, and drawing times. Bounded; older frames
/// are read from the history on demand.
class LatencyLog {
 public:
  static constexpr std::size_t most_samples = 14'400;  ///< two minutes at 120 Hz

  void clear();
  /// Reads the new frames of the history.
  void follow(const FrameHistory& history);
  void append(const FrameSnapshot& frame);
  /// Reports that a picture of a frame reached the screen; only the first per frame counts.
  /// @param to_screen_ms since its first packet; NaN if it was not drawn live
  void drawn(std::uint64_t index, double render_ms, double to_screen_ms);

  /// Samples in [from_s, to_s]; older ones are read from the history.
  std::vector<widgets::LatencySample> range(const FrameHistory& history, double from_s, double to_s) const;
  /// The sample of one frame, with the drawing time if it was drawn recently.
  widgets::LatencySample of(const FrameHistory& history, const FrameSnapshot& frame) const;

 private:
  struct Entry {
    std::uint64_t index = 0;
    widgets::LatencySample sample;
  };
  const Entry* find(std::uint64_t index) const;

  std::deque<Entry> m_entries;
  FrameSnapshot m_before;  ///< only index and times
  bool m_hasBefore = false;
  std::uint64_t m_next = 0;
};

}  // namespace abrazo::app
