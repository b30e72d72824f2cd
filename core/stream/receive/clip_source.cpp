#include "core/stream/receive/clip_source.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abrazo {

ClipSource::ClipSource(Clip clip, double max_rate_hz, bool loop)
    : clip_(std::move(clip)),
      body_(body_of(clip_.poses)),
      rate_hz_(std::min(clip_.fps, max_rate_hz)),
      loop_(loop) {
  if (clip_.poses.empty() || !(clip_.fps > 0))
    throw std::invalid_argument("ClipSource: a clip needs poses and a frame rate");
}

double ClipSource::clip_time(double now_s) const {
  return paused_ ? base_clip_s_ : base_clip_s_ + speed_ * (now_s - base_now_s_);
}

std::optional<SourcePose> ClipSource::poll(double now_s) {
  // A little early counts as due: the caller slept until the very instant.
  const auto tick = static_cast<std::int64_t>(std::floor((now_s - base_now_s_) * rate_hz_ + 1e-6));
  if (tick <= last_tick_) return std::nullopt;
  if (last_tick_ >= 0 && !paused_) dropped_ += static_cast<std::uint64_t>(tick - last_tick_ - 1);
  last_tick_ = tick;

  const double tick_s = base_now_s_ + static_cast<double>(tick) / rate_hz_;
  const double duration = clip_.duration_s();
  double at = clip_time(tick_s);
  SourcePose pose;
  pose.discontinuous = jumped_;
  jumped_ = false;
  if (at < 0 || at >= duration) {
    if (!loop_ && at >= duration)
      at = duration;
    else {
      at -= duration * std::floor(at / duration);
      if (!paused_) {
        pose.discontinuous = true;
        base_clip_s_ = at;  // the next lap starts here
        base_now_s_ = tick_s;
        last_tick_ = 0;
      }
    }
  }
  const auto last_frame = static_cast<std::int64_t>(clip_.poses.size()) - 1;
  pose.frame = std::clamp<std::int64_t>(std::llround(at * clip_.fps), 0, last_frame);
  pose.pose = clip_.poses[static_cast<std::size_t>(pose.frame)];
  pose.time_s = tick_s;
  pose.dropped = dropped_;
  return pose;
}

double ClipSource::next_due_s() const {
  return base_now_s_ + static_cast<double>(last_tick_ + 1) / rate_hz_;
}

void ClipSource::set_paused(bool paused, double now_s) {
  if (paused == paused_) return;
  base_clip_s_ = clip_time(now_s);
  base_now_s_ = now_s;
  last_tick_ = -1;
  paused_ = paused;
}

void ClipSource::seek(double clip_time_s, double now_s) {
  base_clip_s_ = std::clamp(clip_time_s, 0.0, clip_.duration_s());
  base_now_s_ = now_s;
  last_tick_ = -1;
  jumped_ = true;
}

void ClipSource::set_speed(double factor, double now_s) {
  base_clip_s_ = clip_time(now_s);
  base_now_s_ = now_s;
  last_tick_ = -1;
  speed_ = factor;
}

void ClipSource::set_max_rate(double max_rate_hz) {
  const double rate = std::min(clip_.fps, max_rate_hz);
  if (rate == rate_hz_) return;
  // The base moves to the last pose given out, so that ticks of the new rate follow it.
  if (last_tick_ >= 0) {
    const double last_s = base_now_s_ + static_cast<double>(last_tick_) / rate_hz_;
    base_clip_s_ = clip_time(last_s);
    base_now_s_ = last_s;
    last_tick_ = 0;
  }
  rate_hz_ = rate;
}

}  // namespace abrazo
