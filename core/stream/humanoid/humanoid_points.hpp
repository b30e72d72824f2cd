#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/stream/humanoid/humanoid_bones.hpp"

namespace abrazo {

/// Local places and rotations of a humanoid's bones, right-handed, Y up [m].
struct HumanoidPose {
  PerBone<bool> present{};  ///< bones that the sender has
  PerBone<Vec3> position;   ///< from the nearest ancestor that is present
  PerBone<Eigen::Quaterniond> rotation;
  PerBone<std::optional<Vec3>> end;  ///< of a limb beyond its last bone, where the sender tells
  Vec3 root_position = Vec3::Zero();
  Eigen::Quaterniond root_rotation = Eigen::Quaterniond::Identity();

  HumanoidPose();
  /// Distances between bones are nought: the sender tells rotations only.
  bool lacks_offsets() const;
  /// Nearest ancestor that is present; -1 when there is none.
  int parent(int bone) const;
};

/// Turns a humanoid's local rotations into points in the world: the bones by their names, and the ends of
/// limbs as "<bone>_End" (toe tips, knuckles, crown).
///
/// Rotations are taken as they are, so that positions are right for any rest pose; only ends, and bodies
/// whose sender tells no offsets, need rest rotations to be none (VRM 0). `calibrate` lifts that: from then
/// on rotations are counted from those of that instant, and bones stand in a T-pose then.
class HumanoidPoints {
 public:
  /// The performer stands in the T-pose.
  void calibrate(const HumanoidPose& t_pose);
  bool is_calibrated() const { return rest_.has_value(); }

  /// The same pointer while the bones stay the same.
  std::shared_ptr<const std::vector<std::string>> names(const HumanoidPose& pose);
  /// In the order of `names`, world.
  Positions positions(const HumanoidPose& pose) const;

  /// Whether ends can be derived from rotations: offsets lie along the axes of a T-pose, or are unknown.
  static bool has_upright_rest(const HumanoidPose& pose);

 private:
  struct World {
    PerBone<Vec3> position;
    PerBone<Eigen::Quaterniond> rotation;
  };
  /// What was seen in the T-pose.
  struct Rest {
    PerBone<Eigen::Quaterniond> inverse;  ///< turns a bone's world rotation into that from the T-pose
    PerBone<Vec3> offset;                 ///< T-pose facing +Z
    PerBone<Vec3> end;
  };

  World world(const HumanoidPose& pose) const;
  World raw_world(const HumanoidPose& pose) const;
  std::vector<int> ends(const HumanoidPose& pose) const;
  Vec3 end_offset(const HumanoidPose& pose, int bone) const;

  std::optional<Rest> rest_;
  std::shared_ptr<const std::vector<std::string>> names_;
};

}  // namespace abrazo
