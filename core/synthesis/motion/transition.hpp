#pragma once

#include <array>

#include "core/synthesis/motion/body_shape.hpp"

namespace abrazo {

/// 1 at 0, 0 at 1, with zero speed and acceleration at both ends (a quintic).
double quintic_fade(double share);
/// 0 at both ends with speed 1 at 0, 0 at 1, and no acceleration at either.
double quintic_slope(double share);

/// The fading remainder of a change of source: per bone the rotation from the source's direction to the shown
/// one, and the difference in root height. Fades by a quintic that starts with the offset and its rate and
/// ends at rest, so that the shown pose has continuous position and velocity.
class Transition {
 public:
  using Turns = std::array<Vec3, bone_count>;

  void reset() { *this = Transition(); }
  void advance(double elapsed_s) { elapsed_s_ += elapsed_s; }
  bool is_over() const { return elapsed_s_ >= duration_s_; }

  /// The shown pose of a source.
  BodyShape shown(const BodyShape& source) const;

  /// Begins a new transition from the shown pose.
  /// @param before_s time of `seen_before` and `source_before` before the present; 0 = unknown
  /// @param least_s duration for a small change; a large one takes up to 5/3 of it
  void begin(const BodyShape& seen, const BodyShape& source, const BodyShape& seen_before,
             const BodyShape& source_before, double before_s, double least_s);

  // State, for serialisation.
  const Turns& turns() const { return turns_; }
  const Turns& rates() const { return rates_; }
  double height() const { return height_; }
  double climb() const { return climb_; }
  double elapsed_s() const { return elapsed_s_; }
  double duration_s() const { return duration_s_; }
  Transition() { reset_turns(); }
  Transition(const Turns& turns, const Turns& rates, double height, double climb, double elapsed_s,
             double duration_s)
      : turns_(turns),
        rates_(rates),
        height_(height),
        climb_(climb),
        elapsed_s_(elapsed_s),
        duration_s_(duration_s) {}

 private:
  void reset_turns() {
    turns_.fill(Vec3::Zero());
    rates_.fill(Vec3::Zero());
  }

  Turns turns_;  ///< at the beginning [rad]
  Turns rates_;  ///< at the beginning [rad/s]
  double height_ = 0, climb_ = 0;
  double elapsed_s_ = 0, duration_s_ = 0;
};

}  // namespace abrazo
