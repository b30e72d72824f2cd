#pragma once

#include "core/library/store/normalization.hpp"

namespace abrazo {

/// Recorded motion between two moments, relative to the partner's heading.
struct RecordedPath {
  Vec3 own = Vec3::Zero();
  double turn = 0;
};

/// Horizontal position of the partner's centre of mass and its heading, as a state with a speed. The heading
/// is turned by the recording, and closes the remaining angle like a critically damped spring. The position
/// goes to the desired place like a damped mass whose damping is relative to a share of the recorded speed:
///   x'' = omega^2 s(D - x) - 2 zeta omega (x' - beta v),  v' = (c' - v) / tau,  s(e) = e / (1 + |e| / l)
/// with the desired place D and the recorded path c. So it moves with the recording, but accelerations of the
/// recording and of the user's hips do not reach it. The constants were fitted to the captured partner, see
/// decision 30.
class PartnerPlace {
 public:
  PartnerPlace() = default;
  explicit PartnerPlace(const RootFrame& at) : at_(at) {}

  /// World [m]; the height is unused.
  const RootFrame& at() const { return at_; }
  /// Speed of the position, with the recorded motion [m/s]; of the heading without the recorded turn [rad/s].
  const Vec3& speed() const { return speed_; }
  double turning() const { return turning_; }
  /// Low-pass filtered speed of the recorded path, v, horizontal [m/s].
  const Vec3& recorded_speed() const { return recorded_speed_; }

  /// At a change of source the turning continues: the spring takes the difference between the sources.
  /// @param lost_turning turning of the old source minus that of the new one [rad/s]
  void keep_turning(double lost_turning) { turning_ += lost_turning; }
  /// Distance over which the spring pulls, s(D - x), horizontal [m].
  Vec3 way_to(const RootFrame& wanted) const;
  /// Advances by a step.
  /// @param path  recorded motion during the step
  /// @param rate  omega of the position [1/s]
  /// @param drawn pull of held hands, added to that of the spring without its bound, horizontal [m]
  void advance(const RecordedPath& path, const RootFrame& wanted, double elapsed_s, double rate,
               const Vec3& drawn = Vec3::Zero());

  PartnerPlace(const RootFrame& at, const Vec3& speed, double turning, const Vec3& recorded_speed)
      : at_(at), speed_(speed), turning_(turning), recorded_speed_(recorded_speed) {}

 private:
  RootFrame at_;
  Vec3 speed_ = Vec3::Zero();
  double turning_ = 0;
  Vec3 recorded_speed_ = Vec3::Zero();
};

}  // namespace abrazo
