#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo {

/// The frames of a stretch of time as it was when a FrameHistory was asked for it (FrameHistory::stretch), in
/// order and of any length: those that only the store has are read a piece at a time, when their turn comes.
/// Outlives the history. Not thread-safe.
class FrameRange {
 public:
  /// So many frames of the store are held at most: 2 s at 120 Hz.
  static constexpr std::uint64_t piece = 256;

  FrameRange() = default;
  /// @param store       may be null; its frames [first, end) come before the others
  /// @param remembered  ascending, at indices from `end` on
  FrameRange(std::shared_ptr<const FrameStore> store, std::uint64_t first, std::uint64_t end,
             std::vector<FrameSnapshotPtr> remembered);

  bool empty() const { return size() == 0; }
  /// How many there are; of those in the store, some may turn out not to be readable.
  std::uint64_t size() const { return end_ - first_ + remembered_.size(); }
  /// The next one; null after the last.
  FrameSnapshotPtr next();
  /// From the first one again.
  void rewind();

 private:
  bool read_piece();

  std::shared_ptr<const FrameStore> store_;
  std::uint64_t first_ = 0, end_ = 0;  ///< that only the store has, by index
  std::vector<FrameSnapshotPtr> remembered_;
  std::vector<FrameSnapshotPtr> piece_;
  std::uint64_t unread_ = 0;  ///< index of the store's next frame that is not in the piece
  std::size_t in_piece_ = 0, in_memory_ = 0;
};

/// The frame that a range shows at each of several ascending times: the last one not after it.
class FrameRangeAtTimes {
 public:
  explicit FrameRangeAtTimes(FrameRange frames) : frames_(std::move(frames)) {}

  /// The first one when all are after `time_s`; null when there is none. A time before that of the call
  /// before starts from the beginning.
  FrameSnapshotPtr at(double time_s);

 private:
  FrameRange frames_;
  FrameSnapshotPtr shown_, next_;
};

}  // namespace abrazo
