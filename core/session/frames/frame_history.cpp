#include "core/session/frames/frame_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/synthesis/step/synthesizer_state.hpp"

namespace abrazo {

namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.capacity() * sizeof(T);
}

/// A store's frames by index, restricted to a time range.
class FramesWithin : public FrameStore {
 public:
  FramesWithin(std::shared_ptr<const FrameStore> store, double from_s, double to_s)
      : store_(std::move(store)), from_s_(from_s), to_s_(to_s) {}

  Span span() const override { return store_->span(); }
  FrameSnapshotPtr at(double time_s) const override { return store_->at(time_s); }
  FrameSnapshotPtr frame(std::uint64_t index) const override { return store_->frame(index); }
  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const override {
    return store_->range(std::max(from_s, from_s_), std::min(to_s, to_s_), most);
  }
  std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last,
                                        std::size_t most) const override {
    auto frames = store_->between(first, last, most);
    std::erase_if(frames, [&](const FrameSnapshotPtr& frame) {
      return frame->time_s < from_s_ || frame->time_s > to_s_;
    });
    return frames;
  }
  std::optional<std::uint64_t> state_before(std::uint64_t index) const override {
    return store_->state_before(index);
  }

 private:
  std::shared_ptr<const FrameStore> store_;
  double from_s_, to_s_;
};

/// First index of a store's frames in [from_s, to_s], and the one after the last. Where the frame at a bound
/// cannot be read, more than those.
std::pair<std::uint64_t, std::uint64_t> stored_between(const FrameStore& store, double from_s, double to_s) {
  const FrameStore::Span span = store.span();
  if (span.frames == 0 || from_s > span.last_s || to_s < span.first_s) return {0, 0};
  std::uint64_t first = span.first_index, end = span.last_index + 1;
  if (from_s > span.first_s)
    if (const auto near = store.at(from_s)) first = near->time_s < from_s ? near->index + 1 : near->index;
  if (to_s < span.last_s)
    if (const auto last = store.at(to_s)) end = last->index + 1;
  return {first, std::max(first, end)};
}

/// Of so many frames of a store that an overview is read.
std::uint64_t stride_of(std::uint64_t whole) {
  return std::max<std::uint64_t>(1,
                                 (whole + FrameHistory::overview_frames - 1) / FrameHistory::overview_frames);
}

}  // namespace

