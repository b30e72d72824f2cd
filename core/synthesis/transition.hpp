#pragma once

#include <array>

#include "core/base/positions.hpp"

namespace abrazo {

/// Lets the partner glide from one source to the next: the jump of the reference pose at a change of source
/// is kept as an offset that fades like a critically damped spring (inertialisation). The offset moves the
/// *reference* of the deformation energy, not the result, so bone lengths and contacts stay hard throughout.
class Transition {
 public:
  Transition() = default;
  Transition(const Pose& offset, const Pose& velocity) : offset_(offset), velocity_(velocity) {}
  void reset();
  /// @param hurry  per joint: fades so many times faster; where hands hold one another the hold comes before
  /// the glide
  void fade(double elapsed_s, double half_life_s, const std::array<double, joint_count>& hurry);
  /// The reference would have gone on at `continued` with `continued_velocity` [m/s] but is now `chosen`.
  void jump(const Pose& continued, const Pose& continued_velocity, const Pose& chosen,
            const Pose& chosen_velocity);
  /// One joint starts from where it was seen.
  void pull(int joint, const Vec3& seen, const Vec3& reference);

  const Pose& offset() const { return offset_; }
  const Pose& velocity() const { return velocity_; }

 private:
  Pose offset_ = Pose::Zero();
  Pose velocity_ = Pose::Zero();
};

}  // namespace abrazo
