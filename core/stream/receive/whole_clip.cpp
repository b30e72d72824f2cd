#include "core/stream/receive/whole_clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace abrazo {

WholeClip::WholeClip(Clip clip, double max_rate_hz)
    : clip_(std::move(clip)), body_(body_of(clip_.poses)), rate_hz_(std::min(clip_.fps, max_rate_hz)) {
  if (clip_.poses.empty() || !(clip_.fps > 0))
    throw std::invalid_argument("WholeClip: a clip needs poses and a frame rate");
}

std::uint64_t WholeClip::frames() const {
  constexpr double rounding = 1e-6;
  return static_cast<std::uint64_t>(std::floor(last_s() * rate_hz_ + rounding)) + 1;
}

double WholeClip::last_s() const {
  return static_cast<double>(clip_.poses.size() - 1) / clip_.fps;
}

std::optional<SourcePose> WholeClip::poll(double) {
  if (is_over()) return std::nullopt;
  SourcePose pose;
  pose.time_s = static_cast<double>(next_++) / rate_hz_;
  const auto last_frame = static_cast<std::int64_t>(clip_.poses.size()) - 1;
  pose.frame = std::clamp<std::int64_t>(std::llround(pose.time_s * clip_.fps), 0, last_frame);
  pose.pose = clip_.poses[static_cast<std::size_t>(pose.frame)];
  return pose;
}

double WholeClip::next_due_s() const {
  return is_over() ? std::numeric_limits<double>::infinity() : 0;
}

void WholeClip::begin_at(double clip_time_s) {
  next_ = static_cast<std::uint64_t>(std::llround(std::max(0.0, clip_time_s) * rate_hz_));
}

void WholeClip::set_max_rate(double max_rate_hz) {
  const double rate_hz = std::min(clip_.fps, max_rate_hz);
  if (rate_hz == rate_hz_) return;
  rate_hz_ = rate_hz;
  begin_at(0);
}

}  // namespace abrazo
