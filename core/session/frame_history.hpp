#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <vector>

#include "core/session/frame_snapshot.hpp"

namespace abrazo {

/// The solved frames of the last while, oldest first, bounded in bytes. Appended by the solver thread, read
/// by any.
class FrameHistory {
 public:
  explicit FrameHistory(std::size_t max_bytes = std::size_t{512} << 20);

  void append(FrameSnapshotPtr frame);
  void clear();

  struct Span {
    double first_s = 0;  ///< oldest kept
    double last_s = 0;
    std::size_t frames = 0;
    std::size_t evicted = 0;  ///< dropped from the old end because of the bound
    std::size_t bytes = 0;
  };
  Span span() const;

  /// The frame shown at a time: the last one not after it; the oldest kept when all are after; null when
  /// empty.
  FrameSnapshotPtr at(double time_s) const;
  /// The frame `steps` before (negative) or after the one shown at `time_s`, held at the ends.
  FrameSnapshotPtr stepped(double time_s, int steps) const;
  /// All frames in [from_s, to_s].
  std::vector<FrameSnapshotPtr> range(double from_s, double to_s) const;
  /// The frames in [from_s, to_s], after those back to the last one that has the synthesizer's state.
  struct SolvableAgain {
    std::vector<FrameSnapshotPtr> frames;  ///< the first has a state; empty when none in the range can be had
    std::size_t run_up = 0;                ///< so many of them come before the range
    bool is_short = false;  ///< the range begins later than asked: what it needs is no longer kept
  };
  SolvableAgain solvable_again(double from_s, double to_s) const;
  /// All frames whose index is at least `index`: what is new since a reader looked last.
  std::vector<FrameSnapshotPtr> since(std::uint64_t index) const;

 private:
  std::ptrdiff_t position_at(double time_s) const;
  std::ptrdiff_t first_not_before(double time_s) const;

  mutable std::mutex mutex_;
  std::deque<FrameSnapshotPtr> frames_;
  std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  std::size_t evicted_ = 0;
};

/// Memory that a snapshot holds, with its vectors [bytes].
std::size_t size_of(const FrameSnapshot& frame);

}  // namespace abrazo
