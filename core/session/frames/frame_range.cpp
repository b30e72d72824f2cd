#include "core/session/frames/frame_range.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace abrazo {

FrameRange::FrameRange(std::shared_ptr<const FrameStore> store, std::uint64_t first, std::uint64_t end,
                       std::vector<FrameSnapshotPtr> remembered)
    : store_(std::move(store)),
      first_(first),
      end_(store_ ? std::max(first, end) : first),
      remembered_(std::move(remembered)),
      unread_(first_) {}

FrameSnapshotPtr FrameRange::next() {
  while (in_piece_ == piece_.size())
    if (!read_piece()) return in_memory_ < remembered_.size() ? remembered_[in_memory_++] : nullptr;
  // Releases returned frames, so that none is held longer than used.
  return std::move(piece_[in_piece_++]);
}

/// The store's next frames; of a stretch that cannot be read, none. @return false after the last one
bool FrameRange::read_piece() {
  piece_.clear();
  in_piece_ = 0;
  if (unread_ == end_) return false;
  const std::uint64_t piece_end = std::min(end_, unread_ + piece);
  constexpr auto all = std::numeric_limits<std::size_t>::max();
  piece_ = store_->between(unread_, piece_end - 1, all);
  unread_ = piece_end;
  return true;
}

void FrameRange::rewind() {
  piece_.clear();
  in_piece_ = in_memory_ = 0;
  unread_ = first_;
}

FrameSnapshotPtr FrameRangeAtTimes::at(double time_s) {
  if (!shown_ || time_s < shown_->time_s) {
    frames_.rewind();
    shown_ = frames_.next();
    next_ = frames_.next();
  }
  while (next_ && next_->time_s <= time_s) shown_ = std::exchange(next_, frames_.next());
  return shown_;
}

}  // namespace abrazo
