#pragma once

#include "core/base/positions.hpp"
#include "core/library/store/normalization.hpp"

namespace abrazo {

/// How the capsules change the moved partner: per joint an offset, seen from the partner's heading, that
/// follows what the edit asks for like a critically damped spring. The edit is without memory: what it asks
/// for jumps where a contact does.
class Adaptation {
 public:
  void reset() { *this = Adaptation(); }
  /// @param asked  of the edited joints, world [m]
  /// @param rate   omega of the spring [1/s]
  /// @return where the offset is now, world [m]
  Pose follow(const Pose& asked, const RootFrame& place, double elapsed_s, double rate);

  // What it consists of, to be kept elsewhere and made again.
  Adaptation() = default;
  Adaptation(const Pose& offset, const Pose& speed) : offset_(offset), speed_(speed) {}
  const Pose& offset() const { return offset_; }
  const Pose& speed() const { return speed_; }

 private:
  Pose offset_ = Pose::Zero();
  Pose speed_ = Pose::Zero();
};

}  // namespace abrazo
