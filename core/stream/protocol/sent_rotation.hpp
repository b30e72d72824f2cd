#pragma once

#include <Eigen/Geometry>

#include <cmath>

namespace abrazo {

/// Rotations are sent as four floats; values far from a unit quaternion are invalid.
inline bool is_rotation(const Eigen::Quaterniond& q) {
  const double norm = q.norm();
  return std::isfinite(norm) && norm > 0.5 && norm < 1.5;
}

}  // namespace abrazo
