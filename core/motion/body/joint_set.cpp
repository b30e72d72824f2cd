#include "core/motion/body/joint_set.hpp"

#include <algorithm>
#include <string>

namespace abrazo {

std::optional<int> joint_index(std::string_view name) {
  const auto found = std::find(joint_names.begin(), joint_names.end(), name);
  if (found == joint_names.end()) return std::nullopt;
  return static_cast<int>(found - joint_names.begin());
}

int mirrored_joint(int joint) {
  std::string name(joint_names.at(static_cast<std::size_t>(joint)));
  if (joint == joints::LowerBack || joint == joints::LowerNeck || joint == joints::Root) return joint;
  if (name.front() == 'l')
    name.front() = 'r';
  else if (name.front() == 'r')
    name.front() = 'l';
  return joint_index(name).value_or(joint);
}

}  // namespace abrazo
