#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/motion/body/joint_tree.hpp"
#include "core/motion/scenes/humanoid_rig.hpp"
#include "core/motion/scenes/limb_reach.hpp"
#include "core/motion/scenes/stance.hpp"

namespace abrazo {

/// How a performance is placed on a rig of another size.
struct RigPlace {
  Stance stance;    ///< of the performer
  double legs = 1;  ///< rig's leg length over the performer's
  double path = 1;  ///< metres of the rig per metre of the performer, in the floor plane and for hands
};

/// The path is scaled by the legs; give performers of one scene the same path, so that what meets in the
/// recording meets on the rigs.
RigPlace place_on_rig(const HumanoidRig& rig, const Stance& stance);

/// Puts poses of the 25 joints on the bones of a rig. Upper and lower legs point where the performer's do,
/// and so do the arms as far as the wrists then reach the performer's wrists: where they do not, shoulder and
/// elbow are corrected. Trunk, head, shoulders and feet turn as the performer's do from the stance, in which
/// the rig has its rest pose, leaning as the performer does. The hips follow the path, and feet stand on the
/// same floor.
class RigMotion {
 public:
  /// @param clip  of the performer, for the measures of the body; not empty
  RigMotion(std::shared_ptr<const HumanoidRig> rig, const Clip& clip, const RigPlace& place);

  /// Computes everything below for a pose. Twists of bones continue from the previous pose. Does not
  /// allocate.
  /// @param dt_s  since the previous pose
  void set_pose(const Pose& pose, double dt_s);

  /// A bone that the motion turns.
  struct BoneTurn {
    int node = -1;
    Eigen::Quaterniond local = Eigen::Quaterniond::Identity();  ///< instead of the node's own rotation
  };
  std::span<const BoneTurn> turns() const { return turns_; }
  int hips_node() const { return hips_; }
  /// Instead of the node's own translation.
  const Vec3& hips_translation() const { return hips_translation_; }
  /// Of every node in the rig's space [m].
  std::span<const Eigen::Affine3d> world() const { return world_; }
  const RigPlace& place() const { return place_; }

 private:
  using Rotation = Eigen::Matrix3d;
  struct Turned {
    std::size_t turner;  ///< node of the tree
    Rotation from_rest;  ///< the bone at rest, turned to the T-pose of the tree
    Rotation goal = Rotation::Identity();
  };
  struct Arm {
    std::size_t upper, lower;  ///< in turned_
    int upper_joint, wrist;    ///< of the 25
    LimbReach reach;
  };
  void add_arm(const char* upper, const char* lower, const char* hand, int shoulder, int wrist);
  Rotation from_stance(std::string_view bone) const;
  void bring_wrist(Arm& arm, const Pose& pose, const Vec3& shoulder);
  Eigen::Affine3d parent_of(const RigNode& node) const;
  Vec3 hips_goal(const Pose& pose) const;

  std::shared_ptr<const HumanoidRig> rig_;
  RigPlace place_;
  JointTree tree_;
  std::vector<Rotation> tree_turns_;
  std::vector<int> turned_of_node_;  ///< -1: the node keeps its own rotation
  std::vector<Turned> turned_;
  std::vector<BoneTurn> turns_;
  std::vector<Eigen::Affine3d> world_;
  std::vector<Arm> arms_;
  int hips_ = -1;
  Vec3 hips_translation_ = Vec3::Zero();
  Rotation to_front_ = Rotation::Identity();  ///< turns the character at rest to look along +Z
  double rig_ankle_rest_ = 0;
};

/// For each clip of one scene the motion of a character that performs it. The path of all is scaled by the
/// mean of their legs: hands that meet in the clips meet on the rigs.
/// @param clips  not empty
std::vector<RigMotion> rig_motions(const std::shared_ptr<const HumanoidRig>& rig,
                                   std::span<const Clip> clips);

}  // namespace abrazo
