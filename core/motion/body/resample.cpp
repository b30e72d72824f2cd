#include "core/motion/body/resample.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/statistics.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double same_time_s = 1e-6;
constexpr double whole_rate = 1e-5;  ///< relative difference that is rounding
constexpr double intervals_of_a_gap = 3;
constexpr double same_direction_rad = 1e-6;
constexpr double opposite_direction_rad = 3.1;  ///< no way round is the shorter one
constexpr double no_length_m = 1e-12;

/// Places of the times that are later than all before them.
std::vector<std::size_t> ascending(std::span<const double> times_s) {
  std::vector<std::size_t> kept;
  kept.reserve(times_s.size());
  for (std::size_t i = 0; i < times_s.size(); ++i)
    if (kept.empty() || times_s[i] > times_s[kept.back()]) kept.push_back(i);
  return kept;
}

/// Number of frames between two times and at neither.
std::size_t frames_between(const EvenTiming& timing, double from_s, double to_s) {
  const double tolerance = same_time_s * timing.rate_hz;
  const double first = std::floor((from_s - timing.first_s) * timing.rate_hz + tolerance) + 1;
  const double end = std::min(std::ceil((to_s - timing.first_s) * timing.rate_hz - tolerance),
                              static_cast<double>(timing.frames));
  return static_cast<std::size_t>(std::max(0.0, end - first));
}

void find_gaps(const std::vector<double>& times_s, EvenTiming& timing) {
  const double usual_hz = median_rate_hz(times_s);
  for (std::size_t i = 1; usual_hz > 0 && i < times_s.size(); ++i) {
    const double interval_s = times_s[i] - times_s[i - 1];
    if (!(interval_s * usual_hz > intervals_of_a_gap)) continue;
    ++timing.gaps;
    timing.bridged += frames_between(timing, times_s[i - 1], times_s[i]);
    if (interval_s <= timing.longest_gap_s) continue;
    timing.longest_gap_s = interval_s;
    timing.longest_gap_at_s = times_s[i - 1];
  }
}

bool are_even(const std::vector<double>& times_s, double rate_hz) {
  for (std::size_t i = 0; i < times_s.size(); ++i)
    if (std::abs(times_s[i] - times_s.front() - static_cast<double>(i) / rate_hz) > same_time_s) return false;
  return true;
}

/// A bone between two directions and lengths.
Vec3 blended_bone(const Vec3& from, const Vec3& to, double share) {
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  Vec3 bone = (1 - share) * from + share * to;
  if (angle > same_direction_rad && angle < opposite_direction_rad)
    bone = std::sin((1 - share) * angle) * from.normalized() + std::sin(share * angle) * to.normalized();
  const double length = bone.norm();
  if (length > no_length_m) bone *= ((1 - share) * from.norm() + share * to.norm()) / length;
  return bone;
}

}  // namespace

EvenTiming even_timing(std::span<const double> times_s, double rate_hz) {
  if (times_s.empty() || !(rate_hz > 0)) throw std::invalid_argument("an even timing needs times and a rate");
  std::vector<double> kept;
  for (const std::size_t place : ascending(times_s)) kept.push_back(times_s[place]);
  EvenTiming timing;
  timing.rate_hz = rate_hz;
  timing.first_s = kept.front();
  timing.discarded = times_s.size() - kept.size();
  timing.unchanged = are_even(kept, rate_hz);
  timing.frames =
      timing.unchanged
          ? kept.size()
          : static_cast<std::size_t>(std::floor((kept.back() - timing.first_s) * rate_hz + same_time_s)) + 1;
  find_gaps(kept, timing);
  return timing;
}

EvenPoses resample(std::span<const StampedPose> stamped, double rate_hz) {
  const std::vector<double> times_s = times_of(stamped);
  EvenPoses even;
  even.timing = even_timing(times_s, rate_hz);
  even.poses.reserve(even.timing.frames);
  const std::vector<std::size_t> kept = ascending(times_s);
  if (even.timing.unchanged) {
    for (const std::size_t place : kept) even.poses.push_back(stamped[place].pose);
    return even;
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < even.timing.frames; ++i) {
    const double time_s = even.timing.first_s + static_cast<double>(i) / rate_hz;
    while (next + 1 < kept.size() && times_s[kept[next]] < time_s) ++next;
    const StampedPose& after = stamped[kept[next]];
    if (next == 0 || time_s >= after.time_s) {
      even.poses.push_back(after.pose);
      continue;
    }
    const StampedPose& before = stamped[kept[next - 1]];
    even.poses.push_back(
        blended(before.pose, after.pose, (time_s - before.time_s) / (after.time_s - before.time_s)));
  }
  return even;
}

std::vector<double> times_of(std::span<const StampedPose> stamped) {
  std::vector<double> times_s;
  times_s.reserve(stamped.size());
  for (const StampedPose& pose : stamped) times_s.push_back(pose.time_s);
  return times_s;
}

double median_rate_hz(std::span<const double> times_s) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times_s.size(); ++i)
    if (times_s[i] > times_s[i - 1]) intervals.push_back(times_s[i] - times_s[i - 1]);
  return intervals.empty() ? 0 : 1 / percentile(std::move(intervals), 0.5);
}

double even_rate(double rate_hz) {
  const double whole = std::round(rate_hz);
  return std::abs(rate_hz - whole) < whole_rate * rate_hz ? whole : rate_hz;
}

Pose blended(const Pose& from, const Pose& to, double share) {
  Pose pose;
  pose.row(0) = (1 - share) * from.row(0) + share * to.row(0);
  for (int joint = 1; joint < joint_count; ++joint) {
    const int parent = joint_parents[static_cast<std::size_t>(joint)];
    const Vec3 bone = blended_bone((from.row(joint) - from.row(parent)).transpose(),
                                   (to.row(joint) - to.row(parent)).transpose(), share);
    pose.row(joint) = pose.row(parent) + bone.transpose();
  }
  return pose;
}

}  // namespace abrazo
