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

/// Of literals, so it ends in a zero.
const char* called(int joint) {
  return joint_names[static_cast<std::size_t>(joint)].data();
}

template <typename... Values>
PersonDoubt doubt(const char* format, Values... values) {
  PersonDoubt doubt;
  std::snprintf(doubt.text.data(), doubt.text.size(), format, values...);
  return doubt;
}

}  // namespace

std::optional<PersonDoubt> why_not_a_person(const Pose& pose) {
  for (int joint = 0; joint < joint_count; ++joint)
    for (const double coordinate : pose.row(joint))
      if (!(std::abs(coordinate) <= farthest_m))
        return doubt("%s is %.4g m away; captures stay within %.0f m", called(joint), coordinate, farthest_m);
  std::array<double, joint_count> bones{};  // by the joint at their end
  double all = 0;
  for (int joint = 1; joint < joint_count; ++joint) {
    const auto at = static_cast<std::size_t>(joint);
    bones[at] = (pose.row(joint) - pose.row(joint_parents[at])).norm();
    all += bones[at];
    if (bones[at] > longest_bone_m)
      return doubt("%s is %.2f m long; no bone of a person is longer than %.2f m. Is the unit right?",
                   called(joint), bones[at], longest_bone_m);
  }
  if (all < shortest_bones_m)
    return doubt(
        "all bones together are %.2f m long; those of a person are at least %.2f m. Is the unit right?", all,
        shortest_bones_m);
  double legs = 0;
  for (const int joint : {joints::left_knee, joints::left_ankle, joints::right_knee, joints::right_ankle})
    legs += bones[static_cast<std::size_t>(joint)];
  if (legs < least_leg_share * all)
    return doubt("thighs and shins are %.0f %% of all bones; of a person's they are at least %.0f %%",
                 100 * legs / all, 100 * least_leg_share);
  for (const auto& [left, right] : paired_bones) {
    const double a = bones[static_cast<std::size_t>(left)], b = bones[static_cast<std::size_t>(right)];
    if (std::max(a, b) > most_uneven * std::min(a, b) && std::abs(a - b) > least_uneven_m)
      return doubt("%s is %.2f m and %s %.2f m long; both sides of a person are alike", called(left), a,
                   called(right), b);
  }
  if (const double height = pose(joints::Root, 1); std::abs(height) > highest_root_m)
    return doubt(
        "the root is at a height of %.2f m; nobody dances beyond %.2f m. Is the floor where it should be?",
        height, highest_root_m);
  return std::nullopt;
}

bool is_jump_beyond_a_person(const Pose& from, const Pose& to, double elapsed_s) {
  const double moved_m = (to - from).rowwise().norm().mean();
  return !(moved_m <= std::max(least_jump_m, fastest_m_per_s * elapsed_s));
}

PersonDoubts person_doubts(std::span<const Pose> poses, double fps) {
  PersonDoubts doubts;
  for (std::size_t f = 0; f < poses.size(); ++f) {
    if (const auto reason = why_not_a_person(poses[f])) {
      if (doubts.poses++ > 0) continue;
      doubts.first_pose = f;
      doubts.first_reason = reason->sentence();
    } else if (f > 0 && fps > 0 && is_jump_beyond_a_person(poses[f - 1], poses[f], 1 / fps) &&
               !why_not_a_person(poses[f - 1])) {
      if (doubts.jumps++ == 0) doubts.first_jump = f;
    }
  }
  return doubts;
}

}  // namespace abrazo
