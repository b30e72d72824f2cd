#pragma once

#include <array>
#include <span>

#include "core/base/positions.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

/// Properties of a performer that do not depend on the pose.
struct Body {
  std::array<double, bone_count> bone_lengths{};             ///< [m], bone b ends at joint b + 1
  std::array<double, pseudo_bones.size()> pseudo_lengths{};  ///< [m], see `pseudo_bones`
  double toe_rest_height = 0.04;  ///< toe-base height above the floor of a standing foot [m]

  /// Hip to ankle, mean of both legs [m].
  double leg_length() const;
  /// Height of the head joint while standing with a straight back [m]; the crown is about 10 cm higher. The
  /// height of the ankle is not a bone length and is estimated from the leg.
  double height() const;
};

/// Lengths measured in one pose.
Body body_of(const Pose& pose);

/// Median lengths over the poses, and the 5th percentile of the toe-base height as rest height
/// (reads at most about 2000 of them, evenly spread).
Body body_of(std::span<const Pose> poses);

/// Largest relative difference of a bone length.
double largest_length_difference(const Body& a, const Body& b);

}  // namespace abrazo
