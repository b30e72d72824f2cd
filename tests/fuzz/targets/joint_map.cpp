#include "core/motion/joints/joint_map.hpp"

#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(joint_map)(fuzz::Bytes bytes) {
  const auto map = abrazo::parse_joint_map(fuzz::text_of(bytes), "map.json");
  if (!fuzz::accepted(map)) return;
  for (int joint = 0; joint < abrazo::joint_count; ++joint) (void)abrazo::describe_joint(*map, joint);
  const auto again = abrazo::parse_joint_map(abrazo::joint_map_json(*map), "again.json");
  fuzz::expect(again.ok(), "what was written of a map is refused");
  std::vector<std::string> points;
  for (const auto& rules : map->rules)
    for (const auto& rule : rules)
      for (const auto& term : rule.terms) points.push_back(term.point);
  const abrazo::JointBinding binding = abrazo::bind_joints(*map, points);
  (void)binding.joints_of(abrazo::Positions::Zero(static_cast<Eigen::Index>(points.size()), 3));
}
