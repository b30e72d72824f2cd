#pragma once

#include <array>

#include "core/base/positions.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

/// Closest points of two segments: p(s) = a + s (b - a), q(t) = c + t (d - c), s and t in [0, 1].
struct SegmentApproach {
  double s = 0;
  double t = 0;
  double distance = 0;         ///< [m]
  Vec3 normal = Vec3::Zero();  ///< unit, from q to p; zero if the segments intersect
};

SegmentApproach closest_points(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Radii of the capsules around one body's bones [m].
using CapsuleRadii = std::array<double, bone_count>;

/// Radii of a generic adult; 0 for bones inside the trunk that would only duplicate its volume.
const CapsuleRadii& generic_capsule_radii();

/// Hand ends of two people closer than this hold one another [m].
inline constexpr double hold_distance_m = 0.13;
/// A hold ends when the hands are this far apart [m].
inline constexpr double hold_ends_m = 0.18;

/// For pairs of an active and a passive hand: left-left, left-right, right-left, right-right.
using HandPairs = std::array<bool, 4>;

/// A hand of each body, as joint indices.
struct HandEnds {
  int active;
  int passive;
};
/// In the order of HandPairs.
inline constexpr std::array<HandEnds, 4> all_hand_ends = {{{joints::left_hand, joints::left_hand},
                                                           {joints::left_hand, joints::right_hand},
                                                           {joints::right_hand, joints::left_hand},
                                                           {joints::right_hand, joints::right_hand}}};

/// Distance of two hand ends [m].
inline double hands_apart(const PairPose& pair, const HandEnds& hands) {
  return (pair.row(hands.active) - pair.row(hands.passive + joint_count)).norm();
}
/// Whether they hold one another in a single recorded pair, without hysteresis.
inline bool hands_hold(const PairPose& pair, const HandEnds& hands) {
  return hands_apart(pair, hands) < hold_distance_m;
}

/// Whether a bone is a forearm or hand bone, which may overlap the partner's during a hold.
bool is_hand_or_forearm(int bone);

}  // namespace abrazo
