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

std::vector<StampedPose> ascending(std::span<const StampedPose> stamped) {
  std::vector<StampedPose> kept;
  kept.reserve(stamped.size());
  for (const StampedPose& pose : stamped)
    if (kept.empty() || pose.time_s > kept.back().time_s) kept.push_back(pose);
  return kept;
}

void find_gaps(const std::vector<StampedPose>& stamped, EvenPoses& even) {
  const double usual_hz = median_rate_hz(stamped);
  for (std::size_t i = 1; usual_hz > 0 && i < stamped.size(); ++i) {
    const double interval_s = stamped[i].time_s - stamped[i - 1].time_s;
    if (!(interval_s * usual_hz > intervals_of_a_gap)) continue;
    ++even.gaps;
    if (interval_s <= even.longest_gap_s) continue;
    even.longest_gap_s = interval_s;
    even.longest_gap_at_s = stamped[i - 1].time_s;
  }
}

bool are_even(const std::vector<StampedPose>& stamped, double rate_hz) {
  for (std::size_t i = 0; i < stamped.size(); ++i)
    if (std::abs(stamped[i].time_s - stamped.front().time_s - static_cast<double>(i) / rate_hz) > same_time_s)
      return false;
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

EvenPoses resample(std::span<const StampedPose> stamped, double rate_hz) {
  if (stamped.empty() || !(rate_hz > 0)) throw std::invalid_argument("resample needs poses and a rate");
  const std::vector<StampedPose> kept = ascending(stamped);
  EvenPoses even;
  even.first_s = kept.front().time_s;
  even.discarded = stamped.size() - kept.size();
  find_gaps(kept, even);
  even.unchanged = are_even(kept, rate_hz);
  if (even.unchanged) {
    for (const StampedPose& pose : kept) even.poses.push_back(pose.pose);
    return even;
  }
  const auto last =
      static_cast<std::size_t>(std::floor((kept.back().time_s - even.first_s) * rate_hz + same_time_s));
  std::size_t next = 0;
  for (std::size_t i = 0; i <= last; ++i) {
    const double time_s = even.first_s + static_cast<double>(i) / rate_hz;
    while (next + 1 < kept.size() && kept[next].time_s < time_s) ++next;
    const StampedPose& after = kept[next];
    if (next == 0 || time_s >= after.time_s) {
      even.poses.push_back(after.pose);
      continue;
    }
    const StampedPose& before = kept[next - 1];
    even.poses.push_back(
        blended(before.pose, after.pose, (time_s - before.time_s) / (after.time_s - before.time_s)));
  }
  return even;
}

double median_rate_hz(std::span<const StampedPose> stamped) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < stamped.size(); ++i)
    if (stamped[i].time_s > stamped[i - 1].time_s)
      intervals.push_back(stamped[i].time_s - stamped[i - 1].time_s);
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
