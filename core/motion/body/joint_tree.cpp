#include "core/motion/body/joint_tree.hpp"

#include <cmath>

#include "core/base/positions.hpp"
#include "core/base/rotation.hpp"
#include "core/base/statistics.hpp"

namespace abrazo {

namespace {

using Rotation = Eigen::Matrix3d;
using namespace joints;

}  // namespace

JointTree::JointTree(const Clip& clip) : body_(body_of(clip.poses)) {
  std::vector<double> heights;
  for (const Pose& pose : clip.poses)
    heights.push_back(
        (joint_at(pose, Root) - 0.5 * (joint_at(pose, left_hip) + joint_at(pose, right_hip))).norm());
  flat_pelvis_ = percentile(heights, 0.5) < 0.01;
  const auto hip_offset = [&](int hip) {
    Vec3 offset;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      for (const Pose& pose : clip.poses)
        values.push_back((pelvis_rotation(pose, flat_pelvis_).transpose() *
                          (joint_at(pose, hip) - joint_at(pose, Root)))[axis]);
      offset[axis] = percentile(values, 0.5);
    }
    return offset;
  };
  const int root = add("root", Root, -1, Vec3::Zero());
  for (const bool left : {true, false}) {
    const int hip = add(left ? "lhipjoint" : "rhipjoint", left ? left_hip : right_hip, root,
                        hip_offset(left ? left_hip : right_hip));
    add_limb(hip,
             left ? std::vector<int>{LeftFemur, LeftTibia, LeftFoot, LeftToes}
                  : std::vector<int>{RightFemur, RightTibia, RightFoot, RightToes},
             "");
  }
  add_limb(root, {LowerBack, UpperBack, Thorax}, "root_spine");
  const int thorax = static_cast<int>(nodes_.size()) - 1;
  add_limb(thorax, {LowerNeck, UpperNeck, Head}, "thorax_neck");
  add_limb(thorax, {LeftClavicle, LeftHumerus, LeftWrist, LeftHand}, "thorax_left");
  add_limb(thorax, {RightClavicle, RightHumerus, RightWrist, RightHand}, "thorax_right");
  bones_.resize(nodes_.size());
  places_.resize(nodes_.size());
}

int JointTree::add(std::string name, int joint, int parent, const Vec3& offset) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back(Node{std::move(name), joint, parent, -1, offset, {}});
  if (parent >= 0) nodes_[static_cast<std::size_t>(parent)].children.push_back(index);
  return index;
}

/// Hangs a chain of joints below `parent`, each aimed at by the node before it.
void JointTree::add_limb(int parent, const std::vector<int>& joints, const std::string& helper) {
  if (!helper.empty())
    parent = add(helper, nodes_[static_cast<std::size_t>(parent)].joint, parent, Vec3::Zero());
  for (const int joint : joints) {
    nodes_[static_cast<std::size_t>(parent)].aims_at = joint;
    const Vec3 offset = rest_direction(joint) * body_.bone_lengths[static_cast<std::size_t>(joint - 1)];
    parent = add(std::string(joint_names[static_cast<std::size_t>(joint)]), joint, parent, offset);
  }
}

/// The smallest rotation from the rest direction. It is not defined for a bone that points the other way, and
/// turns quickly about the bone near there; the twist that a moving bone carries along is then kept.
Rotation JointTree::aimed(Bone& bone, const Vec3& rest, const Vec3& towards, double dt_s) const {
  if (towards.norm() < 1e-9) return Rotation::Identity();
  const Vec3 direction = towards.normalized();
  const double moved_rad = std::atan2(bone.direction.cross(direction).norm(), bone.direction.dot(direction));
  bone.direction = direction;
  const auto smallest = smallest_rotation(rest, direction);
  return bone.twist.follow(rest, direction, smallest, {{.rotation = smallest, .motion_rad = moved_rad}}, dt_s)
      .toRotationMatrix();
}

void JointTree::rotations(const Pose& pose, double dt_s, std::vector<Rotation>& world) {
  world.resize(nodes_.size());
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Node& node = nodes_[n];
    if (node.parent < 0) {
      places_[n] = joint_at(pose, Root);
      world[n] = pelvis_rotation(pose, flat_pelvis_);
      continue;
    }
    const auto parent = static_cast<std::size_t>(node.parent);
    places_[n] = places_[parent] + world[parent] * node.offset;
    world[n] = world[parent];
    if (node.aims_at >= 0) {
      const Vec3 towards = world[parent].transpose() * (joint_at(pose, node.aims_at) - places_[n]);
      world[n] = world[parent] * aimed(bones_[n], rest_direction(node.aims_at), towards, dt_s);
    } else if (node.joint == Thorax) {
      world[n] = chest_rotation(pose);
    }
  }
}

}  // namespace abrazo
