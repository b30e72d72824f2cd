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
  PerBone<std::optional<Vec3>> end;  ///< end of a limb beyond its last bone, if the sender gives it
  Vec3 root_position = Vec3::Zero();
  Eigen::Quaterniond root_rotation = Eigen::Quaterniond::Identity();

  HumanoidPose();
  /// Whether all offsets are zero: the sender gives rotations only.
  bool lacks_offsets() const;
  /// Nearest ancestor that is present; -1 if there is none.
  int parent(int bone) const;
};

/// Converts a humanoid's local rotations to points in the world: the bones by their names, and the ends of
/// limbs as "<bone>_End" (toe tips, knuckles, crown).
///
/// Rotations are used unchanged, so positions are right for any rest pose. Only ends, and bodies without
/// offsets, require identity rest rotations (VRM 0). `calibrate` removes this requirement: rotations are then
/// relative to those at calibration, when the bones are in a T-pose.
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
  /// Measurements in the T-pose.
  struct Rest {
    PerBone<Eigen::Quaterniond> inverse;  ///< converts a bone's world rotation to one relative to the T-pose
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
