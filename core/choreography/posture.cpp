#include "core/choreography/posture.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/positions.hpp"
#include "core/choreography/limb_ik.hpp"
#include "core/choreography/smooth_track.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {
namespace {

Vec3 mirrored_to(Side side, const Vec3& left) {
  return {sign_of(side) * left.x(), left.y(), left.z()};
}

Turn turn_between(const Turn& a, const Turn& b, double share) {
  return {std::lerp(a.yaw, b.yaw, share), std::lerp(a.pitch, b.pitch, share),
          std::lerp(a.roll, b.roll, share)};
}

Vec3 facing(double yaw) {
  return {std::sin(yaw), 0, std::cos(yaw)};
}

/// Where the elbow goes, chest space: back with a hanging hand, down and back with one held out, out and
/// forward with a raised one. Far from where the arm itself may point, so that the elbow never flips over.
Vec3 elbow_pole(Side side, double hand_above_shoulder) {
  const double raised = minimum_jerk((hand_above_shoulder + 0.10) / 0.50);
  const double lowered = minimum_jerk((-0.15 - hand_above_shoulder) / 0.30);
  const Vec3 low(0.36, -0.25, -0.90), out(0.40, -0.80, -0.50), high(0.65, -0.65, 0.40);
  return mirrored_to(side, lowered * low + (1 - lowered - raised) * out + raised * high);
}

}  // namespace

Eigen::Matrix3d Turn::matrix() const {
  return (Eigen::AngleAxisd(yaw, Vec3::UnitY()) * Eigen::AngleAxisd(pitch, Vec3::UnitX()) *
          Eigen::AngleAxisd(roll, Vec3::UnitZ()))
      .toRotationMatrix();
}

void place_trunk(const DancerBody& body, const TrunkPosture& trunk, Pose& pose) {
  using namespace joints;
  const Eigen::Matrix3d pelvis = trunk.pelvis.matrix(), chest = trunk.chest.matrix();
  const auto place = [&](int joint, const Vec3& at) { pose.row(joint) = at.transpose(); };
  place(Root, trunk.root);
  place(left_hip, trunk.root + pelvis * mirrored_to(Side::Left, body.left_hip));
  place(right_hip, trunk.root + pelvis * mirrored_to(Side::Right, body.left_hip));
  const auto up = [](const Turn& turn, double length) -> Vec3 { return turn.matrix() * Vec3(0, length, 0); };
  place(LowerBack, trunk.root + up(turn_between(trunk.pelvis, trunk.chest, 0.2), body.spine[0]));
  place(UpperBack,
        joint_at(pose, LowerBack) + up(turn_between(trunk.pelvis, trunk.chest, 0.6), body.spine[1]));
  place(Thorax, joint_at(pose, UpperBack) + up(trunk.chest, body.spine[2]));
  place(LowerNeck, joint_at(pose, Thorax) + up(trunk.chest, body.neck[0]));
  place(UpperNeck, joint_at(pose, LowerNeck) + up(turn_between(trunk.chest, trunk.head, 0.5), body.neck[1]));
  place(Head, joint_at(pose, UpperNeck) + up(trunk.head, body.neck[2]));
  place(left_shoulder, joint_at(pose, Thorax) + chest * mirrored_to(Side::Left, body.left_shoulder));
  place(right_shoulder, joint_at(pose, Thorax) + chest * mirrored_to(Side::Right, body.left_shoulder));
}

Vec3 ankle_position(const DancerBody& body, const FootPosture& foot) {
  const Turn turn{.yaw = foot.yaw, .pitch = foot.heel_pitch};
  return foot.toe_base + turn.matrix() * Vec3(0, body.ankle_above_toe_base, -body.ankle_behind_toe_base);
}

void place_leg(const DancerBody& body, Side side, const FootPosture& foot, double pelvis_yaw, Pose& pose) {
  using namespace joints;
  const bool left = side == Side::Left;
  const Vec3 hip = joint_at(pose, left ? left_hip : right_hip), ankle = ankle_position(body, foot);
  const Vec3 pole = facing(0.5 * (pelvis_yaw + foot.yaw));
  const Vec3 toe_tip = foot.toe_base + Turn{foot.yaw, foot.toe_pitch, 0}.matrix() * Vec3(0, 0, body.toes);
  pose.row(left ? left_knee : right_knee) =
      middle_joint(hip, ankle, body.thigh, body.shank, pole).transpose();
  pose.row(left ? left_ankle : right_ankle) = ankle.transpose();
  pose.row(left ? left_toe_base : right_toe_base) = foot.toe_base.transpose();
  pose.row(left ? left_toe_tip : right_toe_tip) = toe_tip.transpose();
}

void place_arm(const DancerBody& body, Side side, const HandTarget& target, const Turn& chest, Pose& pose) {
  using namespace joints;
  const bool left = side == Side::Left;
  const Vec3 shoulder = joint_at(pose, left ? left_shoulder : right_shoulder);
  const Vec3 pole = chest.matrix() * elbow_pole(side, target.hand.y() - shoulder.y());
  // First with a straight wrist, to know where the forearm points; then the wrist is bent towards `pointing`.
  const double straight = body.forearm + body.hand;
  const Vec3 hand = within_reach(shoulder, target.hand, body.upper_arm + straight);
  const Vec3 guess = middle_joint(shoulder, hand, body.upper_arm, straight, pole);
  const Vec3 along = ((hand - guess) / straight + 0.5 * target.pointing).normalized();
  const Vec3 wrist = within_reach(shoulder, hand - body.hand * along, body.upper_arm + body.forearm);
  const Vec3 elbow = middle_joint(shoulder, wrist, body.upper_arm, body.forearm, pole);
  pose.row(left ? left_elbow : right_elbow) = elbow.transpose();
  pose.row(left ? left_wrist : right_wrist) = wrist.transpose();
  pose.row(left ? left_hand : right_hand) = (wrist + body.hand * along).transpose();
}

}  // namespace abrazo
