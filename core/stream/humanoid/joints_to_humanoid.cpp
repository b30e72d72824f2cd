#include "core/stream/humanoid/joints_to_humanoid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/base/rotation.hpp"

namespace abrazo {

/// Bones and joints of one arm or leg, from the trunk outwards.
struct JointsToHumanoid::Limb {
  bool left;
  std::array<int, 4> bones;  ///< collar bone, upper, lower, hand; or upper, lower, foot, toes
  std::array<int, 5>
      joints;  ///< where those begin (an arm's first bone: the thorax), and where the last ends
};

namespace {

using namespace joints;
using Rotation = Eigen::Quaterniond;

constexpr double longest_step_s = 0.25;

/// Sines of the angle between two parts of a limb: below the first their plane is not used, above the
/// second it alone is used (6 and 20 degrees).
constexpr double no_plane = 0.1, full_plane = 0.35;

/// Speed at which a twist follows its source, beyond the source's own motion; and speed of the return to the
/// smallest rotation without a source.
constexpr double follow_rad_s = 12, return_rad_s = 1.5;

/// Start of the collar bone, as a share of the distance from thorax to shoulder.
constexpr double collar_share = 0.15;

double smooth_step(double from, double to, double value) {
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Vec3 at(const Pose& pose, int joint) {
  return pose.row(joint).transpose();
}

Vec3 direction(const Pose& pose, int from, int to, const Vec3& otherwise) {
  const Vec3 difference = at(pose, to) - at(pose, from);
  return difference.norm() > 1e-9 ? Vec3(difference.normalized()) : otherwise;
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Turns `axis` to `along`, and `hinge` (perpendicular to the axis) as near as can be to `normal`.
Rotation with_plane(const Vec3& axis, const Vec3& hinge, const Vec3& along, const Vec3& normal) {
  return Rotation(Eigen::Matrix3d(frame_of(along, normal) * frame_of(axis, hinge).transpose()));
}

/// Turns `axis` to `along` about `hinge` as far as that goes, and the rest by the smallest rotation.
Rotation hinged(const Vec3& axis, const Vec3& hinge, const Vec3& along) {
  const double angle = std::atan2(along.dot(hinge.cross(axis)), along.dot(axis));
  const Rotation about_hinge(Eigen::AngleAxisd(angle, hinge));
  return smallest_rotation(about_hinge * axis, along) * about_hinge;
}

Vec3 thorax_to_left_shoulder(const Body& body) {
  const auto length = [&](int joint) { return body.bone_lengths[static_cast<std::size_t>(joint - 1)]; };
  const double along = 0.5 * (length(LeftClavicle) + length(RightClavicle));
  const double half = std::min(0.5 * body.pseudo_lengths[1], along);
  const double to_neck = 0.5 * (body.pseudo_lengths[2] + body.pseudo_lengths[3]);
  const double rise = std::sqrt(along * along - half * half), neck = length(LowerNeck);
  const auto miss = [&](double y) { return std::abs(std::hypot(half, neck - y) - to_neck); };
  return {half, miss(rise) < miss(-rise) ? rise : -rise, 0};
}

bool has_flat_pelvis(const Body& body) {
  const double half = 0.5 * body.pseudo_lengths[0];
  const double to_hip = 0.5 * (body.bone_lengths[LeftHipJoint - 1] + body.bone_lengths[RightHipJoint - 1]);
  return to_hip * to_hip - half * half < 0.01 * 0.01;
}

}  // namespace

JointsToHumanoid::JointsToHumanoid(const Body& body)
    : flat_pelvis_(has_flat_pelvis(body)),
      left_shoulder_(thorax_to_left_shoulder(body)),
      toe_rest_height_(body.toe_rest_height) {
  for (int bone = 0; bone < humanoid::FirstFinger; ++bone)
    made_.present[static_cast<std::size_t>(bone)] =
        bone != humanoid::Jaw && bone != humanoid::LeftEye && bone != humanoid::RightEye;
}

void JointsToHumanoid::restart() {
  last_time_s_.reset();
  for (TwistFollower& twist : twists_) twist.reset();
  trails_.fill(std::nullopt);
}

/// Properties of the T-pose that body lengths do not determine: the inclination of the triangle of root and
/// hips in an upright pelvis, and the position of the ankle above the toes. Both are taken from the first
/// pose, which is usually upright.
void JointsToHumanoid::start(const Pose& joints) {
  const Eigen::Matrix3d pelvis = pelvis_rotation(joints, flat_pelvis_);
  const Vec3 up = pelvis.transpose() * direction(joints, Root, LowerBack, pelvis.col(1));
  constexpr double most_lean = 35 * std::numbers::pi / 180;
  const double lean = flat_pelvis_ ? 0 : std::clamp(std::atan2(up.z(), up.y()), -most_lean, most_lean);
  pelvis_rest_ = Rotation(Eigen::AngleAxisd(lean, Vec3::UnitX()));
  for (const bool left : {true, false}) {
    const int ankle = left ? left_ankle : right_ankle, toes = left ? left_toe_base : right_toe_base;
    const Vec3 foot = direction(joints, ankle, toes, rest_direction(toes));
    const bool stands =
        std::abs(at(joints, toes).y() - toe_rest_height_) < 0.02 && foot.y() < -0.2 && foot.y() > -0.8;
    foot_rest_[left ? 0 : 1] =
        stands ? Vec3(0, foot.y(), std::sqrt(1 - foot.y() * foot.y())) : rest_direction(toes);
  }
}

HumanoidPose JointsToHumanoid::pose(const Pose& joints, double time_s) {
  using namespace humanoid;
  static constexpr Limb left_arm = {true,
                                    {LeftShoulder, LeftUpperArm, LeftLowerArm, humanoid::LeftHand},
                                    {Thorax, left_shoulder, left_elbow, left_wrist, left_hand}};
  static constexpr Limb right_arm = {false,
                                     {RightShoulder, RightUpperArm, RightLowerArm, humanoid::RightHand},
                                     {Thorax, right_shoulder, right_elbow, right_wrist, right_hand}};
  static constexpr Limb left_leg = {true,
                                    {LeftUpperLeg, LeftLowerLeg, humanoid::LeftFoot, humanoid::LeftToes},
                                    {left_hip, left_knee, left_ankle, left_toe_base, left_toe_tip}};
  static constexpr Limb right_leg = {false,
                                     {RightUpperLeg, RightLowerLeg, humanoid::RightFoot, humanoid::RightToes},
                                     {right_hip, right_knee, right_ankle, right_toe_base, right_toe_tip}};
  if (last_time_s_ && std::abs(time_s - *last_time_s_) > longest_step_s) restart();
  if (!last_time_s_) start(joints);
  dt_s_ = last_time_s_ ? std::max(0.0, time_s - *last_time_s_) : 0;
  last_time_s_ = time_s;
  trunk(joints);
  for (const Limb* limb : {&left_arm, &right_arm}) arm(joints, *limb);
  for (const Limb* limb : {&left_leg, &right_leg}) leg(joints, *limb);
  return made_;
}

void JointsToHumanoid::place(int bone, const Vec3& position_world, const Rotation& rotation_world) {
  const auto b = static_cast<std::size_t>(bone);
  positions_[b] = position_world;
  rotations_[b] = rotation_world.normalized();
  made_.position[b] = position_world;
  made_.rotation[b] = rotations_[b];
  const int above = made_.parent(bone);
  if (above < 0) return;
  const auto a = static_cast<std::size_t>(above);
  made_.position[b] = rotations_[a].inverse() * (position_world - positions_[a]);
  made_.rotation[b] = rotations_[a].inverse() * rotations_[b];
}

void JointsToHumanoid::end(int bone, const Vec3& position_world) {
  const auto b = static_cast<std::size_t>(bone);
  made_.end[b] = rotations_[b].inverse() * (position_world - positions_[b]);
}

/// World rotation of a bone with the smallest rotation from its parent.
Rotation JointsToHumanoid::swung(int bone, const Rotation& parent, const Vec3& axis, const Vec3& towards) {
  const auto b = static_cast<std::size_t>(bone);
  const Vec3 local = parent.inverse() * towards;
  const double moved = trails_[b] ? angle_between(trails_[b]->upper, local) : 0;
  trails_[b] = Trail{local, local, local};
  const Rotation smallest = smallest_rotation(axis, local);
  return parent * twists_[b].follow(axis, local, smallest, {{smallest, 1, follow_rad_s, moved}}, dt_s_);
}

/// Rotation, in its parent's space, of the upper part of a limb.
/// @param hinge  axis about which the next bone bends, T-pose
Rotation JointsToHumanoid::bent(int bone, const Vec3& axis, const Vec3& hinge, const Trail& now) {
  const auto b = static_cast<std::size_t>(bone);
  const Rotation smallest = smallest_rotation(axis, now.upper);
  const auto plane = [&](const Vec3& normal) {
    return normal.norm() > 1e-6 ? with_plane(axis, hinge, now.upper, normal) : smallest;
  };
  const Vec3 bend = now.upper.cross(now.lower), step = now.foot.cross(now.upper);
  const double by_bend = smooth_step(no_plane, full_plane, bend.norm());
  const double by_foot = (1 - by_bend) * smooth_step(no_plane, full_plane, step.norm());
  // How far those that tell have moved on their own; sideways motion turns a plane the more the straighter
  // the limb is.
  double bend_moved = 0, step_moved = 0;
  if (trails_[b]) {
    const Rotation carried = smallest_rotation(trails_[b]->upper, now.upper);
    bend_moved = angle_between(carried * trails_[b]->lower, now.lower) / std::max(bend.norm(), full_plane);
    step_moved = angle_between(carried * trails_[b]->foot, now.foot) / std::max(step.norm(), full_plane);
  }
  trails_[b] = now;
  // Opposite to the T-pose the smallest rotation is any.
  const double sure = smooth_step(-0.9, -0.5, axis.dot(now.upper));
  const Rotation first = by_bend > 0.5 ? plane(bend) : by_foot > 0.25 ? plane(step) : smallest;
  return twists_[b].follow(axis, now.upper, first,
                           {{plane(bend), by_bend, follow_rad_s * by_bend, bend_moved},
                            {plane(step), by_foot, follow_rad_s * by_foot, step_moved},
                            {smallest, 1 - by_bend - by_foot, return_rad_s * sure, 0}},
                           dt_s_);
}

void JointsToHumanoid::trunk(const Pose& joints) {
  const Vec3 up = Vec3::UnitY();
  const Rotation hips = Rotation(pelvis_rotation(joints, flat_pelvis_)) * pelvis_rest_;
  const Rotation chest(chest_rotation(joints));
  place(humanoid::Hips, at(joints, Root), hips);
  // Between pelvis and chest the twist is shared out evenly.
  for (const auto& [bone, from, to, share] : {std::tuple{humanoid::Spine, LowerBack, UpperBack, 1.0 / 3},
                                              {humanoid::Chest, UpperBack, Thorax, 2.0 / 3}}) {
    const Rotation between = hips.slerp(share, chest);
    const Vec3 along = direction(joints, from, to, between * up);
    place(bone, at(joints, from), smallest_rotation(between * up, along) * between);
  }
  place(humanoid::UpperChest, at(joints, Thorax), chest);
  Rotation parent = chest;
  for (const auto& [bone, from, to] :
       {std::tuple{humanoid::Neck, LowerNeck, UpperNeck}, {humanoid::Head, UpperNeck, Head}}) {
    parent = swung(bone, parent, up, direction(joints, from, to, parent * up));
    place(bone, at(joints, from), parent);
  }
  end(humanoid::Head, at(joints, Head));
}

void JointsToHumanoid::arm(const Pose& joints, const Limb& limb) {
  const auto [collar, upper, lower, hand] = limb.bones;
  const double side = limb.left ? 1 : -1;
  const Vec3 axis(side, 0, 0), hinge(0, -side, 0);
  const Rotation chest = rotations_[humanoid::UpperChest];
  const Vec3 rest(side * left_shoulder_.x(), left_shoulder_.y(), 0);
  const Vec3 begin = positions_[humanoid::UpperChest] + chest * (collar_share * rest);
  const Vec3 to_shoulder = at(joints, limb.joints[1]) - begin;
  const Rotation parent = rest.norm() > 1e-6 && to_shoulder.norm() > 1e-6
                              ? swung(collar, chest, rest.normalized(), to_shoulder.normalized())
                              : chest;
  place(collar, begin, parent);
  const Vec3 along = direction(joints, limb.joints[1], limb.joints[2], parent * axis);
  const Vec3 forearm = direction(joints, limb.joints[2], limb.joints[3], along);
  const Vec3 along_local = parent.inverse() * along;
  const Rotation upper_arm =
      parent * bent(upper, axis, hinge, {along_local, parent.inverse() * forearm, along_local});
  place(upper, at(joints, limb.joints[1]), upper_arm);
  const Rotation lower_arm = upper_arm * hinged(axis, hinge, upper_arm.inverse() * forearm);
  place(lower, at(joints, limb.joints[2]), lower_arm);
  place(hand, at(joints, limb.joints[3]),
        swung(hand, lower_arm, axis, direction(joints, limb.joints[3], limb.joints[4], forearm)));
  end(hand, at(joints, limb.joints[4]));
}

void JointsToHumanoid::leg(const Pose& joints, const Limb& limb) {
  const auto [upper, lower, foot, toes] = limb.bones;
  const Vec3 axis = -Vec3::UnitY(), hinge = Vec3::UnitX();
  const Rotation hips = rotations_[humanoid::Hips];
  const Vec3 along = direction(joints, limb.joints[0], limb.joints[1], hips * axis);
  const Vec3 shank = direction(joints, limb.joints[1], limb.joints[2], along);
  const Vec3 sole = direction(joints, limb.joints[2], limb.joints[3], shank);
  const Rotation back = hips.inverse();
  const Rotation thigh = hips * bent(upper, axis, hinge, {back * along, back * shank, back * sole});
  place(upper, at(joints, limb.joints[0]), thigh);
  const Rotation lower_leg = thigh * hinged(axis, hinge, thigh.inverse() * shank);
  place(lower, at(joints, limb.joints[1]), lower_leg);
  const Rotation turned = swung(foot, lower_leg, foot_rest_[limb.left ? 0 : 1], sole);
  place(foot, at(joints, limb.joints[2]), turned);
  place(toes, at(joints, limb.joints[3]),
        swung(toes, turned, Vec3::UnitZ(),
              direction(joints, limb.joints[3], limb.joints[4], turned * Vec3::UnitZ())));
  end(toes, at(joints, limb.joints[4]));
}

}  // namespace abrazo
