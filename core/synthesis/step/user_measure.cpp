#include "core/synthesis/step/user_measure.hpp"

#include <algorithm>
#include <utility>

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double smallest_user_m = 0.3;
constexpr double largest_user_m = 3.5;
constexpr double shortest_user_bone_m = 1e-4;

/// As body_of, without allocation.
Body measured(const Pose& pose) {
  Body body;
  const auto apart = [&](std::pair<int, int> ends) {
    return (pose.row(ends.first) - pose.row(ends.second)).norm();
  };
  for (int b = 0; b < bone_count; ++b) body.bone_lengths[static_cast<std::size_t>(b)] = apart(bone(b));
  for (std::size_t p = 0; p < pseudo_bones.size(); ++p) body.pseudo_lengths[p] = apart(pseudo_bones[p]);
  const auto [low, high] = std::minmax(pose(joints::left_toe_base, 1), pose(joints::right_toe_base, 1));
  body.toe_rest_height = low + 0.05 * (high - low);
  return body;
}

bool is_of_a_person(const Body& body) {
  const double height = body.height();
  return height > smallest_user_m &&
         height<largest_user_m&& * std::min_element(body.bone_lengths.begin(), body.bone_lengths.end())>
             shortest_user_bone_m;
}

}  // namespace

bool UserMeasure::look_at(const Pose& user, double elapsed_s) {
  if (is_given_ || seen_s_ > measured_s) return false;
  const Body seen = measured(user);
  if (!is_of_a_person(seen)) return false;
  seen_s_ += elapsed_s;
  if (seen_++ == 0) {
    body_ = seen;
    return true;
  }
  const double share = 1.0 / seen_;
  const auto mix = [share](auto& known, const auto& now) {
    for (std::size_t i = 0; i < known.size(); ++i) known[i] += share * (now[i] - known[i]);
  };
  mix(body_->bone_lengths, seen.bone_lengths);
  mix(body_->pseudo_lengths, seen.pseudo_lengths);
  // A foot in the air gives no rest height.
  body_->toe_rest_height = std::min(body_->toe_rest_height, seen.toe_rest_height);
  return true;
}

}  // namespace abrazo
