#pragma once

#include <Eigen/Geometry>
#include <initializer_list>
#include <optional>

#include "core/base/positions.hpp"

namespace abrazo {

/// Rotations computed from positions, for formats that store rotations (BVH, VMC).

/// Direction of the bone that ends at a joint with all rotations zero: T-pose facing +Z.
Vec3 rest_direction(int joint);

/// Right-handed axes with x along `side` and y as close to `up` as that allows.
Eigen::Matrix3d frame_of(const Vec3& side, const Vec3& up);

/// The smallest rotation that turns `from` (unit) towards `to`; the identity if `to` has length 0.
Eigen::Matrix3d swing(const Vec3& from, const Vec3& to);

/// Rotation of the pelvis from the triangle of root and hips: x from right to left, y from between the hips
/// to the root.
/// @param flat the root is on the line between the hips, so the lower back defines the up direction
Eigen::Matrix3d pelvis_rotation(const Pose& pose, bool flat);

/// Rotation of the chest: x from shoulder to shoulder, y from the upper back to the thorax.
Eigen::Matrix3d chest_rotation(const Pose& pose);

/// Determines the twist of a bone, which its direction leaves open, without jumps: the twist is transported
/// with the bone by the smallest rotation, and led towards the twist implied by other positions, weighted by
/// their reliability and no faster than they move. All rotations are in the space of the bone's parent.
class TwistFollower {
 public:
  /// A source for the twist.
  struct Lead {
    Eigen::Quaterniond rotation;  ///< turns the axis to the same direction for every lead
    double weight = 1;            ///< share of the difference to apply, 0 to 1
    double rate_rad_s = 12;       ///< beyond the motion itself
    double motion_rad = 0;        ///< rotation since the last call of the positions behind this lead
  };

  /// @param axis   of the bone in its own space (unit)
  /// @param direction  where the axis must point (unit)
  /// @param start initial rotation
  Eigen::Quaterniond follow(const Vec3& axis, const Vec3& direction, const Eigen::Quaterniond& start,
                            std::initializer_list<Lead> leads, double dt_s);
  void reset() { last_.reset(); }

 private:
  std::optional<Eigen::Quaterniond> last_;
};

}  // namespace abrazo
