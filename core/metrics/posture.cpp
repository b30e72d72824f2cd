#include "core/metrics/posture.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

using namespace joints;

double angle_deg(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

double knees_deg(const Pose& pose) {
  const auto knee = [&](int hip) {
    const Vec3 at = joint_at(pose, hip + 1);
    return angle_deg(joint_at(pose, hip) - at, joint_at(pose, hip + 2) - at);
  };
  return 0.5 * (knee(left_hip) + knee(right_hip));
}

double trunk_deg(const Pose& pose) {
  return angle_deg(joint_at(pose, LowerNeck) - joint_at(pose, Root), Vec3::UnitY());
}

}  // namespace

PostureChange posture_change(const Pose& pose, const Pose& recorded, double size) {
  return {pose(Root, 1) / (size * recorded(Root, 1)), knees_deg(pose) - knees_deg(recorded),
          trunk_deg(pose) - trunk_deg(recorded)};
}

}  // namespace abrazo
