#include "core/metrics/zmp.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/base/statistics.hpp"
#include "core/metrics/support_polygon.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double gravity = 9.81;           ///< [m/s^2]
constexpr double least_force_share = 0.2;  ///< of the weight

using SegmentPoints = Eigen::Matrix<double, segment_count, 3, Eigen::RowMajor>;

std::vector<SegmentPoints> segment_paths(std::span<const Pose> poses,
                                         const std::array<BodySegment, segment_count>& segments) {
  std::vector<SegmentPoints> paths(poses.size());
  for (std::size_t frame = 0; frame < poses.size(); ++frame)
    for (int s = 0; s < segment_count; ++s)
      paths[frame].row(s) = segment_centre(segments[static_cast<std::size_t>(s)], poses[frame]).transpose();
  return paths;
}

/// Smoothed acceleration [m/s^2]; uses the frames `half_width` + 1 before and after.
SegmentPoints acceleration(const std::vector<SegmentPoints>& paths, std::size_t frame, int half_width,
                           double fps) {
  SegmentPoints sum = SegmentPoints::Zero();
  for (int k = -half_width; k <= half_width; ++k) {
    const auto at = static_cast<std::size_t>(static_cast<int>(frame) + k);
    sum += (half_width + 1 - std::abs(k)) * (paths[at - 1] - 2 * paths[at] + paths[at + 1]);
  }
  const double weights = (half_width + 1.0) * (half_width + 1.0);
  return sum * (fps * fps / weights);
}

/// The point in the floor's plane (x, z) about which gravity and inertia have no horizontal moment; nothing
/// when too little force presses on the floor.
std::optional<Vec2> zero_moment_point(const SegmentPoints& points, const SegmentPoints& accelerations,
                                      const std::array<BodySegment, segment_count>& segments,
                                      double floor_m) {
  Vec2 moment = Vec2::Zero();
  double force = 0, weight = 0;
  for (int s = 0; s < segment_count; ++s) {
    const double mass = segments[static_cast<std::size_t>(s)].mass;
    const double height = points(s, 1) - floor_m;
    const double pressing = accelerations(s, 1) + gravity;
    moment.x() += mass * (pressing * points(s, 0) - accelerations(s, 0) * height);
    moment.y() += mass * (pressing * points(s, 2) - accelerations(s, 2) * height);
    force += mass * pressing;
    weight += mass * gravity;
  }
  if (force < least_force_share * weight) return std::nullopt;
  return Vec2(moment / force);
}

/// Floor points of standing feet.
std::vector<Vec2> support_points(const Pose& pose, const ZmpSettings& settings) {
  using namespace joints;
  std::vector<Vec2> points;
  for (const auto& [ankle, toe_base, toe_tip] : {std::array{left_ankle, left_toe_base, left_toe_tip},
                                                 std::array{right_ankle, right_toe_base, right_toe_tip}}) {
    if (std::min(pose(toe_base, 1), pose(toe_tip, 1)) - settings.floor_m >= settings.contact_height_m)
      continue;
    for (const int joint : {ankle, toe_base, toe_tip}) points.emplace_back(pose(joint, 0), pose(joint, 2));
  }
  return points;
}

}  // namespace

double ZmpError::mean_m() const {
  return mean(error_m);
}

void ZmpError::append(const ZmpError& other) {
  error_m.insert(error_m.end(), other.error_m.begin(), other.error_m.end());
  frames.insert(frames.end(), other.frames.begin(), other.frames.end());
  skipped_no_support += other.skipped_no_support;
  skipped_free_fall += other.skipped_free_fall;
  skipped_ends += other.skipped_ends;
}

void ZmpComparison::add(const ZmpError& first, const ZmpError& second) {
  std::size_t other = 0;
  for (std::size_t i = 0; i < first.frames.size(); ++i) {
    while (other < second.frames.size() && second.frames[other] < first.frames[i]) ++other;
    if (other == second.frames.size()) return;
    if (second.frames[other] != first.frames[i]) continue;
    first_m_.push_back(first.error_m[i]);
    second_m_.push_back(second.error_m[other]);
  }
}

void ZmpComparison::append(const ZmpComparison& other) {
  first_m_.insert(first_m_.end(), other.first_m_.begin(), other.first_m_.end());
  second_m_.insert(second_m_.end(), other.second_m_.begin(), other.second_m_.end());
}

CommonZmp ZmpComparison::common() const {
  if (first_m_.empty()) return {.first_m = std::nan(""), .second_m = std::nan(""), .frames = 0};
  return {
      .first_m = mean(first_m_), .second_m = mean(second_m_), .frames = static_cast<int>(first_m_.size())};
}

int smoothing_half_width(const ZmpSettings& settings, double fps) {
  return static_cast<int>(std::lround(settings.smoothing_s * fps));
}

ZmpError measure_zmp(std::span<const Pose> poses, double fps, const ZmpSettings& settings) {
  if (!(fps > 0)) throw std::invalid_argument("measure_zmp: the frame rate must be positive");
  if (settings.smoothing_s < 0 || settings.sole_margin_m < 0)
    throw std::invalid_argument("measure_zmp: smoothing and sole margin cannot be negative");
  const auto segments = body_segments(settings.segments);
  const std::vector<SegmentPoints> paths = segment_paths(poses, segments);
  const int half_width = smoothing_half_width(settings, fps);
  const std::size_t reach = static_cast<std::size_t>(half_width) + 1;
  ZmpError error;
  error.skipped_ends = static_cast<int>(std::min(poses.size(), 2 * reach));
  for (std::size_t frame = reach; frame + reach < poses.size(); ++frame) {
    const std::vector<Vec2> support = support_points(poses[frame], settings);
    if (support.empty()) {
      ++error.skipped_no_support;
      continue;
    }
    const auto point = zero_moment_point(paths[frame], acceleration(paths, frame, half_width, fps), segments,
                                         settings.floor_m);
    if (!point) {
      ++error.skipped_free_fall;
      continue;
    }
    const double outside = distance_outside(convex_hull(support), *point);
    error.error_m.push_back(std::max(0.0, outside - settings.sole_margin_m));
    error.frames.push_back(static_cast<int>(frame));
  }
  return error;
}

}  // namespace abrazo
