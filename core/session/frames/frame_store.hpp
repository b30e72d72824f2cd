#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// Frames kept elsewhere than in memory: what FrameHistory asks for times before its oldest frame. Safe to
/// call from any thread.
class FrameStore {
 public:
  virtual ~FrameStore() = default;
  struct Span {
    double first_s = 0, last_s = 0;
    std::uint64_t first_index = 0, last_index = 0;
    std::uint64_t frames = 0;
  };
  virtual Span span() const = 0;
  /// The last frame not after a time that can be read; null when there is none, or none near.
  virtual FrameSnapshotPtr at(double time_s) const = 0;
  /// By its index in the session; null when it is not kept.
  virtual FrameSnapshotPtr frame(std::uint64_t index) const = 0;
  /// All frames in [from_s, to_s], at most `most` of them, then evenly thinned.
  virtual std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const = 0;
  /// The same by index: all in [first, last].
  virtual std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last,
                                                std::size_t most) const = 0;
  /// Index of the last frame, not after this one, that has the synthesizer's state; nothing when there is
  /// none.
  virtual std::optional<std::uint64_t> state_before(std::uint64_t index) const = 0;
};

}  // namespace abrazo
