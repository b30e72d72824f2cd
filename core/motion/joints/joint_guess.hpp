#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Guesses which points of an unknown file are which joints, for a person to check.
struct JointGuess {
  enum class By { Nothing, Name, Place, Others };
  JointMap map;  ///< joints without a guess have no rule
  std::array<By, joint_count> by{};
};

/// By what names say ("L_Knee", "RightForeArm", "thigh.L"), then by where the points are in `frame` as
/// compared with a standing person fitted to the joints that were found. Each point is used once.
JointGuess guess_joints(const NamedMotion& motion, std::size_t frame);

/// Gives joints without a rule one between or beyond those that have one, as in an average adult (a spine of
/// the pelvis and the neck, a hand beyond the forearm). @return the joints that got one
std::vector<int> estimate_missing_joints(JointMap& map);

/// Of all frames one in which every point was seen, as far as there is one.
std::size_t frame_to_look_at(const NamedMotion& motion);

}  // namespace abrazo
