#pragma once

#include <array>

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// One character's recorded body and the one that it gets.
struct BodyChange {
  Body from, to;

  /// Step lengths and heights follow the legs: ratio of the leg lengths, 1 if the recorded body has none.
  double legs() const;
  /// Capsules follow the height.
  double girth() const;
  bool changes() const { return from.bone_lengths != to.bone_lengths; }
};

/// Toe bases, left and right [m].
using ToeBases = std::array<Vec3, 2>;
ToeBases toe_bases(const Pose& pose);

/// The recorded pose with the lengths of the other body: bones keep their directions, the root stands at
/// `place` (its height is ignored), the hips are as high as the legs allow in proportion.
Pose rebuilt(const Pose& recorded, const BodyChange& change, const Vec3& place);

/// The same with its toe bases where they are to be, by the inverse kinematics of the legs; a leg that cannot
/// reach ends as near as it can.
Pose standing_at(Pose pose, const Body& body, const ToeBases& toe_bases);

}  // namespace abrazo
