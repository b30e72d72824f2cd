#include "core/stream/receive/stream_meter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/statistics.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

namespace {

constexpr double times_window_s = 1;
constexpr double intervals_until_silent = 2.5, longest_interval_s = 5;
constexpr std::size_t fewest_arrivals = 8, most_arrivals = 2048;
constexpr double posture_window_s = 3, posture_interval_s = 0.05, posture_known_after_s = 0.5;
constexpr double share_smoothing = 0.05;
constexpr double frozen_below_m = 1e-5;  ///< no person is that still, but rounding may move a joint by less

double mean_distance(const Pose& a, const Pose& b) {
  return (a - b).rowwise().norm().mean();
}

}  // namespace

std::int64_t RecentCount::bucket_of(double now_s) const {
  return static_cast<std::int64_t>(std::floor(now_s * buckets / window_s));
}

void RecentCount::add(double now_s, std::uint64_t count) {
  if (count == 0) return;
  const std::int64_t number = bucket_of(now_s);
  Bucket& bucket = counts_[static_cast<std::size_t>(((number % buckets) + buckets) % buckets)];
  if (bucket.number != number) bucket = {number, 0};
  bucket.count += count;
}

std::uint64_t RecentCount::value(double now_s) const {
  const std::int64_t newest = bucket_of(now_s);
  std::uint64_t sum = 0;
  for (const Bucket& bucket : counts_)
    if (bucket.number > newest - buckets && bucket.number <= newest) sum += bucket.count;
  return sum;
}

void ArrivalMeter::add(double first_arrived_s, double arrived_s) {
  arrivals_.push_back({arrived_s, std::max(0.0, arrived_s - first_arrived_s)});
  while (arrivals_.size() > most_arrivals ||
         (arrivals_.size() > fewest_arrivals && arrivals_.front().arrived_s < arrived_s - times_window_s))
    arrivals_.pop_front();
}

ArrivalMeter::Times ArrivalMeter::times(double now_s) const {
  Times times;
  std::vector<double> intervals, assemblies;
  for (std::size_t i = 0; i < arrivals_.size(); ++i) {
    assemblies.push_back(1000 * arrivals_[i].assembly_s);
    if (i > 0) intervals.push_back(1000 * std::max(0.0, arrivals_[i].arrived_s - arrivals_[i - 1].arrived_s));
  }
  times.assembly_p50_ms = percentile(assemblies, 0.5);
  times.assembly_p95_ms = percentile(assemblies, 0.95);
  times.interval_p50_ms = percentile(intervals, 0.5);
  times.interval_p95_ms = percentile(intervals, 0.95);
  times.rate_hz = rate_hz(now_s);
  return times;
}

double ArrivalMeter::rate_hz(double now_s) const {
  if (arrivals_.size() < 2) return 0;
  const double span = arrivals_.back().arrived_s - arrivals_.front().arrived_s;
  if (!(span > 0)) return 0;
  const double rate = static_cast<double>(arrivals_.size() - 1) / span;
  // A frame a second is a slow stream and not a silent one.
  const double silent_after_s = std::clamp(intervals_until_silent / rate, times_window_s, longest_interval_s);
  return now_s - arrivals_.back().arrived_s > silent_after_s ? 0 : rate;
}

bool PostureMeter::is_jump(const Pose& from, const Pose& to, double elapsed_s) {
  return elapsed_s < 0.1 && mean_distance(from, to) > impossible_step_m;
}

void PostureMeter::add(const Pose& pose, double arrived_s) {
  using namespace joints;
  if (!last_) first_arrived_s_ = arrived_s;
  if (!last_ || (pose - still_).cwiseAbs().maxCoeff() > frozen_below_m) {
    changed_s_ = arrived_s;
    still_ = pose;
  }
  if (last_) {
    const bool jump = is_jump(*last_, pose, arrived_s - last_arrived_s_);
    const bool back = jump && before_last_ && mean_distance(*before_last_, pose) < impossible_step_m / 2;
    jumps_ += share_smoothing * ((jump ? 1 : 0) - jumps_);
    alternating_ += share_smoothing * ((back ? 1 : 0) - alternating_);
  }
  before_last_ = last_;
  last_ = pose;
  last_arrived_s_ = arrived_s;
  if (!samples_.empty() && arrived_s - samples_.back().arrived_s < posture_interval_s) return;
  const Vec3 feet = 0.5 * (pose.row(left_ankle) + pose.row(right_ankle)).transpose();
  samples_.push_back({arrived_s, body_of(pose).height(), pose(Root, 1) - feet.y(), pose(Root, 2) - feet.z(),
                      pose(Head, 1) - pose(Root, 1),
                      std::min(pose(left_toe_base, 1), pose(right_toe_base, 1))});
  while (samples_.front().arrived_s < arrived_s - posture_window_s) samples_.pop_front();
}

PostureMeter::Posture PostureMeter::posture() const {
  Posture posture;
  if (samples_.empty() || last_arrived_s_ - first_arrived_s_ < posture_known_after_s) return posture;
  const auto median = [&](double Sample::*field) {
    std::vector<double> values;
    for (const Sample& sample : samples_) values.push_back(sample.*field);
    return percentile(std::move(values), 0.5);
  };
  posture.is_known = true;
  posture.bones_height_m = median(&Sample::height);
  posture.hips_above_feet_m = median(&Sample::hips_y);
  posture.hips_before_feet_m = median(&Sample::hips_z);
  posture.head_above_hips_m = median(&Sample::head_y);
  posture.lowest_foot_m = median(&Sample::foot_y);
  posture.alternating = alternating_;
  posture.jumps = jumps_;
  return posture;
}

}  // namespace abrazo
