#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo {

/// The frames of a time range at the moment of FrameHistory::stretch, in order and of any number. Frames that
/// are only in the store are read piece by piece on demand. Outlives the history. Not thread-safe.
class FrameRange {
 public:
  /// Maximum number of store frames held at once: 2 s at 120 Hz.
  static constexpr std::uint64_t piece = 256;

  FrameRange() = default;
  /// @param store       may be null; its frames [first, end) come before the others
  /// @param remembered  ascending, at indices from `end` on
  FrameRange(std::shared_ptr<const FrameStore> store, std::uint64_t first, std::uint64_t end,
             std::vector<FrameSnapshotPtr> remembered);

  bool empty() const { return size() == 0; }
  /// Number of frames; some of those in the store may turn out to be unreadable.
  std::uint64_t size() const { return end_ - first_ + remembered_.size(); }
  /// The next frame; null after the last.
  FrameSnapshotPtr next();
  /// Returns to the first frame.
  void rewind();

 private:
  bool read_piece();

  std::shared_ptr<const FrameStore> store_;
  std::uint64_t first_ = 0, end_ = 0;  ///< indices of frames that are only in the store
  std::vector<FrameSnapshotPtr> remembered_;
  std::vector<FrameSnapshotPtr> piece_;
  std::uint64_t unread_ = 0;  ///< index of the store's first frame after the piece
  std::size_t in_piece_ = 0, in_memory_ = 0;
};

/// The frame that a range shows at each of several ascending times: the last one not after it.
class FrameRangeAtTimes {
 public:
  explicit FrameRangeAtTimes(FrameRange frames) : frames_(std::move(frames)) {}

  /// The first frame if all are after `time_s`; null if there are none. A time before that of the previous
  /// call rewinds.
  FrameSnapshotPtr at(double time_s);

 private:
  FrameRange frames_;
  FrameSnapshotPtr shown_, next_;
};

}  // namespace abrazo
