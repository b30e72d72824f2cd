#pragma once

#include <optional>

#include "core/library/store/normalization.hpp"

namespace abrazo {

/// How the recording carries the partner during a step.
struct RecordedStep {
  Vec3 speed = Vec3::Zero();  ///< of the centre of mass, horizontal, relative to the partner's heading [m/s]
  double turn = 0;            ///< of the heading during the step [rad]
};

/// Horizontal position of the partner's centre of mass and its heading, as a state with a speed. The heading
/// is turned by the recording, and closes the remaining angle like a critically damped spring. The position
/// goes to the desired place like a critically damped mass whose damping is relative to shares of the
/// recorded speed and of the speed of the desired place:
///   x'' = omega^2 s(D - x) - 2 omega (x' - beta v - gamma d),  s(e) = e / (1 + |e| / l),
///   v' = (c - v) / tau,  d' = (D' - d) / tau_D
/// with the desired place D and the recorded speed c. So it moves with the recording and with the user, but
/// accelerations of the recording and of the user's hips do not reach it. A desired place that moves faster
/// than a dancer has jumped, and its speed counts as 0. The constants were fitted to the captured partner,
/// see decision 30.
class PartnerPlace {
 public:
  PartnerPlace() = default;
  explicit PartnerPlace(const RootFrame& at) : at_(at) {}

  /// World [m]; the height is unused.
  const RootFrame& at() const { return at_; }
  /// Speed of the position, the recorded motion included [m/s]; of the heading without the recorded turn
  /// [rad/s].
  const Vec3& speed() const { return speed_; }
  double turning() const { return turning_; }
  /// Low-pass filtered speed of the recording, v, horizontal [m/s].
  const Vec3& recorded_speed() const { return recorded_speed_; }
  /// The desired place of the step before, if there was one, and its low-pass filtered speed, d, horizontal.
  const std::optional<Vec3>& desired() const { return desired_; }
  const Vec3& desired_speed() const { return desired_speed_; }

  /// At a change of source the turning continues: the spring takes the difference between the sources.
  /// @param lost_turning turning of the old source minus that of the new one [rad/s]
  void keep_turning(double lost_turning) { turning_ += lost_turning; }
  /// Distance over which the spring pulls, s(D - x), horizontal [m].
  Vec3 way_to(const RootFrame& wanted) const;
  /// Advances by a step.
  /// @param rate  omega of the position [1/s]
  /// @param drawn pull of held hands, added to that of the spring without its bound, horizontal [m]
  void advance(const RecordedStep& recorded, const RootFrame& wanted, double elapsed_s, double rate,
               const Vec3& drawn = Vec3::Zero());

  PartnerPlace(const RootFrame& at, const Vec3& speed, double turning, const Vec3& recorded_speed,
               const std::optional<Vec3>& desired = std::nullopt, const Vec3& desired_speed = Vec3::Zero())
      : at_(at),
        speed_(speed),
        turning_(turning),
        recorded_speed_(recorded_speed),
        desired_(desired),
        desired_speed_(desired_speed) {}

 private:
  RootFrame at_;
  Vec3 speed_ = Vec3::Zero();
  double turning_ = 0;
  Vec3 recorded_speed_ = Vec3::Zero();
  std::optional<Vec3> desired_;
  Vec3 desired_speed_ = Vec3::Zero();
};

}  // namespace abrazo
