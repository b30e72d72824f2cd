#include "core/retarget/body_retargeter.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace abrazo {

namespace {

using namespace joints;

constexpr double same_body_tolerance = 0.005;
constexpr double same_floor_tolerance_m = 0.015;
constexpr double full_reach = 0.9999;

struct Limb {
  int root, middle, end;
};
constexpr std::array<Limb, 2> legs = {
    {{LeftHipJoint, LeftFemur, LeftTibia}, {RightHipJoint, RightFemur, RightTibia}}};
constexpr std::array<Limb, 2> arms = {
    {{LeftClavicle, LeftHumerus, LeftWrist}, {RightClavicle, RightHumerus, RightWrist}}};
constexpr std::array<int, 9> trunk = {LeftHipJoint, RightHipJoint, LowerBack,    UpperBack,    Thorax,
                                      LowerNeck,    UpperNeck,     LeftClavicle, RightClavicle};

double bone_length(const Body& body, int joint) {
  return body.bone_lengths[static_cast<std::size_t>(joint - 1)];
}

int parent(int joint) {
  return joint_parents[static_cast<std::size_t>(joint)];
}

Vec3 direction(const Pose& pose, int joint) {
  const Vec3 bone_vector = pose.row(joint) - pose.row(parent(joint));
  const double length = bone_vector.norm();
  return length > 1e-9 ? Vec3(bone_vector / length) : Vec3::UnitY();
}

void place_after_parent(Pose& pose, const Pose& like, const Body& body, int joint) {
  pose.row(joint) = pose.row(parent(joint)) + bone_length(body, joint) * direction(like, joint).transpose();
}

}  // namespace

Vec3 two_bone_joint(const Vec3& root, Vec3& end, double upper_length, double lower_length,
                    const Vec3& bend_hint) {
  Vec3 along = end - root;
  double reach = along.norm();
  along = reach > 1e-9 ? Vec3(along / reach) : Vec3(-Vec3::UnitY());
  const double longest = full_reach * (upper_length + lower_length);
  const double shortest = std::abs(upper_length - lower_length) + 1e-6;
  reach = std::clamp(reach, shortest, std::max(shortest, longest));
  end = root + reach * along;

  const double cosine = (upper_length * upper_length + reach * reach - lower_length * lower_length) /
                        (2 * upper_length * reach);
  const double forward = upper_length * std::clamp(cosine, -1.0, 1.0);
  const double sideways = std::sqrt(std::max(0.0, upper_length * upper_length - forward * forward));
  Vec3 side = bend_hint - root;
  side -= side.dot(along) * along;
  if (side.norm() < 1e-6)
    side = along.unitOrthogonal();  // a straight limb: any plane will do, it bends by next to nothing
  return root + forward * along + sideways * side.normalized();
}

BodyRetargeter::BodyRetargeter(const Body& user, const Body& library_body, bool scale_root_path)
    : user_(user), library_(library_body) {
  same_bones_ = largest_length_difference(user, library_body) < same_body_tolerance;
  floor_shift_ = library_body.toe_rest_height - user.toe_rest_height;
  if (std::abs(floor_shift_) < same_floor_tolerance_m) floor_shift_ = 0;
  const double user_leg = user.leg_length();
  if (user_leg > 1e-6) scale_ = library_body.leg_length() / user_leg;
  path_scale_ = scale_root_path ? scale_ : 1.0;
}

Vec3 BodyRetargeter::scaled_floor_point(const Vec3& world) const {
  return {path_scale_ * world.x(), library_.toe_rest_height + scale_ * (world.y() - user_.toe_rest_height),
          path_scale_ * world.z()};
}

double BodyRetargeter::needed_drop(const Pose& user_pose, const Pose& rebuilt) const {
  double drop = 0;
  for (const Limb& leg : legs) {
    const int toe_base = leg.end + 1;
    const Vec3 ankle = scaled_floor_point(user_pose.row(toe_base)) -
                       bone_length(library_, toe_base) * direction(user_pose, toe_base);
    const Vec3 hip = rebuilt.row(leg.root);
    const double longest = full_reach * (bone_length(library_, leg.middle) + bone_length(library_, leg.end));
    const double horizontal = std::hypot(hip.x() - ankle.x(), hip.z() - ankle.z());
    if ((hip - ankle).norm() <= longest || horizontal >= longest) continue;
    drop = std::max(drop, hip.y() - (ankle.y() + std::sqrt(longest * longest - horizontal * horizontal)));
  }
  return drop;
}

Pose BodyRetargeter::apply(const Pose& user_pose) const {
  Pose pose = user_pose;
  if (same_bones_) {
    if (floor_shift_ != 0) pose.col(1).array() += floor_shift_;
    return pose;
  }
  pose.row(Root) = scaled_floor_point(user_pose.row(Root)).transpose();
  for (const int joint : trunk) place_after_parent(pose, user_pose, library_, joint);
  place_after_parent(pose, user_pose, library_, Head);

  const double drop = needed_drop(user_pose, pose);
  if (drop > 0) pose.col(1).array() -= drop;

  for (const Limb& leg : legs) {
    const int toe_base = leg.end + 1;
    // Anchored at the toe base, which is on the floor.
    Vec3 ankle = scaled_floor_point(user_pose.row(toe_base)) -
                 bone_length(library_, toe_base) * direction(user_pose, toe_base);
    // The user's knee, carried along with the limb.
    const Vec3 hint = Vec3(pose.row(leg.root)) + Vec3(user_pose.row(leg.middle) - user_pose.row(leg.root));
    pose.row(leg.middle) = two_bone_joint(pose.row(leg.root), ankle, bone_length(library_, leg.middle),
                                          bone_length(library_, leg.end), hint)
                               .transpose();
    pose.row(leg.end) = ankle.transpose();
    place_after_parent(pose, user_pose, library_, toe_base);
    place_after_parent(pose, user_pose, library_, toe_base + 1);
  }
  for (const Limb& arm : arms) {
    const Vec3 reach = user_pose.row(arm.end) - user_pose.row(arm.root);
    const double user_length = bone_length(user_, arm.middle) + bone_length(user_, arm.end);
    const double length = bone_length(library_, arm.middle) + bone_length(library_, arm.end);
    Vec3 wrist = Vec3(pose.row(arm.root)) + reach * (length / std::max(user_length, 1e-6));
    const Vec3 hint = Vec3(pose.row(arm.root)) + Vec3(user_pose.row(arm.middle) - user_pose.row(arm.root));
    pose.row(arm.middle) = two_bone_joint(pose.row(arm.root), wrist, bone_length(library_, arm.middle),
                                          bone_length(library_, arm.end), hint)
                               .transpose();
    pose.row(arm.end) = wrist.transpose();
    place_after_parent(pose, user_pose, library_, arm.end + 1);
  }
  return pose;
}

}  // namespace abrazo
