#include "core/stream/receive/stream_calibration.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "core/base/statistics.hpp"

namespace abrazo {

namespace {

constexpr double standing_toe_height_m = 0.04;  ///< toe base of a standing foot, as in the CMU takes
constexpr double shortest_standing_m = 1.0, tallest_standing_m = 2.3;
constexpr double arm_tolerance_deg = 30, elbow_tolerance_deg = 35, leg_tolerance_deg = 30;
constexpr double stillness_m = 0.06;
constexpr double uneven_feet_m = 0.08;

std::string text(const char* format, double value) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

Pose median_of(std::span<const Pose> poses) {
  Pose median;
  std::vector<double> values;
  for (int j = 0; j < joint_count; ++j)
    for (int axis = 0; axis < 3; ++axis) {
      values.clear();
      for (const Pose& pose : poses) values.push_back(pose(j, axis));
      median(j, axis) = percentile(values, 0.5);
    }
  return median;
}

Vec3 joint(const Pose& pose, int index) {
  return pose.row(index).transpose();
}

void check_arm(const Pose& pose, bool left, std::vector<std::string>& doubts) {
  using namespace joints;
  const Vec3 shoulder = joint(pose, left ? left_shoulder : right_shoulder);
  const Vec3 elbow = joint(pose, left ? left_elbow : right_elbow);
  const Vec3 wrist = joint(pose, left ? left_wrist : right_wrist);
  const Vec3 across =
      joint(pose, left ? left_shoulder : right_shoulder) - joint(pose, left ? right_shoulder : left_shoulder);
  const Vec3 arm = wrist - shoulder;
  const std::string side = left ? "the left arm" : "the right arm";
  const double lift =
      std::asin(std::clamp(arm.y() / std::max(arm.norm(), 1e-9), -1.0, 1.0)) * 180 / std::numbers::pi;
  if (std::abs(lift) > arm_tolerance_deg)
    doubts.push_back(side + " points " + text("%.0f degrees ", std::abs(lift)) +
                     (lift < 0 ? "down; lift it to the height of the shoulder"
                               : "up; lower it to the height of the shoulder"));
  else if (const double off = degrees_between(arm, across); off > arm_tolerance_deg)
    doubts.push_back(side + text(" points %.0f degrees away from sideways; hold it out to the side", off));
  if (const double bend = degrees_between(elbow - shoulder, wrist - elbow); bend > elbow_tolerance_deg)
    doubts.push_back(side + text(" is bent by %.0f degrees; stretch it", bend));
}

void check_stance(const Pose& pose, std::vector<std::string>& doubts) {
  using namespace joints;
  for (const bool left : {true, false}) {
    const Vec3 leg = joint(pose, left ? left_ankle : right_ankle) - joint(pose, left ? left_hip : right_hip);
    if (const double off = degrees_between(leg, Vec3(0, -1, 0)); off > leg_tolerance_deg)
      doubts.push_back(
          std::string(left ? "the left leg" : "the right leg") +
          text(" is %.0f degrees from hanging straight down; stand upright, or set the up axis", off));
  }
  if (std::abs(pose(left_toe_base, 1) - pose(right_toe_base, 1)) > uneven_feet_m)
    doubts.emplace_back("one foot is higher than the other; stand on both");
}

}  // namespace

StreamCalibration calibration_of(std::span<const Pose> poses) {
  if (poses.empty()) throw std::invalid_argument("calibration_of: no poses");
  StreamCalibration calibration;
  calibration.body = body_of(poses);
  const Pose pose = median_of(poses);
  const double standing =
      std::min(pose(joints::left_toe_base, 1), pose(joints::right_toe_base, 1)) - standing_toe_height_m;
  calibration.floor_y_m = standing;
  calibration.body.toe_rest_height = standing_toe_height_m;
  check_arm(pose, true, calibration.doubts);
  check_arm(pose, false, calibration.doubts);
  check_stance(pose, calibration.doubts);
  double most_m = 0;
  for (const Pose& one : poses) most_m = std::max(most_m, (one - pose).rowwise().norm().maxCoeff());
  if (most_m > stillness_m)
    calibration.doubts.push_back(text("a joint moved by %.2f m meanwhile; stand still", most_m));
  const double height = calibration.body.height();
  if (height < shortest_standing_m || height > tallest_standing_m)
    calibration.doubts.push_back(text("the body would be %.2f m tall; set the unit of the stream", height));
  return calibration;
}

}  // namespace abrazo
