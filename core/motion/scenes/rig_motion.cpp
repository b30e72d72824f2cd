#include "core/motion/scenes/rig_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.hpp"

namespace abrazo {

namespace {

using Rotation = Eigen::Matrix3d;

Rotation rotation_of(const Eigen::Affine3d& place) {
  // Scales of characters are uniform; those that are not have no rotation to keep.
  return place.rotation();
}

/// Turns a character at rest to look along +Z.
Rotation to_front_of(const HumanoidRig& rig) {
  Vec3 left = along_floor(rig.rest("leftupperleg") - rig.rest("rightupperleg"));
  left = left.norm() > 1e-9 ? Vec3(left.normalized()) : Vec3(Vec3::UnitX());
  Rotation facing;
  facing << left, Vec3::UnitY(), left.cross(Vec3::UnitY());
  return facing.transpose();
}

}  // namespace

RigPlace place_on_rig(const HumanoidRig& rig, const Stance& stance) {
  RigPlace place{stance};
  if (stance.leg > 1e-6 && rig.leg_length() > 1e-6) place.legs = rig.leg_length() / stance.leg;
  place.path = place.legs;
  return place;
}

RigMotion::RigMotion(std::shared_ptr<const HumanoidRig> rig, const Clip& clip, const RigPlace& place)
    : rig_(std::move(rig)), place_(place), tree_(clip), to_front_(to_front_of(*rig_)) {
  rig_ankle_rest_ = std::min(rig_->rest("leftfoot").y(), rig_->rest("rightfoot").y());
  hips_ = rig_->bones.find("hips")->second;
  world_.resize(rig_->nodes.size(), Eigen::Affine3d::Identity());
  turned_of_node_.resize(rig_->nodes.size(), -1);
  tree_turns_.resize(tree_.nodes().size());
  for (const HumanoidBone& bone : humanoid_bones) {
    const auto found = rig_->bones.find(bone.name);
    if (found == rig_->bones.end() || turned_of_node_[static_cast<std::size_t>(found->second)] >= 0) continue;
    const auto turner = std::ranges::find(tree_.nodes(), bone.turner, &JointTree::Node::name);
    Rotation from_rest = from_stance(bone.name) * to_front_ * rotation_of(rig_->node(bone.name).world);
    if (!bone.next.empty()) {
      const Vec3 along = to_front_ * (rig_->rest(bone.next) - rig_->rest(bone.name));
      if (along.norm() > 1e-9)
        from_rest = swing(along.normalized(), rest_direction(turner->aims_at)) * from_rest;
    }
    turned_of_node_[static_cast<std::size_t>(found->second)] = static_cast<int>(turned_.size());
    turned_.push_back({static_cast<std::size_t>(turner - tree_.nodes().begin()), from_rest});
    turns_.push_back({found->second});
  }
  add_arm("leftupperarm", "leftlowerarm", "lefthand", joints::left_elbow, joints::left_wrist);
  add_arm("rightupperarm", "rightlowerarm", "righthand", joints::right_elbow, joints::right_wrist);
}

void RigMotion::add_arm(const char* upper, const char* lower, const char* hand, int elbow, int wrist) {
  const auto turned_of = [&](const char* bone) {
    return static_cast<std::size_t>(
        turned_of_node_[static_cast<std::size_t>(rig_->bones.find(bone)->second)]);
  };
  // From a T-pose that looks along +Z the forearm bends forwards.
  const Vec3 bend = rest_direction(elbow).cross(Vec3::UnitZ());
  arms_.push_back({turned_of(upper), turned_of(lower), elbow, wrist,
                   LimbReach((rig_->rest(lower) - rig_->rest(upper)).norm(),
                             (rig_->rest(hand) - rig_->rest(lower)).norm(), bend)});
}

/// Turns a bone at rest to where it belongs in the space of its node of the tree, which differs from the
/// rig's by the performer's stance.
Rotation RigMotion::from_stance(std::string_view bone) const {
  const Stance& stance = place_.stance;
  const auto pitched = [](double angle) { return Rotation(Eigen::AngleAxisd(angle, Vec3::UnitX())); };
  if (bone.ends_with("foot") || bone.ends_with("toes")) {
    const double drop = std::clamp((stance.ankle - stance.toe_base) / std::max(stance.foot, 1e-6), 0.0, 0.95);
    const Vec3 standing(0, -drop, std::sqrt(1 - drop * drop));
    return bone.ends_with("foot") ? swing(standing, rest_direction(joints::left_toe_base))
                                  : Rotation(Rotation::Identity());
  }
  const Vec3 trunk = 0.5 * (rig_->rest("leftupperarm") + rig_->rest("rightupperarm") -
                            rig_->rest("leftupperleg") - rig_->rest("rightupperleg"));
  const double lean = stance.lean - pitch_of(to_front_ * trunk, Vec3::UnitX());
  if (bone == "hips") return pitched(lean - stance.pitch[Stance::Pelvis]);
  if (bone == "spine") return pitched(lean - stance.pitch[Stance::LowerBack]);
  if (bone == "chest" || bone == "upperchest") return pitched(lean - stance.pitch[Stance::Chest]);
  if (bone == "neck") return pitched(-stance.pitch[Stance::Neck]);
  if (bone == "head") return pitched(-stance.pitch[Stance::Head]);
  const bool left = bone == "leftshoulder";
  if (!left && bone != "rightshoulder") return Rotation::Identity();
  const Vec3 out =
      Vec3(left ? stance.shoulder.x() : -stance.shoulder.x(), stance.shoulder.y(), stance.shoulder.z());
  return swing(out, left ? Vec3(Vec3::UnitX()) : Vec3(-Vec3::UnitX())) *
         pitched(lean - stance.pitch[Stance::Chest]);
}

Eigen::Affine3d RigMotion::parent_of(const RigNode& node) const {
  return node.parent < 0 ? Eigen::Affine3d::Identity() : world_[static_cast<std::size_t>(node.parent)];
}

/// Where the hips bone stands, so that the middle of the legs follows the performer's.
Vec3 RigMotion::hips_goal(const Pose& pose) const {
  const Vec3 between = 0.5 * (joint_at(pose, joints::left_hip) + joint_at(pose, joints::right_hip));
  const Vec3 goal = place_.path * along_floor(between) +
                    Vec3::UnitY() * (rig_ankle_rest_ + place_.legs * (between.y() - place_.stance.ankle));
  const Vec3 rest_between = 0.5 * (rig_->rest("leftupperleg") + rig_->rest("rightupperleg"));
  const Turned& hips = turned_[static_cast<std::size_t>(turned_of_node_[static_cast<std::size_t>(hips_)])];
  return goal -
         tree_turns_[hips.turner] * from_stance("hips") * to_front_ * (rest_between - rig_->rest("hips"));
}

void RigMotion::bring_wrist(Arm& arm, const Pose& pose, const Vec3& shoulder) {
  Turned &upper = turned_[arm.upper], &lower = turned_[arm.lower];
  const auto direction = [&](const Turned& bone) {
    return Vec3(tree_turns_[bone.turner] * rest_direction(tree_.nodes()[bone.turner].aims_at));
  };
  const LimbReach::Correction by =
      arm.reach.bring(direction(upper), direction(lower), tree_turns_[upper.turner],
                      place_.path * joint_at(pose, arm.wrist) - shoulder);
  upper.goal = by.upper * upper.goal;
  lower.goal = by.lower * lower.goal;
}

void RigMotion::set_pose(const Pose& pose, double dt_s) {
  tree_.rotations(pose, dt_s, tree_turns_);
  for (Turned& bone : turned_) bone.goal = tree_turns_[bone.turner] * bone.from_rest;
  for (const int n : rig_->order) {
    const auto at = static_cast<std::size_t>(n);
    const RigNode& node = rig_->nodes[at];
    const Eigen::Affine3d parent = parent_of(node);
    if (turned_of_node_[at] < 0) {
      world_[at] = parent * node.local;
      continue;
    }
    const auto turned = static_cast<std::size_t>(turned_of_node_[at]);
    Vec3 translation = node.local.translation();
    if (n == hips_) translation = hips_translation_ = parent.inverse() * hips_goal(pose);
    for (Arm& arm : arms_)
      if (arm.upper == turned) bring_wrist(arm, pose, parent * translation);
    const Eigen::Quaterniond local(Rotation(rotation_of(parent).transpose() * turned_[turned].goal));
    turns_[turned].local = local.normalized();
    world_[at] = parent * Eigen::Translation3d(translation) * turns_[turned].local *
                 Eigen::Scaling(Vec3(node.local.linear().colwise().norm()));
  }
}

std::vector<RigMotion> rig_motions(const std::shared_ptr<const HumanoidRig>& rig,
                                   std::span<const Clip> clips) {
  std::vector<RigPlace> places;
  double path = 0;
  for (const Clip& clip : clips) {
    places.push_back(place_on_rig(*rig, stance_of(clip.poses)));
    path += places.back().path / static_cast<double>(clips.size());
  }
  std::vector<RigMotion> motions;
  for (std::size_t c = 0; c < clips.size(); ++c) {
    places[c].path = path;
    motions.emplace_back(rig, clips[c], places[c]);
  }
  return motions;
}

}  // namespace abrazo
