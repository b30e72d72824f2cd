#include "core/motion/body/person_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

using namespace person_bounds;

/// The bones that both sides have alike, by the joints at their ends.
constexpr std::array<std::pair<int, int>, 4> paired_bones = {{{joints::left_knee, joints::right_knee},
                                                              {joints::left_ankle, joints::right_ankle},
                                                              {joints::left_elbow, joints::right_elbow},
                                                              {joints::left_wrist, joints::right_wrist}}};

std::string called(int joint) {
  return std::string(joint_names[static_cast<std::size_t>(joint)]);
}

std::string shown_m(double value) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), std::abs(value) < 1e4 ? "%.2f" : "%.3g", value);
  return text.data();
}

}  // namespace

std::optional<std::string> why_not_a_person(const Pose& pose) {
  for (int joint = 0; joint < joint_count; ++joint)
    for (const double coordinate : pose.row(joint))
      if (!(std::abs(coordinate) <= farthest_m))
        return called(joint) + " is " + shown_m(coordinate) + " m away; nobody is captured beyond " +
               shown_m(farthest_m) + " m";
  std::array<double, joint_count> bones{};  // by the joint at their end
  double all = 0;
  for (int joint = 1; joint < joint_count; ++joint) {
    const auto at = static_cast<std::size_t>(joint);
    bones[at] = (pose.row(joint) - pose.row(joint_parents[at])).norm();
    all += bones[at];
    if (bones[at] > longest_bone_m)
      return called(joint) + " is " + shown_m(bones[at]) + " m long; no bone of a person is longer than " +
             shown_m(longest_bone_m) + " m. Is the unit right?";
  }
  if (all < shortest_bones_m)
    return "all bones together are " + shown_m(all) + " m long; those of a person are at least " +
           shown_m(shortest_bones_m) + " m. Is the unit right?";
  double legs = 0;
  for (const int joint : {joints::left_knee, joints::left_ankle, joints::right_knee, joints::right_ankle})
    legs += bones[static_cast<std::size_t>(joint)];
  if (legs < least_leg_share * all)
    return "thighs and shins are " + shown_m(100 * legs / all) +
           " % of all bones; of a person's they are at least " + shown_m(100 * least_leg_share) + " %";
  for (const auto& [left, right] : paired_bones) {
    const double a = bones[static_cast<std::size_t>(left)], b = bones[static_cast<std::size_t>(right)];
    if (std::max(a, b) > most_uneven * std::min(a, b) && std::abs(a - b) > least_uneven_m)
      return called(left) + " is " + shown_m(a) + " m and " + called(right) + " " + shown_m(b) +
             " m long; both sides of a person are alike";
  }
  if (const double height = pose(joints::Root, 1); std::abs(height) > highest_root_m)
    return "the root is at a height of " + shown_m(height) + " m; nobody dances beyond " +
           shown_m(highest_root_m) + " m. Is the floor where it should be?";
  return std::nullopt;
}

bool is_jump_of_nobody(const Pose& from, const Pose& to, double elapsed_s) {
  const double moved_m = (to - from).rowwise().norm().mean();
  return !(moved_m <= std::max(least_jump_m, fastest_m_per_s * elapsed_s));
}

PersonDoubts person_doubts(std::span<const Pose> poses, double fps) {
  PersonDoubts doubts;
  for (std::size_t f = 0; f < poses.size(); ++f) {
    if (auto reason = why_not_a_person(poses[f])) {
      if (doubts.poses++ > 0) continue;
      doubts.first_pose = f;
      doubts.first_reason = std::move(*reason);
    } else if (f > 0 && fps > 0 && is_jump_of_nobody(poses[f - 1], poses[f], 1 / fps) &&
               !why_not_a_person(poses[f - 1])) {
      if (doubts.jumps++ == 0) doubts.first_jump = f;
    }
  }
  return doubts;
}

}  // namespace abrazo
