#include "core/motion/joints/map_choice.hpp"

#include <algorithm>
#include <utility>

#include "core/motion/joints/skeleton_map.hpp"

namespace abrazo {

namespace {

/// The map with only the applied rule of each joint; none for missing joints.
JointMap as_bound(const ChosenMap& chosen, const NamedMotion& motion) {
  JointMap bound{chosen.map.name, {}};
  for (std::size_t j = 0; j < joint_count; ++j) {
    if (chosen.binding.terms[j].empty()) continue;
    JointRule rule;
    for (const auto& [point, weight] : chosen.binding.terms[j])
      rule.terms.push_back({motion.points[static_cast<std::size_t>(point)], weight});
    bound.rules[j] = {std::move(rule)};
  }
  return bound;
}

void infer_what_is_missing(ChosenMap& chosen, const NamedMotion& motion) {
  JointMap bound = as_bound(chosen, motion);
  std::vector<int> inferred = infer_ends(bound, motion);
  JointBinding binding = bind_joints(bound, motion.points);
  if (!binding.missing.empty()) return;
  binding.estimated = chosen.binding.estimated;
  chosen.binding = std::move(binding);
  chosen.inferred = std::move(inferred);
}

}  // namespace

ChosenMap choose_map(const NamedMotion& motion, const std::optional<JointMap>& given) {
  ChosenMap closest;
  const auto consider = [&](ChosenMap chosen) {
    if (closest.map.name.empty() || chosen.binding.missing.size() < closest.binding.missing.size())
      closest = std::move(chosen);
    return closest.fits();
  };
  if (given) {
    consider({*given, bind_joints(*given, motion.points), {}});
  } else {
    for (const JointMap& map : builtin_joint_maps())
      if (consider({map, bind_joints(map, motion.points), {}})) break;
  }
  if (!closest.fits()) infer_what_is_missing(closest, motion);
  if (closest.fits() || given) return closest;
  SkeletonMap skeleton = skeleton_map(motion);
  consider({skeleton.map, bind_joints(skeleton.map, motion.points), skeleton.inferred});
  return closest;
}

}  // namespace abrazo
