#include "core/session/frame_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

void FrameHistory::set_store(std::shared_ptr<const FrameStore> store) {
  const std::scoped_lock lock(mutex_);
  store_ = std::move(store);
}

std::shared_ptr<const FrameStore> FrameHistory::store() const {
  const std::scoped_lock lock(mutex_);
  return store_;
}

void FrameHistory::clear() {
  std::deque<FrameSnapshotPtr> old;
  const std::scoped_lock lock(mutex_);
  old.swap(frames_);
  bytes_ = 0;
  evicted_ = 0;
}

FrameHistory::Span FrameHistory::span() const {
  const auto [memory, store] = view();
  Span span = memory;
  if (!store) return span;
  const FrameStore::Span stored = store->span();
  if (stored.frames == 0) return span;
  if (span.frames == 0) {
    span.first_index = stored.first_index;
    span.first_s = stored.first_s;
    span.last_s = stored.last_s;
    span.memory_first_s = std::nextafter(span.last_s, std::numeric_limits<double>::infinity());
    span.stored = stored.frames;
  } else if (stored.first_index < span.first_index) {
    span.stored = std::min(stored.last_index + 1, span.first_index) - stored.first_index;
    span.first_index = stored.first_index;
    span.first_s = stored.first_s;
  }
  return span;
}

/// What memory has, as a span, and the store, as they are at one time. The store is asked without the lock:
/// the solver never waits for the disk.
std::pair<FrameHistory::Span, std::shared_ptr<const FrameStore>> FrameHistory::view() const {
  const std::scoped_lock lock(mutex_);
  Span span;
  span.frames = frames_.size();
  span.evicted = evicted_;
  span.bytes = bytes_;
  if (!frames_.empty()) {
    span.first_s = span.memory_first_s = frames_.front()->time_s;
    span.last_s = frames_.back()->time_s;
    span.first_index = frames_.front()->index;
  }
  return {span, store_};
}

std::ptrdiff_t FrameHistory::position_at(double time_s) const {
  const auto after =
      std::upper_bound(frames_.begin(), frames_.end(), time_s,
                       [](double t, const FrameSnapshotPtr& frame) { return t < frame->time_s; });
  return std::max<std::ptrdiff_t>(0, after - frames_.begin() - 1);
}

std::ptrdiff_t FrameHistory::first_not_before(double time_s) const {
  return std::lower_bound(frames_.begin(), frames_.end(), time_s,
                          [](const FrameSnapshotPtr& frame, double t) { return frame->time_s < t; }) -
         frames_.begin();
}

FrameSnapshotPtr FrameHistory::at(double time_s) const {
  return stepped(time_s, 0);
}

FrameSnapshotPtr FrameHistory::remembered(double time_s, int steps, bool only_inside) const {
  const std::scoped_lock lock(mutex_);
  if (frames_.empty()) return nullptr;
  const auto last = static_cast<std::ptrdiff_t>(frames_.size()) - 1;
  const std::ptrdiff_t wanted = position_at(time_s) + steps;
  if (only_inside && (time_s < frames_.front()->time_s || wanted < 0)) return nullptr;
  return frames_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(wanted, 0, last))];
}

FrameSnapshotPtr FrameHistory::stepped(double time_s, int steps) const {
  const std::shared_ptr<const FrameStore> store = this->store();
  if (const FrameSnapshotPtr frame = remembered(time_s, steps, store != nullptr)) return frame;
  if (store)
    if (const FrameSnapshotPtr frame = stored_step(*store, time_s, steps)) return frame;
  return remembered(time_s, steps, false);
}

/// A step that begins or ends where only the store has frames.
FrameSnapshotPtr FrameHistory::stored_step(const FrameStore& store, double time_s, int steps) const {
  const FrameStore::Span span = store.span();
  if (span.frames == 0) return nullptr;
  FrameSnapshotPtr from = remembered(time_s, 0, true);
  if (!from) from = time_s < span.first_s ? store.frame(span.first_index) : store.at(time_s);
  if (!from || steps == 0) return from;
  const auto wanted = static_cast<std::int64_t>(from->index) + steps;
  const auto index =
      static_cast<std::uint64_t>(std::max(wanted, static_cast<std::int64_t>(span.first_index)));
  {
    const std::scoped_lock lock(mutex_);
    if (!frames_.empty() && index >= frames_.front()->index)
      return frames_[std::min<std::size_t>(index - frames_.front()->index, frames_.size() - 1)];
  }
  const FrameSnapshotPtr frame = store.frame(std::min(index, span.last_index));
  return frame ? frame : from;  // of a lost or damaged frame the one it was stepped from stays
}

