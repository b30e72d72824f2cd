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

  /// Samples of every frame in [from_s, to_s]. Older ones, and those between frames that were left out when a
  /// long recording was followed, are read from the history, each once while the range moves on.
  std::vector<widgets::LatencySample> range(const FrameHistory& history, double from_s, double to_s);
  /// The sample of one frame, with the drawing time if it was drawn recently.
  widgets::LatencySample of(const FrameHistory& history, const FrameSnapshot& frame) const;

 private:
  struct Entry {
    std::uint64_t index = 0;
    widgets::LatencySample sample;
    bool is_after_others = false;  ///< frames before it were left out
  };
  const Entry* find(std::uint64_t index) const;
  bool has_all(double from_s, double to_s) const;
  void read(const FrameHistory& history, double from_s, double to_s);
  widgets::LatencySample with_drawing(widgets::LatencySample sample, std::uint64_t index) const;

  /// Frames that were read for the last range.
  struct Stretch {
    double from_s = 0, to_s = -1;
    FrameSnapshotPtr last;  ///< null = nothing was read
    std::deque<Entry> entries;
  };

  std::deque<Entry> m_entries;
  Stretch m_read;
  FrameSnapshot m_before;  ///< only index and times
  bool m_hasBefore = false;
  std::uint64_t m_next = 0;
};

}  // namespace abrazo::app
