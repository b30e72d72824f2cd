#pragma once

#include <Eigen/Geometry>
#include <initializer_list>
#include <optional>

#include "core/base/positions.hpp"

namespace abrazo {

/// Arithmetic of rotations that are found from positions, for formats that hold rotations (BVH, VMC).

/// Direction of the bone that ends at a joint when all rotations are zero: standing with the arms held
/// sideways, facing +Z (T-pose).
Vec3 rest_direction(int joint);

/// Right-handed axes with x along `side` and y as close to `up` as that allows.
Eigen::Matrix3d frame_of(const Vec3& side, const Vec3& up);

/// The smallest rotation that turns `from` (unit) towards `to`; none when `to` has no length.
Eigen::Matrix3d swing(const Vec3& from, const Vec3& to);

/// Rotation of the pelvis from the triangle of root and hips: x from right to left, y from between the hips
/// to the root.
/// @param flat  root on the line between the hips, so that the lower back must tell where up is
Eigen::Matrix3d pelvis_rotation(const Pose& pose, bool flat);

/// Rotation of the chest: x from shoulder to shoulder, y from the upper back to the thorax.
Eigen::Matrix3d chest_rotation(const Pose& pose);

/// Decides the part of a bone's rotation that its direction leaves open, its twist, so that it never jumps:
/// carried along with the bone by the smallest rotation, and led towards what other positions say, by as much
/// as they are sure and no faster than they move. All rotations in the space of the bone's parent.
class TwistFollower {
 public:
  /// What would decide the twist.
  struct Lead {
    Eigen::Quaterniond rotation;  ///< turns the axis to the same direction for every lead
    double weight = 1;            ///< share of the difference that is taken up, 0 to 1
    double rate_rad_s = 12;       ///< beyond the motion itself
    double motion_rad = 0;        ///< turned since the last call by what this lead was found from
  };

  /// @param axis   of the bone in its own space (unit)
  /// @param direction  where the axis must point (unit)
  /// @param start  the rotation when there was none before
  Eigen::Quaterniond follow(const Vec3& axis, const Vec3& direction, const Eigen::Quaterniond& start,
                            std::initializer_list<Lead> leads, double dt_s);
  void reset() { last_.reset(); }

 private:
  std::optional<Eigen::Quaterniond> last_;
};

}  // namespace abrazo
