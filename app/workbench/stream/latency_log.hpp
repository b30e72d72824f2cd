#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/session/frames/frame_history.hpp"
#include "widgets/common/latency_sample.hpp"

namespace abrazo::app {

/// The latency of the session's frames: what the frames themselves say, and of those that were drawn how long
/// that took. Bounded; older frames are read from the history again when they are shown.
class LatencyLog {
 public:
  static constexpr std::size_t most_samples = 14'400;  ///< two minutes at 120 Hz

  void clear();
  /// What is new in the history since the last call.
  void follow(const FrameHistory& history);
  void append(const FrameSnapshot& frame);
  /// A picture of a frame reached the screen; of several only the first counts.
  /// @param to_screen_ms  since its first packet; NaN when it was not drawn as it came
  void drawn(std::uint64_t index, double render_ms, double to_screen_ms);

  /// In [from_s, to_s]; from the history where it is older than what is kept here.
  std::vector<widgets::LatencySample> range(const FrameHistory& history, double from_s, double to_s) const;
  /// Of one frame; with what drawing it took if it was drawn lately.
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
