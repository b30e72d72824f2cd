#include "core/choreography/fighter_limbs.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/positions.hpp"
#include "core/choreography/limb_ik.hpp"
#include "core/choreography/smooth_track.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {
namespace {

using namespace joints;

/// Drawn towards the base where a limb would be longer than it is.
Vec3 not_beyond(const Vec3& base, const Vec3& end, double length) {
  const Vec3 limb = end - base;
  const double distance = limb.norm();
  return distance > length ? Vec3(base + limb * (length / distance)) : end;
}

/// Axes of a foot in the air as columns: left, up, and from heel to toes.
Eigen::Matrix3d foot_in_the_air(const Vec3& shank, const Vec3& hinge, double pointed) {
  const Vec3 down = shank.normalized(), ahead = down.cross(hinge).normalized();
  const Vec3 toes = std::cos(pointed) * ahead + std::sin(pointed) * down;
  const Vec3 up = std::sin(pointed) * ahead - std::cos(pointed) * down;
  Eigen::Matrix3d axes;
  axes << up.cross(toes), up, toes;
  return axes;
}

}  // namespace

void place_fist(const DancerBody& body, Side side, const Vec3& hand, const Vec3& elbow, const Turn& chest,
                Pose& pose) {
  const bool left = side == Side::Left;
  const double straight = body.forearm + body.hand;
  const Vec3 shoulder = joint_at(pose, left ? left_shoulder : right_shoulder);
  const Vec3 fist = within_reach(shoulder, hand, body.upper_arm + straight);
  const Vec3 pole = chest.matrix() * Vec3(sign_of(side) * elbow.x(), elbow.y(), elbow.z());
  const Vec3 bend = middle_joint(shoulder, fist, body.upper_arm, straight, pole);
  pose.row(left ? left_elbow : right_elbow) = bend.transpose();
  pose.row(left ? left_wrist : right_wrist) = (bend + (fist - bend) * (body.forearm / straight)).transpose();
  pose.row(left ? left_hand : right_hand) = fist.transpose();
}

void place_lifted_leg(const DancerBody& body, Side side, const FootPosture& standing, double pelvis_yaw,
                      const LiftedFoot& lifted, Pose& pose) {
  const bool left = side == Side::Left;
  const Vec3 hip = joint_at(pose, left ? left_hip : right_hip);
  // A foot just lifted may be a little further away than a striking one may be.
  const Vec3 reached = within_reach(hip, lifted.ankle, body.leg());
  const double freely = minimum_jerk(3 * lifted.share);
  const Vec3 ankle = not_beyond(hip, lifted.ankle + freely * (reached - lifted.ankle), 0.998 * body.leg());
  const double yaw = 0.5 * (pelvis_yaw + standing.yaw);
  const Vec3 standing_pole(std::sin(yaw), 0, std::cos(yaw));
  const Vec3 lifted_pole = (ankle - hip).normalized().cross(lifted.hinge);
  const Vec3 knee = middle_joint(hip, ankle, body.thigh, body.shank,
                                 standing_pole + lifted.share * (lifted_pole - standing_pole));
  const Eigen::Quaterniond on_floor(Turn{.yaw = standing.yaw, .pitch = standing.heel_pitch}.matrix());
  const Eigen::Quaterniond in_air(foot_in_the_air(ankle - knee, lifted.hinge, lifted.pointed));
  const Eigen::Matrix3d foot = on_floor.slerp(lifted.share, in_air).toRotationMatrix();
  const Eigen::Quaterniond toes_on_floor(Turn{standing.yaw, standing.toe_pitch, 0}.matrix());
  const Vec3 toes = toes_on_floor.slerp(lifted.share, in_air) * Vec3(0, 0, body.toes);
  const Vec3 toe_base = ankle - foot * Vec3(0, body.ankle_above_toe_base, -body.ankle_behind_toe_base);
  pose.row(left ? left_knee : right_knee) = knee.transpose();
  pose.row(left ? left_ankle : right_ankle) = ankle.transpose();
  pose.row(left ? left_toe_base : right_toe_base) = toe_base.transpose();
  pose.row(left ? left_toe_tip : right_toe_tip) = (toe_base + toes).transpose();
}

}  // namespace abrazo
