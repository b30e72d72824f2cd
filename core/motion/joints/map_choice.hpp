#pragma once

#include <optional>
#include <vector>

#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// The joint map for a file's points, applied to them.
struct ChosenMap {
  JointMap map;
  JointBinding binding;       ///< `missing` is what keeps the map from fitting
  std::vector<int> inferred;  ///< joints that the file lacks and that were inferred
  bool fits() const { return binding.missing.empty(); }
};

/// The given map, or the first built-in one that finds all joints; then the one that finds all but ends of
/// limbs, which are inferred; then what a skeleton's names and branches tell. When nothing fits, the one that
/// lacks least.
ChosenMap choose_map(const NamedMotion& motion, const std::optional<JointMap>& given);

}  // namespace abrazo
