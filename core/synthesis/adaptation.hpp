#pragma once

#include "core/synthesis/transition.hpp"

namespace abrazo {

/// How the mesh and the capsules change the moved partner: per joint an offset, seen from the partner's
/// heading, that follows what the edit asks for like a critically damped spring. The edit is without memory:
/// what it asks for jumps where the mesh or a contact does. At a change of source the jump fades as the
/// change itself does.
class Adaptation {
 public:
  void reset() { *this = Adaptation(); }
  /// @param asked       of the edited joints, world [m]
  /// @param transition  of the source; begins with the change
  /// @param rate        omega of the spring [1/s]
  /// @return where the offset is now, world [m]
  Pose follow(const Pose& asked, const RootFrame& place, const Transition& transition, bool source_changed,
              double elapsed_s, double rate);

  Adaptation() = default;
  Adaptation(const Pose& offset, const Pose& speed, const Pose& goal, const Pose& jump)
      : offset_(offset), speed_(speed), goal_(goal), jump_(jump) {}
  const Pose& offset() const { return offset_; }
  const Pose& speed() const { return speed_; }
  const Pose& goal() const { return goal_; }
  const Pose& jump() const { return jump_; }

 private:
  Pose offset_ = Pose::Zero();
  Pose speed_ = Pose::Zero();
  Pose goal_ = Pose::Zero();  ///< what the offset followed in the frame before
  Pose jump_ = Pose::Zero();  ///< of the goal at the last change of source
};

}  // namespace abrazo
