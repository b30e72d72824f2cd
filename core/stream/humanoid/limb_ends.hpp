#pragma once

#include <Eigen/Geometry>

#include "core/base/positions.hpp"

namespace abrazo {

/// Place and turn of a bone whose rest pose is a T-pose with every rotation the identity, Y up [m].
struct SegmentPose {
  Vec3 position = Vec3::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

// Capture systems send where bones begin. How far the last one of a limb goes on, as a fraction of the one
// before it; an average adult's.
inline constexpr double hand_beyond_forearm_length = 0.56;  ///< finger tips, beyond the wrist
inline constexpr double toes_beyond_foot_length = 0.35;     ///< tip of the toes, beyond the toe base
inline constexpr double crown_beyond_neck_length = 2.0;     ///< crown, beyond the base of the skull

/// Where a limb ends: in the rest pose its last bone goes on in the direction of the one before.
/// @param level  it lies flat instead, as toes do, whatever the slope of the foot
inline Vec3 limb_end(const SegmentPose& before, const SegmentPose& last, double fraction,
                     bool level = false) {
  Vec3 direction = before.rotation.conjugate() * (last.position - before.position);
  const double length = direction.norm();
  if (level && std::hypot(direction.x(), direction.z()) > 1e-6) {
    direction.y() = 0;
    direction *= length / direction.norm();
  }
  return last.position + last.rotation * Vec3(fraction * direction);
}

}  // namespace abrazo
