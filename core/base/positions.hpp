#pragma once

#include <Eigen/Core>

namespace abrazo {

using Vec3 = Eigen::Vector3d;

/// One row per point [m], right-handed, Y up.
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

inline constexpr int joint_count = 25;  ///< joints of one body (docs/guide/index.md, Joints)
inline constexpr int pair_vertex_count = 2 * joint_count;

/// Joint positions of one body, one row per joint of `JointSet` [m]. Fixed size: never allocates.
using Pose = Eigen::Matrix<double, joint_count, 3, Eigen::RowMajor>;

/// Both bodies: rows 0..24 active, 25..49 passive [m].
using PairPose = Eigen::Matrix<double, pair_vertex_count, 3, Eigen::RowMajor>;

/// Position of a joint, as a column [m].
inline Vec3 joint_at(const Pose& pose, int joint) {
  return pose.row(joint).transpose();
}

/// The horizontal part of a vector.
inline Vec3 along_floor(const Vec3& v) {
  return {v.x(), 0, v.z()};
}

}  // namespace abrazo
