#pragma once

#include <Eigen/Geometry>

#include "core/base/positions.hpp"

namespace abrazo {

/// Two bones whose end is brought to a place with the least change of their directions: the bend of the
/// middle joint gives the distance, in the plane of the limb, and the whole limb swings to the direction.
/// Near full length the bend ends smoothly, and the end falls short by up to 2 mm per metre of limb. A place
/// that is out of reach is pointed at.
class LimbReach {
 public:
  /// @param upper_m, lower_m  lengths of the bones
  /// @param bend  axis about which the limb bends while it is straight, in the space of the upper bone (unit)
  LimbReach(double upper_m, double lower_m, const Vec3& bend)
      : upper_m_(upper_m), lower_m_(lower_m), bend_(bend) {}

  /// Rotations to apply to the bones, in world space.
  struct Correction {
    Eigen::Matrix3d upper, lower;
  };
  /// @param upper, lower     directions of the bones (unit)
  /// @param upper_rotation   of the space in which the bend axis is kept
  /// @param to               the place, from the start of the upper bone [m]
  Correction bring(const Vec3& upper, const Vec3& lower, const Eigen::Matrix3d& upper_rotation,
                   const Vec3& to);

 private:
  double bend_rad(double distance_m) const;

  double upper_m_, lower_m_;
  Vec3 bend_;  ///< last axis, in the space of the upper bone
};

}  // namespace abrazo
