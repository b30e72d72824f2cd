#pragma once

#include <Eigen/Geometry>

#include "core/base/positions.hpp"

namespace abrazo {

/// The rotation by the smallest angle that turns the direction `from` to `to`; neither need be of unit
/// length, neither may be zero. `Eigen::Quaterniond::FromTwoVectors`, compiled once: it contains a singular
/// value decomposition, for opposite directions, that takes seconds to compile.
Eigen::Quaterniond smallest_rotation(const Vec3& from, const Vec3& to);

}  // namespace abrazo
