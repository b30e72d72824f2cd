#pragma once

#include "core/base/positions.hpp"

namespace abrazo {

/// A hand of the user as the partner reaches for it. Optical systems and skeleton solvers make a hand jump to
/// and fro from frame to frame; a partner who holds it would shake. A position that is on the other side of
/// the expected one than the position before it counts by a quarter, and what is beyond any hand's
/// acceleration by a fifth. All else is followed without lag. World space.
struct SteadyHand {
  bool is_seen = false;
  Vec3 at = Vec3::Zero();        ///< [m]
  Vec3 speed = Vec3::Zero();     ///< [m/s]
  Vec3 last_off = Vec3::Zero();  ///< of the last measured position from the expected one [m]

  /// @param measured   [m]
  /// @param elapsed_s  since the position before; 0 begins anew
  void follow(const Vec3& measured, double elapsed_s);
};

}  // namespace abrazo
