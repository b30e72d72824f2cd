#include "core/session/frames/joined_stores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace abrazo {

namespace {

class JoinedStores : public FrameStore {
 public:
  JoinedStores(std::shared_ptr<const FrameStore> earlier, std::shared_ptr<const FrameStore> later)
      : earlier_(std::move(earlier)), later_(std::move(later)) {}

  Span span() const override {
    const Span before = earlier_->span(), after = later_->span();
    if (before.frames == 0) return after;
    if (after.frames == 0) return before;
    Span whole = before;
    whole.last_s = after.last_s;
    whole.last_index = after.last_index;
    // What is in both, because one was made while the other was read, counts once.
    whole.frames = after.frames + std::min(before.frames, after.first_index - before.first_index);
    return whole;
  }

  FrameSnapshotPtr at(double time_s) const override {
    const Span after = later_->span();
    const bool is_later = after.frames > 0 && time_s >= after.first_s;
    const FrameSnapshotPtr found = (is_later ? later_ : earlier_)->at(time_s);
    return found || !is_later ? found : earlier_->at(time_s);
  }

  FrameSnapshotPtr frame(std::uint64_t index) const override {
    return (is_later(index) ? later_ : earlier_)->frame(index);
  }

  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const override {
    const Span after = later_->span();
    if (after.frames == 0 || to_s < after.first_s) return earlier_->range(from_s, to_s, most);
    if (from_s >= after.first_s) return later_->range(from_s, to_s, most);
    const double share = to_s > from_s ? (after.first_s - from_s) / (to_s - from_s) : 0;
    const auto [first, second] = shared_out(most, share);
    auto frames = earlier_->range(from_s, after.first_s, first);
    return followed_by(std::move(frames), later_->range(after.first_s, to_s, second));
  }

  std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last,
                                        std::size_t most) const override {
    const Span after = later_->span();
    if (!is_later(last)) return earlier_->between(first, last, most);
    if (is_later(first)) return later_->between(first, last, most);
    const auto [before_most, after_most] = shared_out(most, share_before(first, after.first_index, last));
    auto frames = earlier_->between(first, after.first_index - 1, before_most);
    return followed_by(std::move(frames), later_->between(after.first_index, last, after_most));
  }

  std::vector<double> times(double from_s, double to_s) const override {
    const Span after = later_->span();
    if (after.frames == 0 || to_s < after.first_s) return earlier_->times(from_s, to_s);
    auto times_s =
        earlier_->times(from_s, std::nextafter(after.first_s, -std::numeric_limits<double>::infinity()));
    const auto more = later_->times(std::max(from_s, after.first_s), to_s);
    times_s.insert(times_s.end(), more.begin(), more.end());
    return times_s;
  }

  bool is_kept(std::uint64_t first, std::uint64_t last, std::size_t most) const override {
    if (!is_later(last)) return earlier_->is_kept(first, last, most);
    if (is_later(first)) return later_->is_kept(first, last, most);
    const std::uint64_t second = later_->span().first_index;
    const auto [before_most, after_most] = shared_out(most, share_before(first, second, last));
    return earlier_->is_kept(first, second - 1, before_most) && later_->is_kept(second, last, after_most);
  }

  std::optional<std::uint64_t> state_before(std::uint64_t index) const override {
    if (is_later(index))
      if (const auto found = later_->state_before(index)) return found;
    return earlier_->state_before(index);
  }

 private:
  bool is_later(std::uint64_t index) const {
    const Span after = later_->span();
    return after.frames > 0 && index >= after.first_index;
  }

  /// Share of the frames from `first` to `last` that come before `second`.
  static double share_before(std::uint64_t first, std::uint64_t second, std::uint64_t last) {
    return static_cast<double>(second - first) / static_cast<double>(last - first + 1);
  }

  /// At least one for each.
  static std::pair<std::size_t, std::size_t> shared_out(std::size_t most, double share) {
    const auto wanted = static_cast<double>(most) * std::clamp(share, 0.0, 1.0);
    const std::size_t first = wanted >= static_cast<double>(most) ? most : static_cast<std::size_t>(wanted);
    return {std::max<std::size_t>(1, first), std::max<std::size_t>(1, most - first)};
  }

  static std::vector<FrameSnapshotPtr> followed_by(std::vector<FrameSnapshotPtr> frames,
                                                   const std::vector<FrameSnapshotPtr>& more) {
    for (const FrameSnapshotPtr& frame : more)
      if (frames.empty() || frame->index > frames.back()->index) frames.push_back(frame);
    return frames;
  }

  std::shared_ptr<const FrameStore> earlier_, later_;
};

}  // namespace

std::shared_ptr<const FrameStore> joined_stores(std::shared_ptr<const FrameStore> earlier,
                                                std::shared_ptr<const FrameStore> later) {
  if (!earlier) return later;
  if (!later) return earlier;
  return std::make_shared<const JoinedStores>(std::move(earlier), std::move(later));
}

}  // namespace abrazo
