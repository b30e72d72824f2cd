#pragma once

#include <optional>
#include <vector>

#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// The joint map for a file's points, applied to them.
struct ChosenMap {
  JointMap map;
  JointBinding binding;       ///< the map fits if `missing` is empty
  std::vector<int> inferred;  ///< joints missing in the file and inferred
  bool fits() const { return binding.missing.empty(); }
};

/// The given map; else the first built-in one that finds all joints; else one that finds all except ends of
/// limbs, which are inferred; else a map derived from the skeleton's names and branches. If nothing fits, the
/// one with the fewest missing joints.
ChosenMap choose_map(const NamedMotion& motion, const std::optional<JointMap>& given);

}  // namespace abrazo
