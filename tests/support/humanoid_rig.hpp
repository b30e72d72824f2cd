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

}  // namespace abrazo::test
