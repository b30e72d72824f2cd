#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// Frames kept outside memory, for times before FrameHistory's oldest frame. Thread-safe.
class FrameStore {
 public:
  virtual ~FrameStore() = default;
  struct Span {
    double first_s = 0, last_s = 0;
    std::uint64_t first_index = 0, last_index = 0;
    std::uint64_t frames = 0;
  };
  virtual Span span() const = 0;
  /// The last readable frame not after a time; null if there is none, or none nearby.
  virtual FrameSnapshotPtr at(double time_s) const = 0;
  /// A frame by its index in the session; null if it is not kept.
  virtual FrameSnapshotPtr frame(std::uint64_t index) const = 0;
  /// The frames in [from_s, to_s], evenly thinned to at most `most`.
  virtual std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const = 0;
  /// The same by index: all in [first, last].
  virtual std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last,
                                                std::size_t most) const = 0;
  /// Times of the frames in [from_s, to_s], ascending, also of unreadable ones where a store knows the times
  /// without the frames.
  virtual std::vector<double> times(double from_s, double to_s) const {
    std::vector<double> times_s;
    for (const FrameSnapshotPtr& frame : range(from_s, to_s, std::numeric_limits<std::size_t>::max()))
      times_s.push_back(frame->time_s);
    return times_s;
  }
  /// Whether `between` has what it would return in memory.
  virtual bool is_kept(std::uint64_t /*first*/, std::uint64_t /*last*/, std::size_t /*most*/) const {
    return false;
  }
  /// Index of the last frame not after this one that has the synthesizer's state; none if there is none.
  virtual std::optional<std::uint64_t> state_before(std::uint64_t index) const = 0;
};

}  // namespace abrazo
