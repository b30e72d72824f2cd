#include "core/library/store/normalization.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double hip_share = 0.6;
constexpr double shoulder_share = 0.4;
constexpr double shortest_axis_m = 0.05;  ///< seen from above; a shorter one is mostly noise

/// From the right joint to the left one, seen from above: (x, z) [m].
Eigen::Vector2d left_axis(const Pose& pose, int left, int right) {
  return {pose(left, 0) - pose(right, 0), pose(left, 2) - pose(right, 2)};
}

/// Heading of a body whose left is at `axis`; someone facing +Z has the left at +X.
double heading_of(const Eigen::Vector2d& axis) {
  return std::atan2(-axis.y(), axis.x());
}

}  // namespace

Eigen::Matrix3d RootFrame::rotation() const {
  return Eigen::AngleAxisd(heading_rad, Vec3::UnitY()).toRotationMatrix();
}

RootFrame root_frame(const Pose& pose, std::optional<double> previous_heading_rad) {
  const Eigen::Vector2d hips = left_axis(pose, joints::left_hip, joints::right_hip);
  const Eigen::Vector2d shoulders = left_axis(pose, joints::left_shoulder, joints::right_shoulder);
  RootFrame frame;
  frame.position = pose.row(joints::Root).transpose();
  if (hips.norm() < shortest_axis_m) {
    frame.heading_rad = previous_heading_rad.value_or(heading_of(shoulders));
  } else if (shoulders.norm() < shortest_axis_m) {
    frame.heading_rad = heading_of(hips);
  } else {
    // Unequal shares: even opposite axes leave a direction.
    frame.heading_rad = heading_of(hip_share * hips.normalized() + shoulder_share * shoulders.normalized());
  }
  return frame;
}

Pose to_normalized(const Pose& world, const RootFrame& active_root) {
  // Points are rows, so R^T applied to each is a product with R from the right.
  return (world.rowwise() - active_root.position.transpose()) * active_root.rotation();
}

Pose to_world(const Pose& normalized, const RootFrame& active_root) {
  return (normalized * active_root.rotation().transpose()).rowwise() + active_root.position.transpose();
}

Features pose_features(const Pose& normalized_active) {
  Features features;
  for (std::size_t f = 0; f < feature_joints.size(); ++f)
    features.segment<3>(static_cast<Eigen::Index>(3 * f)) =
        normalized_active.row(feature_joints[f]).transpose();
  return features;
}

}  // namespace abrazo
