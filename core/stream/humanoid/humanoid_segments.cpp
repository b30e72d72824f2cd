#include "core/stream/humanoid/humanoid_segments.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/body/joint_rotations.hpp"

namespace abrazo {

namespace {

/// The third side of a right-angled triangle, 0 where lengths contradict each other.
double other_side(double longest, double side) {
  return std::sqrt(std::max(0.0, longest * longest - side * side));
}

}  // namespace

PerBone<SegmentPose> world_segments(const HumanoidPose& pose) {
  PerBone<SegmentPose> segments;
  for (int bone = 0; bone < humanoid::bone_count; ++bone) {
    const auto b = static_cast<std::size_t>(bone);
    const int above = pose.parent(bone);
    const SegmentPose parent = above >= 0 ? segments[static_cast<std::size_t>(above)]
                                          : SegmentPose{pose.root_position, pose.root_rotation};
    if (!pose.present[b]) {
      segments[b] = parent;
      continue;
    }
    segments[b].position = parent.position + parent.rotation * pose.position[b];
    segments[b].rotation = (parent.rotation * pose.rotation[b]).normalized();
  }
  return segments;
}

Pose t_pose(const Body& body) {
  using namespace joints;
  Pose pose = Pose::Zero();
  for (int joint = 1; joint < joint_count; ++joint) {
    const double length = body.bone_lengths[static_cast<std::size_t>(joint - 1)];
    Vec3 offset = length * rest_direction(joint);
    const bool is_hip = joint == left_hip || joint == right_hip;
    if (is_hip || joint == left_shoulder || joint == right_shoulder) {
      const double half = std::min(length, 0.5 * body.pseudo_lengths[is_hip ? 0 : 1]);
      const double side = joint == left_hip || joint == left_shoulder ? 1 : -1;
      offset = Vec3(side * half, (is_hip ? -1 : 1) * other_side(length, half), 0);
    }
    pose.row(joint) = pose.row(joint_parents[static_cast<std::size_t>(joint)]) + offset.transpose();
  }
  const double rise = body.toe_rest_height - pose(left_toe_base, 1);
  pose.col(1).array() += rise;
  return pose;
}

}  // namespace abrazo
