#pragma once

#include <vector>

#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// The 25 joints in a skeleton without a built-in joint map.
struct SkeletonMap {
  JointMap map;               ///< called "skeleton"; joints that are missing have no rule
  std::vector<int> missing;   ///< joints that neither exist nor can be inferred; empty: a complete body
  std::vector<int> inferred;  ///< inferred joints: ends of limbs, parts of the spine
};

/// Finds limbs by usual bone names (LeftUpLeg, LeftHip, lThigh, "Bip01 L Thigh", thigh_l), and the spine by
/// the chain between hips and neck, with any names and number of bones. Missing hands, feet, head end and
/// spine joints are inferred.
/// @param motion with parents; without them nothing is found
SkeletonMap skeleton_map(const NamedMotion& motion);

/// Adds rules for ends of limbs without one (toes, hands, the head's middle): from an end point of the
/// previous joint ("LeftFoot_End"), or beyond it by the proportions of an average adult.
/// @return the joints that got one
std::vector<int> infer_ends(JointMap& map, const NamedMotion& motion);

}  // namespace abrazo
