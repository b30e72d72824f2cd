#pragma once

#include "core/library/store/normalization.hpp"

namespace abrazo {

/// Horizontal position of the partner's centre of mass and its heading, as a state with a speed. The
/// recording carries it; the remaining distance to the desired place is closed like a critically damped
/// spring, so that a sway of the user's hips does not swing the partner.
class PartnerPlace {
 public:
  PartnerPlace() = default;
  explicit PartnerPlace(const RootFrame& at) : at_(at) {}

  /// World [m]; the height is unused.
  const RootFrame& at() const { return at_; }
  /// Speed of the spring alone, without the recorded motion [m/s], [rad/s].
  const Vec3& speed() const { return speed_; }
  double turning() const { return turning_; }

  /// Applies the recorded path and turn since the last step; the path is relative to the partner's heading.
  void carry(const Vec3& own_path, double turn_rad);
  /// At a change of source: the total speed continues; the spring takes the difference between the sources.
  /// @param lost_speed speed of the old source minus that of the new one, world [m/s]
  void keep_speed(const Vec3& lost_speed, double lost_turning);
  /// Distance over which the spring pulls, horizontal [m].
  Vec3 way_to(const RootFrame& wanted) const;
  /// @param rate  omega of the spring [1/s]
  /// @param drawn pull of held hands, added to that of the spring without its bound, horizontal [m]
  void approach(const RootFrame& wanted, double elapsed_s, double rate, const Vec3& drawn = Vec3::Zero());

  PartnerPlace(const RootFrame& at, const Vec3& speed, double turning)
      : at_(at), speed_(speed), turning_(turning) {}

 private:
  RootFrame at_;
  Vec3 speed_ = Vec3::Zero();
  double turning_ = 0;
};

}  // namespace abrazo
