#pragma once

#include <array>
#include <span>

#include "core/base/positions.hpp"

namespace abrazo {

/// How a performer stands: what the rest pose of a rig corresponds to. Angles are pitches, forwards positive
/// [rad]; lengths in metres.
struct Stance {
  double leg = 0.82;       ///< hip to ankle
  double foot = 0.105;     ///< ankle to toe base
  double ankle = 0.085;    ///< height of the ankle
  double toe_base = 0.04;  ///< height of the toe base

  /// Nodes of the trunk in JointTree, upwards.
  enum Part { Pelvis, LowerBack, Chest, Neck, Head, PartCount };
  std::array<double, PartCount> pitch{};  ///< of the node's upward axis
  double lean = 0;                        ///< from between the hips to between the shoulders
  Vec3 shoulder = Vec3::UnitX();  ///< from the thorax to the left one in the chest's space, mirrored equal

  /// Of a performer with legs of another length.
  Stance with_legs(double length) const;
};

/// Medians over poses in which a performer also stands; an average adult if there are none.
Stance stance_of(std::span<const Pose> poses);

/// Pitch of a direction, forwards positive [rad].
/// @param left  from the right to the left side of the body, of any length
double pitch_of(const Vec3& direction, const Vec3& left);

}  // namespace abrazo
