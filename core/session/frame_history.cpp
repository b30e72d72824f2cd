#include "core/session/frame_history.hpp"

#include <algorithm>

#include "core/synthesis/synthesizer_state.hpp"

namespace abrazo {

namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.capacity() * sizeof(T);
}

}  // namespace

std::size_t size_of(const FrameSnapshot& frame) {
  const FrameResult& r = frame.result;
  return sizeof(FrameSnapshot) + bytes_of(r.candidates) + bytes_of(r.edges) + bytes_of(r.tetrahedra) +
         bytes_of(r.edge_weights) + bytes_of(r.edge_residuals_m) + bytes_of(r.morph_steps) +
         bytes_of(r.foot_locks) + bytes_of(r.collisions) + r.message.capacity() +
         (frame.before ? sizeof(SynthesizerState) : 0);
}

FrameHistory::FrameHistory(std::size_t max_bytes) : max_bytes_(max_bytes) {}

void FrameHistory::append(FrameSnapshotPtr frame) {
  std::vector<FrameSnapshotPtr> evicted;  // destroyed outside the lock
  const std::size_t bytes = size_of(*frame);
  const std::scoped_lock lock(mutex_);
  frames_.push_back(std::move(frame));
  bytes_ += bytes;
  while (bytes_ > max_bytes_ && frames_.size() > 1) {
    bytes_ -= size_of(*frames_.front());
    evicted.push_back(std::move(frames_.front()));
    frames_.pop_front();
    ++evicted_;
  }
}

void FrameHistory::clear() {
  std::deque<FrameSnapshotPtr> old;
  const std::scoped_lock lock(mutex_);
  old.swap(frames_);
  bytes_ = 0;
  evicted_ = 0;
}

FrameHistory::Span FrameHistory::span() const {
  const std::scoped_lock lock(mutex_);
  Span span;
  span.frames = frames_.size();
  span.evicted = evicted_;
  span.bytes = bytes_;
  if (!frames_.empty()) {
    span.first_s = frames_.front()->time_s;
    span.last_s = frames_.back()->time_s;
  }
  return span;
}

std::ptrdiff_t FrameHistory::position_at(double time_s) const {
  const auto after =
      std::upper_bound(frames_.begin(), frames_.end(), time_s,
                       [](double t, const FrameSnapshotPtr& frame) { return t < frame->time_s; });
  return std::max<std::ptrdiff_t>(0, after - frames_.begin() - 1);
}

FrameSnapshotPtr FrameHistory::at(double time_s) const {
  return stepped(time_s, 0);
}

FrameSnapshotPtr FrameHistory::stepped(double time_s, int steps) const {
  const std::scoped_lock lock(mutex_);
  if (frames_.empty()) return nullptr;
  const auto last = static_cast<std::ptrdiff_t>(frames_.size()) - 1;
  return frames_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(position_at(time_s) + steps, 0, last))];
}

std::vector<FrameSnapshotPtr> FrameHistory::range(double from_s, double to_s) const {
  const std::scoped_lock lock(mutex_);
  const auto first = frames_.begin() + first_not_before(from_s);
  const auto last = std::upper_bound(
      first, frames_.end(), to_s, [](double t, const FrameSnapshotPtr& frame) { return t < frame->time_s; });
  return {first, last};
}

std::ptrdiff_t FrameHistory::first_not_before(double time_s) const {
  return std::lower_bound(frames_.begin(), frames_.end(), time_s,
                          [](const FrameSnapshotPtr& frame, double t) { return frame->time_s < t; }) -
         frames_.begin();
}

FrameHistory::SolvableAgain FrameHistory::solvable_again(double from_s, double to_s) const {
  const std::scoped_lock lock(mutex_);
  const auto count = static_cast<std::ptrdiff_t>(frames_.size());
  const auto has_state = [&](std::ptrdiff_t i) {
    return frames_[static_cast<std::size_t>(i)]->before != nullptr;
  };
  std::ptrdiff_t asked = first_not_before(from_s);
  std::ptrdiff_t first = std::min(asked, count - 1);
  while (first > 0 && !has_state(first)) --first;
  SolvableAgain found;
  if (first < 0 || !has_state(first)) {
    for (first = asked; first < count && !has_state(first);) ++first;
    asked = first;
    found.is_short = true;
  }
  found.run_up = static_cast<std::size_t>(asked - first);
  for (std::ptrdiff_t i = first; i < count && frames_[static_cast<std::size_t>(i)]->time_s <= to_s; ++i)
    found.frames.push_back(frames_[static_cast<std::size_t>(i)]);
  if (found.frames.size() <= found.run_up) found = {{}, 0, found.is_short};
  return found;
}

std::vector<FrameSnapshotPtr> FrameHistory::since(std::uint64_t index) const {
  const std::scoped_lock lock(mutex_);
  const auto first =
      std::lower_bound(frames_.begin(), frames_.end(), index,
                       [](const FrameSnapshotPtr& frame, std::uint64_t i) { return frame->index < i; });
  return {first, frames_.end()};
}

}  // namespace abrazo
