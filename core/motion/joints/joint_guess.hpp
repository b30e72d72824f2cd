#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// A guess of the joints among the points of an unknown file, for a person to check.
struct JointGuess {
  enum class By { Nothing, Name, Place, Others };
  JointMap map;  ///< joints without a guess have no rule
  std::array<By, joint_count> by{};
};

/// Guesses by names ("L_Knee", "RightForeArm", "thigh.L"), then by the positions in `frame`, compared with a
/// standing person fitted to the joints already found. Each point is used once.
JointGuess guess_joints(const NamedMotion& motion, std::size_t frame);

/// Adds rules for joints without one, between or beyond joints with one, by the proportions of an average
/// adult (the spine between pelvis and neck, a hand beyond the forearm). @return the joints that got one
std::vector<int> estimate_missing_joints(JointMap& map);

/// A frame in which every point is visible, if there is one.
std::size_t frame_to_look_at(const NamedMotion& motion);

}  // namespace abrazo
