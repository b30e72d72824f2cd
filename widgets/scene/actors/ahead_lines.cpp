#include "widgets/scene/actors/ahead_lines.hpp"

#include <algorithm>
#include <array>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {
namespace {

constexpr std::array<int, 6> shown_joints = {joints::Root,          joints::Head,
                                             joints::left_hand,     joints::right_hand,
                                             joints::left_toe_base, joints::right_toe_base};

}  // namespace

JointTrails::Lines ahead_lines(std::span<const Pose> poses, int first_vertex) {
  JointTrails::Lines ahead;
  for (const int joint : shown_joints) {
    const int first = static_cast<int>(ahead.xyz.size() / 3);
    for (std::size_t step = 0; step < poses.size(); ++step) {
      for (int axis = 0; axis < 3; ++axis) ahead.xyz.push_back(poses[step](joint, axis));
      if (step == 0) continue;
      const int here = first + static_cast<int>(step);
      ahead.lines.push_back({here - 1, here});
      ahead.age.push_back(std::min(1.0, static_cast<double>(step - 1) * ahead_step_s / ahead_s));
      ahead.vertex.push_back(first_vertex + joint);
    }
  }
  return ahead;
}

}  // namespace abrazo::widgets
