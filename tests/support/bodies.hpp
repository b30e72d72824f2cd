#pragma once

#include <random>

#include "core/base/positions.hpp"

namespace abrazo::test {

/// A standing adult of about 1.75 m, arms slightly raised, facing +Z, root over the origin, feet on y = 0.
Pose standing_pose();

/// The same turned by `yaw_rad` about Y and moved by `offset` [m].
Pose moved(const Pose& pose, double yaw_rad, const Vec3& offset);

/// Every joint shaken by a normal error of `sigma_m`.
Pose shaken(const Pose& pose, double sigma_m, std::mt19937& random);

/// Two people face to face at `distance_m`: active at the origin facing +Z, passive facing it.
PairPose facing_pair(double distance_m);

}  // namespace abrazo::test
