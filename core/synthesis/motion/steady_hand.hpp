#pragma once

#include "core/base/positions.hpp"

namespace abrazo {

/// Filtered position of a user's hand that the partner holds. Optical systems and skeleton solvers can make a
/// hand jitter between frames, and a partner that holds it would shake. A deviation from the predicted
/// position with the opposite sign of the last one is weighted by 1/4, and the part beyond a plausible
/// acceleration by 1/5. Other motion is followed without lag. World space.
struct SteadyHand {
  bool is_seen = false;
  Vec3 at = Vec3::Zero();        ///< [m]
  Vec3 speed = Vec3::Zero();     ///< [m/s]
  Vec3 last_off = Vec3::Zero();  ///< last measured minus predicted position [m]

  /// @param measured   [m]
  /// @param elapsed_s  since the previous position; 0 restarts the filter
  void follow(const Vec3& measured, double elapsed_s);
};

}  // namespace abrazo
