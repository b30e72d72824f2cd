#pragma once

#include <Eigen/Geometry>

#include "core/base/positions.hpp"

namespace abrazo {

/// The smallest rotation from direction `from` to `to`; both of any length above zero.
/// `Eigen::Quaterniond::FromTwoVectors`, compiled once: it contains a singular value decomposition, for
/// opposite directions, that takes seconds to compile.
Eigen::Quaterniond smallest_rotation(const Vec3& from, const Vec3& to);

}  // namespace abrazo
