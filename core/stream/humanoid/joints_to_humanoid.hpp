#pragma once

#include <optional>

#include "core/motion/body/body.hpp"
#include "core/motion/body/joint_rotations.hpp"
#include "core/stream/humanoid/humanoid_points.hpp"

namespace abrazo {

/// Turns the 25 joints into the local rotations and places of Unity's humanoid bones, counted from a T-pose:
/// what an avatar shows that knows rotations only. Places are those of the pose, so that nothing is lost
/// where the 25 joints move in ways that rotations of this skeleton do not give (lower back against pelvis,
/// neck against chest, collar bones).
///
/// What positions leave open: an arm's or leg's twist comes from the plane in which it is bent, a straight
/// leg's from its foot; where neither tells, it is carried along and returns slowly to the smallest rotation
/// from the T-pose. Head and hands are not twisted against neck and forearm.
class JointsToHumanoid {
 public:
  explicit JointsToHumanoid(const Body& body);

  /// Poses in their order in time. @param time_s  of the pose; a step of more than 0.25 s starts over
  HumanoidPose pose(const Pose& joints, double time_s);
  /// The next pose is the first one.
  void restart();

 private:
  struct Limb;
  using Rotation = Eigen::Quaterniond;
  /// Directions of the pose before, in the space of the bone's parent: of the bone, of the next one, of the
  /// foot.
  struct Trail {
    Vec3 upper, lower, foot;
  };

  void start(const Pose& joints);
  void place(int bone, const Vec3& position_world, const Rotation& rotation_world);
  void end(int bone, const Vec3& position_world);
  void trunk(const Pose& joints);
  void arm(const Pose& joints, const Limb& limb);
  void leg(const Pose& joints, const Limb& limb);
  Rotation swung(int bone, const Rotation& parent, const Vec3& axis, const Vec3& towards);
  Rotation bent(int bone, const Vec3& axis, const Vec3& hinge, const Trail& now);

  bool flat_pelvis_;
  Vec3 left_shoulder_;  ///< from the thorax, T-pose [m]
  double toe_rest_height_;
  Rotation pelvis_rest_ = Rotation::Identity();
  std::array<Vec3, 2> foot_rest_;  ///< directions from ankle to toe base, T-pose; left, right
  std::optional<double> last_time_s_;
  double dt_s_ = 0;

  HumanoidPose made_;
  PerBone<Vec3> positions_;  ///< of the pose that is being made, world
  PerBone<Rotation> rotations_;
  PerBone<TwistFollower> twists_;
  PerBone<std::optional<Trail>> trails_;
};

}  // namespace abrazo
