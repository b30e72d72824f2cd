#pragma once

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// Maps a user's pose to the proportions of a library body: q_in -> q'_in (paper 3.3.1). A function of the
/// pose only, so planted feet stay planted without state:
/// - the path of root and feet is scaled by the ratio of the leg lengths about the floor under the origin;
/// - spine, neck and shoulder girdle keep their directions, with the library's lengths;
/// - a leg reaches its scaled toe base, an arm the same share of its reach in the same direction from the
/// shoulder,
///   by two-bone inverse kinematics in the user's own plane of the limb; feet, toes and hands keep their
///   directions.
/// If a leg cannot reach its foot, the root is lowered, not the foot (unless the foot is too far to the side
/// for that).
class BodyRetargeter {
 public:
  BodyRetargeter(const Body& user, const Body& library_body, bool scale_root_path = true);

  /// Equal bodies (every bone within 0.5 %, feet at rest within 1.5 cm): poses are returned unchanged, to the
  /// bit.
  bool is_identity() const { return same_bones_ && floor_shift_ == 0; }

  /// Scale of the path over the floor; 1 if poses are returned unchanged.
  double path_scale() const { return same_bones_ ? 1.0 : path_scale_; }

  Pose apply(const Pose& user_pose) const;

 private:
  Vec3 scaled_floor_point(const Vec3& world) const;
  double needed_drop(const Pose& user_pose, const Pose& rebuilt) const;

  Body user_;
  Body library_;
  double scale_ = 1;
  double path_scale_ = 1;
  bool same_bones_ = true;
  double floor_shift_ = 0;  ///< of an equal body on another floor height
};

/// Elbow or knee of a two-bone limb from `root` to `end`, bent towards the side of `bend_hint`. An end out of
/// reach is moved to 99.99 % of the limb's length. @param[in,out] end moved within reach
Vec3 two_bone_joint(const Vec3& root, Vec3& end, double upper_length, double lower_length,
                    const Vec3& bend_hint);

}  // namespace abrazo
