#pragma once

#include <array>

#include "core/base/positions.hpp"
#include "core/choreography/choreography_options.hpp"

namespace abrazo {

/// Build of a dancer, symmetric. Offsets in the space of their segment: x to the left, y up, z forward [m].
struct DancerBody {
  double height = 1.75;
  Vec3 left_hip;  ///< from the root, pelvis space
  double thigh = 0, shank = 0;
  double ankle_above_toe_base = 0, ankle_behind_toe_base = 0;  ///< standing flat
  double toes = 0;
  double toe_rest_height = 0.04;  ///< toe-base above the floor, standing
  std::array<double, 3> spine{};  ///< root - lower back - upper back - thorax
  std::array<double, 3> neck{};   ///< thorax - lower neck - upper neck - head
  Vec3 left_shoulder;             ///< from the thorax, chest space
  double upper_arm = 0, forearm = 0, hand = 0;

  double leg() const { return thigh + shank; }
  double ankle_rest_height() const { return toe_rest_height + ankle_above_toe_base; }
  /// Height of the root with the legs stretched to `extension` of their length, feet under the hips.
  double standing_root_height(double extension) const {
    return ankle_rest_height() + extension * leg() - left_hip.y();
  }
};

/// Proportions of a man of 1.80 m and of a woman of 1.66 m, scaled to the given height.
DancerBody leader_body(double height_m);
DancerBody follower_body(double height_m);

/// The same with other lengths of arms and legs; longer legs shorten trunk and neck, so that the height
/// stays.
/// @throws std::invalid_argument if height or scales are out of range
DancerBody leader_body(const PerformerOptions& performer);
DancerBody follower_body(const PerformerOptions& performer);

}  // namespace abrazo
