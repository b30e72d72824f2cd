#pragma once

#include <vector>

#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// How the 25 joints were found in a skeleton that no built-in joint map is made for.
struct SkeletonMap {
  JointMap map;               ///< called "skeleton"; joints that are missing have no rule
  std::vector<int> missing;   ///< joints that are neither there nor can be inferred; empty: a whole body
  std::vector<int> inferred;  ///< joints that the file lacks: ends of limbs, parts of the spine
};

/// Limbs by what their bones are usually called (LeftUpLeg, LeftHip, lThigh, "Bip01 L Thigh", thigh_l), the
/// spine by what stands between the hips and the neck, whatever it is called and however many parts it has.
/// Hands, feet, the head's end and the spine's joints are inferred where they are not there.
/// @param motion  with parents; without any, nothing is found
SkeletonMap skeleton_map(const NamedMotion& motion);

/// Gives the ends of limbs that `map` has no rule for (toes, hands, the head's middle) one: from a point at
/// the end of the joint before ("LeftFoot_End"), or beyond it as in an average adult.
/// @return the joints that got one
std::vector<int> infer_ends(JointMap& map, const NamedMotion& motion);

}  // namespace abrazo
