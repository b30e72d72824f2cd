#pragma once

#include <Eigen/Geometry>

#include <cmath>

namespace abrazo {

/// Rotations are sent as four floats; what is far from a unit quaternion is none.
inline bool is_rotation(const Eigen::Quaterniond& q) {
  const double norm = q.norm();
  return std::isfinite(norm) && norm > 0.5 && norm < 1.5;
}

}  // namespace abrazo
