#include "core/motion/body/joint_rotations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/positions.hpp"
#include "core/base/rotation.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

using Rotation = Eigen::Matrix3d;
using namespace joints;

/// Angle about `direction` that leads from one rotation to the other, -pi to pi; both turn the same axis to
/// `direction`.
double twist_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, const Vec3& direction) {
  const Eigen::Quaterniond difference = to * from.inverse();
  return std::remainder(2 * std::atan2(difference.vec().dot(direction), difference.w()),
                        2 * std::numbers::pi);
}

}  // namespace

Vec3 rest_direction(int joint) {
  switch (joint) {
    case LeftFemur:
    case LeftTibia:
    case RightFemur:
    case RightTibia:
      return -Vec3::UnitY();
    case LeftFoot:
    case RightFoot:
      return Vec3(0, -0.5, 1).normalized();
    case LeftToes:
    case RightToes:
      return Vec3::UnitZ();
    case LeftClavicle:
    case LeftHumerus:
    case LeftWrist:
    case LeftHand:
      return Vec3::UnitX();
    case RightClavicle:
    case RightHumerus:
    case RightWrist:
    case RightHand:
      return -Vec3::UnitX();
    default:
      return Vec3::UnitY();
  }
}

Rotation frame_of(const Vec3& side, const Vec3& up) {
  Vec3 x = side.norm() > 1e-9 ? Vec3(side.normalized()) : Vec3(Vec3::UnitX());
  Vec3 z = x.cross(up);
  if (z.norm() < 1e-9) z = x.unitOrthogonal();
  z.normalize();
  Rotation frame;
  frame << x, z.cross(x), z;
  return frame;
}

Rotation swing(const Vec3& from, const Vec3& to) {
  if (to.norm() < 1e-9) return Rotation::Identity();
  return smallest_rotation(from, to).toRotationMatrix();
}

Rotation pelvis_rotation(const Pose& pose, bool flat) {
  const Vec3 middle = 0.5 * (joint_at(pose, left_hip) + joint_at(pose, right_hip));
  return frame_of(joint_at(pose, left_hip) - joint_at(pose, right_hip),
                  joint_at(pose, flat ? LowerBack : Root) - middle);
}

Rotation chest_rotation(const Pose& pose) {
  return frame_of(joint_at(pose, LeftClavicle) - joint_at(pose, RightClavicle),
                  joint_at(pose, Thorax) - joint_at(pose, UpperBack));
}

Eigen::Quaterniond TwistFollower::follow(const Vec3& axis, const Vec3& direction,
                                         const Eigen::Quaterniond& start, std::initializer_list<Lead> leads,
                                         double dt_s) {
  Eigen::Quaterniond rotation = start;
  if (last_) {
    rotation = smallest_rotation(*last_ * axis, direction) * *last_;
    double turned = 0;
    for (const Lead& lead : leads) {
      const double most = lead.motion_rad + lead.rate_rad_s * dt_s;
      turned += std::clamp(lead.weight * twist_between(rotation, lead.rotation, direction), -most, most);
    }
    rotation = Eigen::Quaterniond(Eigen::AngleAxisd(turned, direction)) * rotation;
  }
  last_ = rotation.normalized();
  return *last_;
}

}  // namespace abrazo
