#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// A value that changes over time: times in seconds, ascending.
template <typename Value>
struct Keys {
  std::vector<double> times_s;
  std::vector<Value> values;
};

/// A node of a scene with its animation, as a file of any format has it.
struct SceneNode {
  std::string name;
  int parent = -1;                                     ///< stands before it
  Eigen::Affine3d rest = Eigen::Affine3d::Identity();  ///< in the parent's space
  Keys<Vec3> translations, scales;                     ///< empty: as at rest
  Keys<Eigen::Quaterniond> rotations;
  bool is_bone = false;    ///< deforms a mesh
  bool is_helper = false;  ///< part of its first own child's transform: not a point
  bool is_other = false;   ///< mesh, camera or light: not a point
};

/// The animated skeletons among a scene's nodes, sampled at the rate of the keys: one motion for each.
/// @param rate  that the file states; nothing: found from the keys
Result<std::vector<NamedMotion>> skeletons_of(const std::vector<SceneNode>& nodes, std::optional<double> rate,
                                              const std::string& file);

}  // namespace abrazo
