#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo::test {

struct RigBone {
  std::string vrm, mixamo, parent;
  Vec3 at;  ///< at rest, facing +Z
};

/// A person of 1.6 m in a T-pose.
const std::vector<RigBone>& rig_bones();

enum class Naming : std::uint8_t { Mixamo, Vrm0, Vrm1 };

/// A GLB with the rig below an armature of centimetres, its bones rotated in themselves; VRM 0.x faces -Z.
std::string rig(Naming naming);

/// Half the size of the triangle around each bone of a rig with a skin [m].
inline constexpr double rig_triangle_m = 0.02;

/// The same rig with a skin: around the place of each bone a triangle that it carries alone, in the order of
/// rig_bones(), of a base colour with the linear red 0.5.
std::string skinned_rig(Naming naming);

}  // namespace abrazo::test
