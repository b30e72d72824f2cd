#include "core/motion/joints/map_choice.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/motion/joints/skeleton_map.hpp"

namespace abrazo {

namespace {

/// Where the nodes of a file with CMU's names stand at the starts of its bones, as some writers of BVH from
/// ASF put them: each joint is where the next bone's node is. They show by hip joints at the root's place.
std::optional<ChosenMap> map_of_bone_starts(const NamedMotion& motion) {
  std::map<std::string, int> points;
  for (std::size_t p = 0; p < motion.points.size(); ++p)
    points.emplace(plain_point_name(motion.points[p]), static_cast<int>(p));
  const auto at = [&](const std::string& name) {
    const auto found = points.find(name);
    return found == points.end() ? -1 : found->second;
  };
  const auto is_at = [&](const std::string& one, const std::string& other, double scale) {
    const Positions& frame = motion.frames.front();
    return (frame.row(at(one)) - frame.row(at(other))).norm() <= 1e-3 * scale;
  };
  for (const char* name : {"lhipjoint", "rhipjoint", "lfemur", "ltibia", "thorax", "lowerneck", "upperneck"})
    if (at(name) < 0 || motion.frames.empty()) return std::nullopt;
  const Positions& frame = motion.frames.front();
  const double thigh = (frame.row(at("lfemur")) - frame.row(at("ltibia"))).norm();
  if (!is_at("lhipjoint", "rhipjoint", thigh) ||
      motion.parents[static_cast<std::size_t>(at("lhipjoint"))] < 0)
    return std::nullopt;
  const std::string root =
      motion.points[static_cast<std::size_t>(motion.parents[static_cast<std::size_t>(at("lhipjoint"))])];
  const auto name = [&](const std::string& point) {
    return at(point) < 0 ? point : motion.points[static_cast<std::size_t>(at(point))];
  };
  ChosenMap chosen{{"cmu-bone-starts", {}}, {}, {}};
  const auto set = [&](int joint, const std::string& point) {
    chosen.map.rules[static_cast<std::size_t>(joint)] = {JointRule{{{point, 1.0}}}};
  };
  set(joints::Root, root);
  set(joints::LowerBack, name("upperback")), set(joints::UpperBack, name("thorax"));
  set(joints::LowerNeck, name("upperneck")), set(joints::UpperNeck, name("head"));
  set(joints::Head, name("head") + "_End");
  // A branching bone's length may be lost: its children then start where it does.
  if (is_at("thorax", "lowerneck", thigh)) {
    chosen.map.rules[joints::Thorax] = {JointRule{{{name("thorax"), 0.5}, {name("upperneck"), 0.5}}}};
    chosen.inferred.push_back(joints::Thorax);
  } else {
    set(joints::Thorax, name("lowerneck"));
  }
  for (const std::string side : {"l", "r"}) {
    const auto sided = [&](int left_joint) { return side == "l" ? left_joint : mirrored_joint(left_joint); };
    set(sided(joints::left_hip), name(side + "femur")), set(sided(joints::left_knee), name(side + "tibia"));
    set(sided(joints::left_ankle), name(side + "foot")),
        set(sided(joints::left_toe_base), name(side + "toes"));
    set(sided(joints::left_toe_tip), name(side + "toes") + "_End");
    set(sided(joints::left_shoulder), name(side + "humerus"));
    set(sided(joints::left_elbow), name(side + "radius")),
        set(sided(joints::left_wrist), name(side + "hand"));
    chosen.map.rules[static_cast<std::size_t>(sided(joints::left_hand))] = {
        JointRule{{{name(side + "fingers"), 1.0}}}, JointRule{{{name(side + "hand") + "_End", 1.0}}}};
  }
  chosen.binding = bind_joints(chosen.map, motion.points);
  if (!chosen.fits()) return std::nullopt;
  return chosen;
}

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
  } else if (auto starts = map_of_bone_starts(motion)) {
    return std::move(*starts);
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
