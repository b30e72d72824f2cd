#pragma once

#include "core/library/store/normalization.hpp"

namespace abrazo {

/// Where the partner's centre of mass is over the floor and which way it faces, as a state with a speed of
/// its own. The recording carries it; what is left to where the user wants it is closed like a critically
/// damped spring, so that a sway of the user's hips does not swing the partner about.
class PartnerPlace {
 public:
  PartnerPlace() = default;
  explicit PartnerPlace(const RootFrame& at) : at_(at) {}

  /// The height does not matter here; world [m].
  const RootFrame& at() const { return at_; }
  /// Of the spring alone, beside what the recording carries [m/s], [rad/s].
  const Vec3& speed() const { return speed_; }
  double turning() const { return turning_; }

  /// The recording took the partner this far since the last step, seen from its own heading, and turned it.
  void carry(const Vec3& own_path, double turn_rad);
  /// What carries the partner changes: the whole speed goes on, the spring has what the new source lacks.
  /// @param lost_speed  of the old source less that of the new one, world [m/s]
  void keep_speed(const Vec3& lost_speed, double lost_turning);
  /// Horizontal, as far as the spring pulls [m].
  Vec3 way_to(const RootFrame& wanted) const;
  /// @param rate  how fast what is left is closed: omega of the spring [1/s]
  void approach(const RootFrame& wanted, double elapsed_s, double rate);

  PartnerPlace(const RootFrame& at, const Vec3& speed, double turning)
      : at_(at), speed_(speed), turning_(turning) {}

 private:
  RootFrame at_;
  Vec3 speed_ = Vec3::Zero();
  double turning_ = 0;
};

}  // namespace abrazo
