#include "core/motion/scenes/stance.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/base/statistics.hpp"
#include "core/motion/body/joint_tree.hpp"

namespace abrazo {

namespace {

constexpr std::array<std::string_view, Stance::PartCount> part_nodes = {"root", "lowerback", "thorax",
                                                                        "lowerneck", "upperneck"};

double median(std::vector<double>& values) {
  return percentile(values, 0.5);
}

/// The posture of the trunk, of poses that are upright.
void measure_trunk(std::span<const Pose> poses, Stance& stance) {
  Clip clip;
  const std::size_t stride = std::max<std::size_t>(1, poses.size() / 400);
  for (std::size_t i = 0; i < poses.size(); i += stride) clip.poses.push_back(poses[i]);
  JointTree tree(clip);
  std::array<std::size_t, Stance::PartCount> nodes{};
  for (std::size_t part = 0; part < nodes.size(); ++part)
    nodes[part] = static_cast<std::size_t>(
        std::ranges::find(tree.nodes(), part_nodes[part], &JointTree::Node::name) - tree.nodes().begin());
  std::array<std::vector<double>, Stance::PartCount> pitches;
  std::array<std::vector<double>, 3> shoulders;
  std::vector<double> leans;
  std::vector<Eigen::Matrix3d> turns;
  for (const Pose& pose : clip.poses) {
    const auto middle = [&](int a, int b) { return Vec3(0.5 * (joint_at(pose, a) + joint_at(pose, b))); };
    const Vec3 trunk =
        middle(joints::left_shoulder, joints::right_shoulder) - middle(joints::left_hip, joints::right_hip);
    if (trunk.y() < 0.8 * trunk.norm()) continue;
    tree.rotations(pose, 1, turns);
    const Vec3 left = joint_at(pose, joints::left_hip) - joint_at(pose, joints::right_hip);
    leans.push_back(pitch_of(trunk, left));
    for (std::size_t part = 0; part < nodes.size(); ++part)
      pitches[part].push_back(pitch_of(turns[nodes[part]].col(1), left));
    const Eigen::Matrix3d chest = chest_rotation(pose).transpose();
    for (const auto& [joint, side] :
         {std::pair{joints::left_shoulder, 1.0}, std::pair{joints::right_shoulder, -1.0}}) {
      const Vec3 out = chest * (joint_at(pose, joint) - joint_at(pose, joints::Thorax)).normalized();
      shoulders[0].push_back(side * out.x());
      shoulders[1].push_back(out.y());
      shoulders[2].push_back(out.z());
    }
  }
  if (leans.empty()) return;
  stance.lean = median(leans);
  for (std::size_t part = 0; part < nodes.size(); ++part) stance.pitch[part] = median(pitches[part]);
  const Vec3 shoulder(median(shoulders[0]), median(shoulders[1]), median(shoulders[2]));
  if (shoulder.x() > 0.1) stance.shoulder = shoulder.normalized();
}

}  // namespace

Stance Stance::with_legs(double length) const {
  Stance other = *this;
  const double by = leg > 1e-6 ? length / leg : 1;
  for (double* own : {&other.leg, &other.foot, &other.ankle, &other.toe_base}) *own *= by;
  return other;
}

double pitch_of(const Vec3& direction, const Vec3& left) {
  const Vec3 ahead = along_floor(left).cross(Vec3::UnitY());
  return ahead.norm() > 1e-9 ? std::atan2(direction.dot(ahead.normalized()), direction.y()) : 0;
}

Stance stance_of(std::span<const Pose> poses) {
  Stance stance;
  if (poses.empty()) return stance;
  const Body body = body_of(poses);
  const auto length = [&](int joint) { return body.bone_lengths[static_cast<std::size_t>(joint - 1)]; };
  std::vector<double> ankles;
  for (const Pose& pose : poses)
    ankles.push_back(std::min(pose(joints::left_ankle, 1), pose(joints::right_ankle, 1)));
  stance.leg = body.leg_length();
  stance.foot = 0.5 * (length(joints::left_toe_base) + length(joints::right_toe_base));
  stance.ankle = percentile(ankles, 0.05);
  stance.toe_base = body.toe_rest_height;
  measure_trunk(poses, stance);
  return stance;
}

}  // namespace abrazo
