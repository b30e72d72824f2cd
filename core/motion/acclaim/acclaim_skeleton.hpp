#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Order in which rotations about x, y and z (0, 1, 2) are applied, first one first; "XYZ" is Rz Ry Rx.
using RotationOrder = std::array<int, 3>;

/// Rotation by `angles_rad` about x, y and z in the given order.
Eigen::Matrix3d rotation_of(const Vec3& angles_rad, const RotationOrder& order);

/// One bone of an .asf, or the root (no offset, all six dofs). Lengths in file units.
struct AcclaimBone {
  /// Meaning of a value in the motion: 0, 1, 2 rotate about x, y, z; 3, 4, 5 translate along them (root
  /// only).
  using Dof = int;

  std::string name;
  int parent = -1;                                     ///< index into the bones; -1 for the root
  Vec3 offset = Vec3::Zero();                          ///< direction x length, at zero rotation
  Eigen::Matrix3d axis = Eigen::Matrix3d::Identity();  ///< C of C R C^-1
  RotationOrder order = {0, 1, 2};                     ///< of the dofs and of `axis`
  std::vector<Dof> dofs;                               ///< in the order of the values in the motion
};

struct AcclaimSkeleton {
  std::vector<AcclaimBone> bones;     ///< the root first, every parent before its children
  Vec3 root_position = Vec3::Zero();  ///< used along axes without a value in the motion
  std::optional<double> length_unit;  ///< of `:units`
  bool degrees = true;                ///< of `:units`; a motion may override it
  std::vector<ImportWarning> warnings;
};

Result<AcclaimSkeleton> parse_asf(std::string_view text, std::string_view where);

}  // namespace abrazo
