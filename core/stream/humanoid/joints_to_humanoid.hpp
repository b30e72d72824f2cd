#pragma once

#include <optional>

#include "core/motion/body/body.hpp"
#include "core/motion/body/joint_rotations.hpp"
#include "core/stream/humanoid/humanoid_points.hpp"

namespace abrazo {

/// Converts the 25 joints to local rotations and positions of Unity's humanoid bones, relative to a T-pose,
/// for avatars that use rotations only. Positions are those of the pose, so that motion which rotations of
/// this skeleton cannot express is preserved (lower back relative to pelvis, neck relative to chest, collar
/// bones).
///
/// Positions leave the twist open: that of an arm or leg comes from the plane in which it is bent, that of a
/// straight leg from its foot; otherwise it is carried along and returns slowly to the smallest rotation from
/// the T-pose. Head and hands are not twisted relative to neck and forearm.
class JointsToHumanoid {
 public:
  explicit JointsToHumanoid(const Body& body);

  /// Expects poses in order of time. @param time_s of the pose; a step of more than 0.25 s starts over
  HumanoidPose pose(const Pose& joints, double time_s);
  /// The next pose is the first one.
  void restart();

 private:
  struct Limb;
  using Rotation = Eigen::Quaterniond;
  /// Directions of bone, next bone and foot in the previous pose, in the space of the bone's parent.
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
  PerBone<Vec3> positions_;  ///< of the present pose, world
  PerBone<Rotation> rotations_;
  PerBone<TwistFollower> twists_;
  PerBone<std::optional<Trail>> trails_;
};

}  // namespace abrazo