std::size_t size_of(const FrameSnapshot& frame) {
  const FrameResult& r = frame.result;
  return sizeof(FrameSnapshot) + bytes_of(r.candidates) + bytes_of(r.intent.belief) +
         bytes_of(r.intent.moves) + bytes_of(r.edges) + bytes_of(r.tetrahedra) + bytes_of(r.edge_weights) +
         bytes_of(r.edge_residuals_m) + bytes_of(r.morph_steps) + bytes_of(r.foot_locks) +
         bytes_of(r.collisions) + r.message.capacity() + (frame.before ? sizeof(SynthesizerState) : 0);
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

void FrameHistory::put(FrameSnapshotPtr frame) {
  {
    const std::scoped_lock lock(mutex_);
    if (!frames_.empty() && frame->index <= frames_.back()->index) {
      if (frame->index < frames_.front()->index) return;  // evicted meanwhile
      FrameSnapshotPtr& before = frames_[frame->index - frames_.front()->index];
      bytes_ += size_of(*frame);
      bytes_ -= size_of(*before);
      before.swap(frame);  // destroyed by the caller's thread, outside the lock
      return;
    }
  }
  append(std::move(frame));
}

void FrameHistory::keep_at_most(std::size_t max_bytes) {
  const std::scoped_lock lock(mutex_);
  max_bytes_ = max_bytes;
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

/// The frames in memory and the store at one moment. The store is queried without the lock: the solver never
/// waits for the disk.
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

FrameHistory::Parts FrameHistory::parts(double from_s, double to_s) const {
  Parts parts;
  parts.first_index = std::numeric_limits<std::uint64_t>::max();
  double first_s = std::numeric_limits<double>::infinity();
  {
    const std::scoped_lock lock(mutex_);
    const auto first = frames_.begin() + first_not_before(from_s);
    const auto last =
        std::upper_bound(first, frames_.end(), to_s,
                         [](double t, const FrameSnapshotPtr& frame) { return t < frame->time_s; });
    parts.remembered.assign(first, last);
    parts.store = store_;
    if (!frames_.empty()) {
      parts.first_index = frames_.front()->index;
      first_s = frames_.front()->time_s;
    }
  }
  if (from_s >= first_s) parts.store = nullptr;
  parts.stored_to_s = std::min(to_s, std::nextafter(first_s, -std::numeric_limits<double>::infinity()));
  return parts;
}

std::vector<FrameSnapshotPtr> FrameHistory::range(double from_s, double to_s, std::size_t most) const {
  Parts found = parts(from_s, to_s);
  if (!found.store) return std::move(found.remembered);
  std::vector<FrameSnapshotPtr> frames = found.store->range(from_s, found.stored_to_s, most);
  std::erase_if(frames, [&](const FrameSnapshotPtr& frame) { return frame->index >= found.first_index; });
  frames.insert(frames.end(), found.remembered.begin(), found.remembered.end());
  return frames;
}

std::vector<double> FrameHistory::times(double from_s, double to_s) const {
  const Parts found = parts(from_s, to_s);
  std::vector<double> times_s;
  if (found.store) times_s = found.store->times(from_s, found.stored_to_s);
  for (const FrameSnapshotPtr& frame : found.remembered) times_s.push_back(frame->time_s);
  return times_s;
}

FrameRange FrameHistory::stretch(double from_s, double to_s) const {
  Parts found = parts(from_s, to_s);
  if (!found.store) return {nullptr, 0, 0, std::move(found.remembered)};
  const auto [first, end] = stored_between(*found.store, from_s, found.stored_to_s);
  return {std::make_shared<const FramesWithin>(found.store, from_s, found.stored_to_s), first,
          std::min(end, std::max(first, found.first_index)), std::move(found.remembered)};
}

FrameHistory::SolvableAgain FrameHistory::solvable_again(double from_s, double to_s) const {
  SolvableAgain again;
  again.frames = stretch(from_s, to_s);
  const FrameSnapshotPtr first = again.frames.next();
  again.frames.rewind();
  if (!first || first->before) return again;
  again.run_up = run_up(*first);
  if (!again.run_up.empty()) return again;
  again.is_short = true;
  // States are some dozens of frames apart: the next one is near, or missing.
  FrameSnapshotPtr later = again.frames.next();
  while (later && !later->before) later = again.frames.next();
  again.frames = later ? stretch(later->time_s, to_s) : FrameRange();
  return again;
}

/// All frames before one, back to the last with a state; empty if there is none, or a frame between is lost.
std::vector<FrameSnapshotPtr> FrameHistory::run_up(const FrameSnapshot& to) const {
  std::vector<FrameSnapshotPtr> frames;
  std::shared_ptr<const FrameStore> store;
  {
    const std::scoped_lock lock(mutex_);
    store = store_;
    for (auto i = static_cast<std::ptrdiff_t>(frames_.size()) - 1; i >= 0; --i) {
      const FrameSnapshotPtr& frame = frames_[static_cast<std::size_t>(i)];
      if (frame->index >= to.index) continue;
      frames.push_back(frame);
      if (frame->before) break;
    }
  }
  std::reverse(frames.begin(), frames.end());
  if (!frames.empty() && frames.front()->before) return frames;
  const auto state = store ? store->state_before(to.index) : std::nullopt;
  if (!state) return {};
  const std::uint64_t stored_end = frames.empty() ? to.index : frames.front()->index;
  if (*state >= stored_end) return {};
  std::vector<FrameSnapshotPtr> stored = store->between(*state, stored_end - 1, all_frames);
  if (stored.empty() || !stored.front()->before) return {};
  stored.insert(stored.end(), frames.begin(), frames.end());
  return stored;
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

std::vector<FrameSnapshotPtr> FrameHistory::next_since(std::uint64_t index) const {
  const auto [span, store] = view();
  if (!store) return since(index);
  const FrameStore::Span stored = store->span();
  const std::uint64_t first_remembered =
      span.frames > 0 ? span.first_index : std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t end = std::min(stored.last_index + 1, first_remembered);
  index = std::max(index, stored.first_index);
  if (stored.frames == 0 || index >= end) return since(index);
  if (store->is_kept(index, end - 1, overview_frames)) return since(index);
  const std::uint64_t stride = stride_of(end - stored.first_index);  // as when read at once
  while (index < end) {
    const std::uint64_t next = std::min(end, index + stride * read_at_once);
    std::vector<FrameSnapshotPtr> frames = store->between(index, next - 1, read_at_once);
    if (!frames.empty()) return frames;
    index = next;  // none of these can be read
  }
  return since(index);
}

std::uint64_t FrameHistory::frames_each() const {
  const auto [span, store] = view();
  const FrameStore::Span stored = store ? store->span() : FrameStore::Span{};
  if (stored.frames == 0) return 1;
  const std::uint64_t end =
      span.frames > 0 ? std::min(stored.last_index + 1, span.first_index) : stored.last_index + 1;
  const std::uint64_t stride = end > stored.first_index ? stride_of(end - stored.first_index) : 1;
  // Both ends of a piece are read, so that the others are a little farther apart.
  return (stride * read_at_once - 1 + read_at_once - 2) / (read_at_once - 1);
}

}  // namespace abrazo
