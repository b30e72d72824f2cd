#include "core/choreography/arm_swivel.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/positions.hpp"
#include "core/base/rotation.hpp"
#include "core/choreography/limb_ik.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/body/smooth_window.hpp"

namespace abrazo {
namespace {

struct ArmJoints {
  int shoulder, elbow, wrist, hand;
};
ArmJoints joints_of(Side side) {
  using namespace joints;
  return side == Side::Left ? ArmJoints{left_shoulder, left_elbow, left_wrist, left_hand}
                            : ArmJoints{right_shoulder, right_elbow, right_wrist, right_hand};
}

/// A direction normal to the limb in each frame that turns about the limb as little as possible, chest space.
std::vector<Vec3> carried_normals(const std::vector<Vec3>& limbs, const Vec3& first) {
  std::vector<Vec3> normals = {(first - first.dot(limbs[0]) * limbs[0]).normalized()};
  for (std::size_t f = 1; f < limbs.size(); ++f) {
    const Vec3 carried = smallest_rotation(limbs[f - 1], limbs[f]) * normals.back();
    normals.push_back((carried - carried.dot(limbs[f]) * limbs[f]).normalized());
  }
  return normals;
}

void smooth_wrist(const DancerBody& body, const ArmJoints& arm, int half_width, std::vector<Pose>& poses) {
  std::vector<Vec3> along;
  along.reserve(poses.size());
  for (const Pose& pose : poses)
    along.emplace_back((joint_at(pose, arm.hand) - joint_at(pose, arm.wrist)) / body.hand);
  const std::vector<Vec3> smooth = hann_mean(along, half_width);
  for (std::size_t f = 0; f < poses.size(); ++f) {
    const Vec3 hand =
        smooth[f].norm() > 0.1 ? Vec3(body.hand * smooth[f].normalized()) : Vec3(body.hand * along[f]);
    const Vec3 wrist = within_reach(joint_at(poses[f], arm.shoulder), joint_at(poses[f], arm.hand) - hand,
                                    body.upper_arm + body.forearm);
    poses[f].row(arm.wrist) = wrist.transpose();
    poses[f].row(arm.hand) = (wrist + hand).transpose();
  }
}

}  // namespace

void smooth_arm(const DancerBody& body, Side side, const std::vector<Turn>& chests, int half_width,
                std::vector<Pose>& poses) {
  if (poses.empty()) return;
  const ArmJoints arm = joints_of(side);
  smooth_wrist(body, arm, half_width, poses);
  // The elbow's angle about the line from shoulder to wrist, in the space of the chest.
  std::vector<Eigen::Matrix3d> spaces;
  std::vector<Vec3> limbs, elbows;
  for (std::size_t f = 0; f < poses.size(); ++f) {
    spaces.push_back(chests[f].matrix());
    const Vec3 shoulder = joint_at(poses[f], arm.shoulder);
    limbs.emplace_back(spaces[f].transpose() * (joint_at(poses[f], arm.wrist) - shoulder).normalized());
    elbows.emplace_back(spaces[f].transpose() * (joint_at(poses[f], arm.elbow) - shoulder));
  }
  const std::vector<Vec3> normals = carried_normals(limbs, elbows[0]);
  std::vector<double> angles;
  for (std::size_t f = 0; f < poses.size(); ++f) {
    const double angle = std::atan2(elbows[f].dot(limbs[f].cross(normals[f])), elbows[f].dot(normals[f]));
    const double before = angles.empty() ? 0 : angles.back();
    angles.push_back(before + std::remainder(angle - before, 2 * std::numbers::pi));
  }
  angles = hann_mean(angles, half_width);
  for (std::size_t f = 0; f < poses.size(); ++f) {
    const Vec3 aside = std::cos(angles[f]) * normals[f] + std::sin(angles[f]) * limbs[f].cross(normals[f]);
    poses[f].row(arm.elbow) = middle_joint(joint_at(poses[f], arm.shoulder), joint_at(poses[f], arm.wrist),
                                           body.upper_arm, body.forearm, spaces[f] * aside)
                                  .transpose();
  }
}

}  // namespace abrazo
