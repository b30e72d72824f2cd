#pragma once

#include "core/base/positions.hpp"
#include "core/library/store/normalization.hpp"

namespace abrazo {

/// How mesh and capsules change the moved partner: one offset per joint, relative to the partner's heading,
/// that follows the edit like a critically damped spring. The edit has no memory, so its output jumps where
/// contacts change.
class Adaptation {
 public:
  void reset() { *this = Adaptation(); }
  /// @param asked positions of the edited joints, world [m]
  /// @param rate   omega of the spring [1/s]
  /// @return the present offsets, world [m]
  Pose follow(const Pose& asked, const RootFrame& place, double elapsed_s, double rate);

  // State, for serialisation.
  Adaptation() = default;
  Adaptation(const Pose& offset, const Pose& speed) : offset_(offset), speed_(speed) {}
  const Pose& offset() const { return offset_; }
  const Pose& speed() const { return speed_; }

 private:
  Pose offset_ = Pose::Zero();
  Pose speed_ = Pose::Zero();
};

}  // namespace abrazo
