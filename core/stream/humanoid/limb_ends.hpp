#pragma once

#include <Eigen/Geometry>

#include <cmath>

#include "core/base/positions.hpp"

namespace abrazo {

/// Position and rotation of a bone; in the rest pose, a T-pose, every rotation is the identity. Y up [m].
struct SegmentPose {
  Vec3 position = Vec3::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

// Capture systems send the starts of bones. Length of the last bone of a limb as a fraction of the previous
// one, for an average adult.
inline constexpr double hand_beyond_forearm_length = 0.56;  ///< finger tips, beyond the wrist
inline constexpr double toes_beyond_foot_length = 0.35;     ///< tip of the toes, beyond the toe base
inline constexpr double crown_beyond_neck_length = 2.0;     ///< crown, beyond the base of the skull

/// End of a limb: in the rest pose the last bone continues the direction of the previous one.
/// @param level the last bone is horizontal instead, as toes are, whatever the slope of the foot
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
