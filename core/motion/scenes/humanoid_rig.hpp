#pragma once

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/positions.hpp"
#include "core/base/result.hpp"

namespace abrazo {

struct GlbFile;

/// A bone of a humanoid, and what turns it.
struct HumanoidBone {
  std::string_view name;    ///< of VRM, in lower case
  std::string_view mixamo;  ///< without prefix, in lower case
  std::string_view turner;  ///< node of JointTree
  std::string_view next;    ///< the bone it points at, of a limb whose direction is that of the motion
  bool is_required = true;
};

inline constexpr std::array humanoid_bones = {
    HumanoidBone{"hips", "hips", "root", ""},
    HumanoidBone{"spine", "spine", "lowerback", ""},
    HumanoidBone{"chest", "spine1", "thorax", "", false},
    HumanoidBone{"upperchest", "spine2", "thorax", "", false},
    HumanoidBone{"neck", "neck", "lowerneck", "", false},
    HumanoidBone{"head", "head", "upperneck", ""},
    HumanoidBone{"leftshoulder", "leftshoulder", "thorax_left", "", false},
    HumanoidBone{"leftupperarm", "leftarm", "lclavicle", "leftlowerarm"},
    HumanoidBone{"leftlowerarm", "leftforearm", "lhumerus", "lefthand"},
    HumanoidBone{"lefthand", "lefthand", "lwrist", ""},
    HumanoidBone{"rightshoulder", "rightshoulder", "thorax_right", "", false},
    HumanoidBone{"rightupperarm", "rightarm", "rclavicle", "rightlowerarm"},
    HumanoidBone{"rightlowerarm", "rightforearm", "rhumerus", "righthand"},
    HumanoidBone{"righthand", "righthand", "rwrist", ""},
    HumanoidBone{"leftupperleg", "leftupleg", "lhipjoint", "leftlowerleg"},
    HumanoidBone{"leftlowerleg", "leftleg", "lfemur", "leftfoot"},
    HumanoidBone{"leftfoot", "leftfoot", "ltibia", ""},
    HumanoidBone{"lefttoes", "lefttoebase", "lfoot", "", false},
    HumanoidBone{"rightupperleg", "rightupleg", "rhipjoint", "rightlowerleg"},
    HumanoidBone{"rightlowerleg", "rightleg", "rfemur", "rightfoot"},
    HumanoidBone{"rightfoot", "rightfoot", "rtibia", ""},
    HumanoidBone{"righttoes", "righttoebase", "rfoot", "", false}};

/// A node at rest.
struct RigNode {
  int parent = -1;
  Eigen::Affine3d local = Eigen::Affine3d::Identity(), world = Eigen::Affine3d::Identity();
};

/// The nodes of a humanoid character (GLB, VRM 0.x or 1.0), and which of them are its bones.
struct HumanoidRig {
  std::vector<RigNode> nodes;  ///< as numbered in the file
  std::vector<int> order;      ///< of all nodes; a parent comes before its children
  /// Of VRM's names in lower case; those that are required exist.
  std::map<std::string, int, std::less<>> bones;

  const RigNode& node(std::string_view bone) const {
    return nodes[static_cast<std::size_t>(bones.find(bone)->second)];
  }
  /// Place of a bone at rest, in the file's metres.
  Vec3 rest(std::string_view bone) const { return node(bone).world.translation(); }
  /// Hip to ankle, mean of both legs, at rest.
  double leg_length() const;
};

/// Nodes of the bones that a VRM (0.x, 1.0, or an animation) lists, by VRM's names in lower case.
std::map<std::string, int, std::less<>> vrm_bone_nodes(const GlbFile& glb);

/// Bones are those that VRM lists, or found by the names of Mixamo or VRM.
/// @param where  the file's name, for messages
/// @return an Error if nodes are damaged, or a bone is missing that every VRM has
Result<HumanoidRig> read_humanoid_rig(const GlbFile& glb, const std::string& where);

}  // namespace abrazo
