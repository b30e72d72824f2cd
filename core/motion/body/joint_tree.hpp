#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/motion/body/body.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/body/joint_rotations.hpp"

namespace abrazo {

/// A performer's joints as a tree of rotating nodes with fixed offsets, as in formats with rotations (BVH,
/// glTF). Where bones branch and move independently, a helper node of length 0 is inserted, so that every
/// bone has a separate rotation.
class JointTree {
 public:
  struct Node {
    std::string name;
    int joint;         ///< of the 25 at this place
    int parent;        ///< node index, -1 for the root; a parent comes before its children
    int aims_at = -1;  ///< joint towards which this node rotates; -1: pelvis, chest, or as the parent
    Vec3 offset;       ///< from the parent in the T-pose [m]
    std::vector<int> children;
  };

  /// Offsets are medians over the clip, which must not be empty.
  explicit JointTree(const Clip& clip);

  const std::vector<Node>& nodes() const { return nodes_; }

  /// World rotation of every node for a pose. Each bone aims from its start in the tree, so that differences
  /// of bone length do not accumulate along a limb. Twists continue from the previous pose.
  /// @param dt_s since the previous pose
  void rotations(const Pose& pose, double dt_s, std::vector<Eigen::Matrix3d>& world);

 private:
  /// The bone that a node rotates, with its last rotation.
  struct Bone {
    TwistFollower twist;
    Vec3 direction = Vec3::Zero();  ///< unit, in the space of the parent node; zero = not rotated yet
  };
  int add(std::string name, int joint, int parent, const Vec3& offset);
  void add_limb(int parent, const std::vector<int>& joints, const std::string& helper);
  Eigen::Matrix3d aimed(Bone& bone, const Vec3& rest, const Vec3& towards, double dt_s) const;

  Body body_;
  bool flat_pelvis_ = false;  ///< the root is on the line between the hips and does not determine the pelvis
                              ///< rotation
  std::vector<Node> nodes_;
  std::vector<Bone> bones_;   ///< by node
  std::vector<Vec3> places_;  ///< by node; kept so that a call does not allocate
};

}  // namespace abrazo
