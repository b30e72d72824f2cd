#pragma once

#include <array>

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// A character's recorded body and its new body.
struct BodyChange {
  Body from, to;

  /// Step lengths and heights follow the legs: ratio of the leg lengths, 1 if the recorded body has none.
  double legs() const;
  bool changes() const { return from.bone_lengths != to.bone_lengths; }
};

/// Toe bases, left and right [m].
using ToeBases = std::array<Vec3, 2>;
ToeBases toe_bases(const Pose& pose);

/// The recorded pose with the lengths of the new body: bones keep their directions, the root is at
/// `place` (its height is ignored), and the height of the hips scales with the legs.
Pose rebuilt(const Pose& recorded, const BodyChange& change, const Vec3& place);

/// The same with its toe bases at the given places, by inverse kinematics of the legs; a leg that cannot
/// reach ends as near as possible.
Pose standing_at(Pose pose, const Body& body, const ToeBases& toe_bases);

}  // namespace abrazo
