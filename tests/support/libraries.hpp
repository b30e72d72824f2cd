#pragma once

#include <memory>

#include "core/library/store/motion_library.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo::test {

/// The pose with everything beyond `joint` turned about it. Keeps all bone lengths.
Pose bent(const Pose& pose, int joint, double angle_rad, const Vec3& axis);

/// Two people facing one another whose trunks, arms and legs swing smoothly, each seed differently; 60 frames
/// a second.
PairedTake swinging_take(const std::string& name, int frames, unsigned seed, double distance_m = 0.7);

/// Two such takes, performer A active.
std::shared_ptr<const MotionLibrary> small_library();

/// A library of two takes, "salsa_01" (a turn) and "salsa_02" (open hold), of a few pairs each.
std::shared_ptr<const MotionLibrary> two_take_library();

}  // namespace abrazo::test