std::vector<FrameSnapshotPtr> FrameHistory::range(double from_s, double to_s, std::size_t most) const {
  std::vector<FrameSnapshotPtr> remembered;
  std::uint64_t first_index = std::numeric_limits<std::uint64_t>::max();
  double first_s = std::numeric_limits<double>::infinity();
  std::shared_ptr<const FrameStore> store;
  {
    const std::scoped_lock lock(mutex_);
    const auto first = frames_.begin() + first_not_before(from_s);
    const auto last =
        std::upper_bound(first, frames_.end(), to_s,
                         [](double t, const FrameSnapshotPtr& frame) { return t < frame->time_s; });
    remembered.assign(first, last);
    store = store_;
    if (!frames_.empty()) {
      first_index = frames_.front()->index;
      first_s = frames_.front()->time_s;
    }
  }
  if (!store || from_s >= first_s) return remembered;
  std::vector<FrameSnapshotPtr> frames = store->range(
      from_s, std::min(to_s, std::nextafter(first_s, -std::numeric_limits<double>::infinity())), most);
  std::erase_if(frames, [&](const FrameSnapshotPtr& frame) { return frame->index >= first_index; });
  frames.insert(frames.end(), remembered.begin(), remembered.end());
  return frames;
}

FrameHistory::SolvableAgain FrameHistory::solvable_again(double from_s, double to_s) const {
  const SolvableAgain found = remembered_again(from_s, to_s);
  const auto [memory, store] = view();
  if (!store || (!found.is_short && memory.frames > 0 && from_s >= memory.first_s)) return found;
  SolvableAgain reached;
  reached.frames = range(from_s, to_s);
  if (reached.frames.empty()) return found;
  const std::uint64_t asked = reached.frames.front()->index;
  if (reached.frames.front()->before) return reached;
  if (const auto state = store->state_before(asked)) {
    std::vector<FrameSnapshotPtr> run_up = before(asked, *state, *store);
    if (!run_up.empty() && run_up.front()->before) {
      reached.run_up = run_up.size();
      reached.frames.insert(reached.frames.begin(), run_up.begin(), run_up.end());
      return reached;
    }
  }
  const auto first = std::find_if(reached.frames.begin(), reached.frames.end(),
                                  [](const FrameSnapshotPtr& frame) { return frame->before != nullptr; });
  reached.frames.erase(reached.frames.begin(), first);
  reached.is_short = true;
  return reached;
}

/// All frames of [from, asked), wherever they are.
std::vector<FrameSnapshotPtr> FrameHistory::before(std::uint64_t asked, std::uint64_t from,
                                                   const FrameStore& store) const {
  std::vector<FrameSnapshotPtr> remembered;
  {
    const std::scoped_lock lock(mutex_);
    for (const FrameSnapshotPtr& frame : frames_)
      if (frame->index >= from && frame->index < asked) remembered.push_back(frame);
  }
  const std::uint64_t stored_end = remembered.empty() ? asked : remembered.front()->index;
  std::vector<FrameSnapshotPtr> frames;
  if (stored_end > from) frames = store.between(from, stored_end - 1, all_frames);
  frames.insert(frames.end(), remembered.begin(), remembered.end());
  return frames;
}

FrameHistory::SolvableAgain FrameHistory::remembered_again(double from_s, double to_s) const {
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
  std::vector<FrameSnapshotPtr> remembered;
  std::uint64_t first_index = std::numeric_limits<std::uint64_t>::max();
  std::shared_ptr<const FrameStore> store;
  {
    const std::scoped_lock lock(mutex_);
    const auto first =
        std::lower_bound(frames_.begin(), frames_.end(), index,
                         [](const FrameSnapshotPtr& frame, std::uint64_t i) { return frame->index < i; });
    remembered.assign(first, frames_.end());
    store = store_;
    if (!frames_.empty()) first_index = frames_.front()->index;
  }
  if (!store || index >= first_index) return remembered;
  const FrameStore::Span span = store->span();
  if (span.frames == 0 || index > span.last_index) return remembered;
  std::vector<FrameSnapshotPtr> frames =
      store->between(index, std::min(span.last_index, first_index - 1), overview_frames);
  frames.insert(frames.end(), remembered.begin(), remembered.end());
  return frames;
}

}  // namespace abrazo
