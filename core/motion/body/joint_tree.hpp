#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/motion/body/body.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/body/joint_rotations.hpp"

namespace abrazo {

/// A performer's joints as a tree of nodes with fixed offsets that turn, as files with rotations have them
/// (BVH, glTF). Where bones fan out that do not move as one, a helper without length stands between, so that
/// every bone has a rotation of its own.
class JointTree {
 public:
  struct Node {
    std::string name;
    int joint;         ///< of the 25 at this place
    int parent;        ///< node index, -1 for the root; a parent comes before its children
    int aims_at = -1;  ///< joint that this node's rotation turns towards; -1: pelvis, chest, or as the parent
    Vec3 offset;       ///< from the parent while all rotations are zero (T-pose) [m]
    std::vector<int> children;
  };

  /// Offsets are medians over the clip, which is not empty.
  explicit JointTree(const Clip& clip);

  const std::vector<Node>& nodes() const { return nodes_; }

  /// World rotation of every node for a pose. Each bone aims from where the tree puts its beginning, so that
  /// differences of bone length do not add up along a limb. Twists go on from the pose given before.
  /// @param dt_s  since that pose
  void rotations(const Pose& pose, double dt_s, std::vector<Eigen::Matrix3d>& world);

 private:
  /// The bone that a node turns, and how it was turned last.
  struct Bone {
    TwistFollower twist;
    Vec3 direction = Vec3::Zero();  ///< unit, in the space of the parent node; zero = not turned yet
  };
  int add(std::string name, int joint, int parent, const Vec3& offset);
  void add_limb(int parent, const std::vector<int>& joints, const std::string& helper);
  Eigen::Matrix3d aimed(Bone& bone, const Vec3& rest, const Vec3& towards, double dt_s) const;

  Body body_;
  bool flat_pelvis_ = false;  ///< root on the line between the hips: it does not fix the pelvis' rotation
  std::vector<Node> nodes_;
  std::vector<Bone> bones_;   ///< by node
  std::vector<Vec3> places_;  ///< by node; kept so that a call does not allocate
};

}  // namespace abrazo
