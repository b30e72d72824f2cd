#include "core/stream/receive/frame_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abrazo {

namespace {

constexpr std::size_t remembered_frames = 512;
constexpr std::size_t remembered_gaps = 1024;
constexpr std::size_t steps_for_stride = 64;
constexpr double horizon_frames = 128;  ///< no network brings frames later than that, or than
constexpr double horizon_s = 0.5;
/// A gap that the pause before it cannot explain at this rate is no loss but another count.
constexpr double highest_rate_hz = 1000;

}  // namespace

FrameOrder::Placed FrameOrder::place(const Frame& frame) {
  ++arrivals_;
  const Key key = frame.counter ? Key::Counter : frame.sender_time_s ? Key::Time : Key::None;
  const double value = key == Key::Counter ? static_cast<double>(*frame.counter)
                       : key == Key::Time  ? *frame.sender_time_s
                                           : static_cast<double>(arrivals_);
  // One without the time that the others have ended before its time came: it has its place by arrival.
  if (started_ && key == Key::None && key_ != Key::None) return {Kind::Next, {epoch_, newest_, arrivals_}};
  if (!started_ || key != key_) {
    const bool began_anew = started_ && key_ != Key::None;
    key_ = key;
    return begin(value, frame, began_anew ? Kind::Restarted : Kind::Next);
  }
  if (key == Key::None) return next(value, frame);
  if (value > newest_)
    return is_believable_step(value, frame) ? next(value, frame) : begin(value, frame, Kind::Restarted);
  switch (recall(value, frame)) {
    case Recollection::Same:
      return {Kind::Repeated, {epoch_, value, arrivals_}};
    case Recollection::Other:
      // A time that is constant, or coarser than the frames, does not define their order.
      return key == Key::Time && value == newest_ ? next(value, frame) : stray(value, frame);
    case Recollection::Unknown:
      break;
  }
  if (is_from_another_time(value, frame)) return stray(value, frame);
  if (missing_.erase(value) > 0 && lost_ > 0) --lost_;
  remember(value, frame);
  return {Kind::Earlier, {epoch_, value, arrivals_}};
}

FrameOrder::Recollection FrameOrder::recall(double value, const Frame& frame) const {
  const auto [begin, end] = seen_.equal_range(value);
  Recollection recollection = Recollection::Unknown;
  for (auto seen = begin; seen != end; ++seen) {
    const bool is_recent = frame.arrived_s - seen->second.arrived_s <= memory_s;
    if (seen->second.content == frame.content && is_recent) return Recollection::Same;
    recollection = Recollection::Other;
  }
  return recollection;
}

bool FrameOrder::is_from_another_time(double value, const Frame& frame) const {
  if (frame.sender_time_s && newest_time_s_ && *newest_time_s_ - *frame.sender_time_s > horizon_s)
    return true;
  return key_ == Key::Counter && newest_ - value > horizon_frames * static_cast<double>(stride_);
}

bool FrameOrder::is_believable_step(double value, const Frame& frame) const {
  if (key_ != Key::Counter) return true;  // the clock's jumps are SenderClock's
  const double pause_s = std::max(0.0, frame.arrived_s - newest_arrived_s_);
  return value - newest_ <= highest_rate_hz * (1 + pause_s);
}

FrameOrder::Placed FrameOrder::next(double value, const Frame& frame) {
  strays_ = 0;
  if (key_ == Key::Counter) count_gap(static_cast<std::int64_t>(value - newest_), newest_);
  newest_ = value;
  newest_arrived_s_ = frame.arrived_s;
  newest_time_s_ = frame.sender_time_s;
  remember(value, frame);
  return {Kind::Next, {epoch_, value, arrivals_}};
}

FrameOrder::Placed FrameOrder::stray(double value, const Frame& frame) {
  // One alone may be anything; some in a row, each after the one before, are a sender that restarted.
  strays_ = strays_ > 0 && value > last_stray_ ? strays_ + 1 : 1;
  last_stray_ = value;
  if (strays_ >= strays_of_a_restart) return begin(value, frame, Kind::Restarted);
  return {Kind::Stray, {epoch_, value, arrivals_}};
}

FrameOrder::Placed FrameOrder::begin(double value, const Frame& frame, Kind kind) {
  if (started_) ++epoch_;
  started_ = true;
  strays_ = 0;
  stride_ = 1;
  seen_.clear();
  missing_.clear();
  steps_.clear();
  newest_ = value;
  newest_arrived_s_ = frame.arrived_s;
  newest_time_s_ = frame.sender_time_s;
  remember(value, frame);
  return {kind, {epoch_, value, arrivals_}};
}

void FrameOrder::remember(double value, const Frame& frame) {
  if (key_ == Key::None) return;
  seen_.emplace(value, Seen{frame.content, frame.arrived_s});
  if (seen_.size() > remembered_frames) seen_.erase(seen_.begin());
}

std::int64_t FrameOrder::usual_step() const {
  return std::accumulate(steps_.begin(), steps_.end(), std::int64_t{0},
                         [](std::int64_t a, std::int64_t b) { return std::gcd(a, b); });
}

void FrameOrder::count_gap(std::int64_t step, double newest) {
  steps_.push_back(step);
  if (steps_.size() > steps_for_stride) steps_.pop_front();
  if (step % stride_ != 0) stride_ = 1;
  lost_ += static_cast<std::uint64_t>(step / stride_ - 1);
  for (std::int64_t ahead = stride_; ahead < step && missing_.size() < remembered_gaps; ahead += stride_)
    missing_.insert(newest + static_cast<double>(ahead));
  while (!missing_.empty() && *missing_.begin() < newest - horizon_frames * static_cast<double>(stride_))
    missing_.erase(missing_.begin());
  if (steps_.size() < steps_for_stride || stride_ != 1) return;
  // A sender that gives every second frame of its cameras counts in twos: nothing was lost in between.
  const std::int64_t usual = usual_step();
  if (usual <= 1) return;
  for (const std::int64_t one : steps_) {
    const auto taken_for_lost = static_cast<std::uint64_t>(one - one / usual);
    lost_ -= std::min(lost_, taken_for_lost);
  }
  stride_ = usual;
  missing_.clear();
}

}  // namespace abrazo
