#include "core/stream/humanoid/humanoid_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/rotation.hpp"

namespace abrazo {

namespace {

using Rotation = Eigen::Quaterniond;

constexpr std::array<int, 4> long_arms = {humanoid::LeftLowerArm, humanoid::LeftHand, humanoid::RightLowerArm,
                                          humanoid::RightHand};
constexpr std::array<int, 4> long_legs = {humanoid::LeftLowerLeg, humanoid::LeftFoot, humanoid::RightLowerLeg,
                                          humanoid::RightFoot};

/// A bone's average offset together with those of the bones above it that the sender does not have.
Vec3 average_offset(const HumanoidPose& pose, int bone) {
  Vec3 offset = average_bone_offset(bone);
  for (int above = humanoid_parent(bone); above >= 0 && !pose.present[static_cast<std::size_t>(above)];
       above = humanoid_parent(above))
    offset += average_bone_offset(above);
  return offset;
}

/// Size of the sender's body relative to the average one; 1 if it does not send measures.
double size_of(const HumanoidPose& pose) {
  using namespace humanoid;
  const double hips = pose.position[Hips].y();
  const double size = pose.lacks_offsets()
                          ? hips / average_bone_offset(Hips).y()
                          : (pose.position[LeftLowerLeg].norm() + pose.position[LeftFoot].norm()) / 0.8;
  return size > 0.4 && size < 1.6 ? size : 1.0;
}

Vec3 offset_of(const HumanoidPose& pose, int bone) {
  const auto b = static_cast<std::size_t>(bone);
  if (!pose.lacks_offsets()) return pose.position[b];
  const bool keeps_hips = bone == humanoid::Hips && pose.position[b].norm() > 1e-3;
  return keeps_hips ? pose.position[b] : Vec3(size_of(pose) * average_offset(pose, bone));
}

Rotation yaw_of(const Vec3& left) {
  return Rotation(Eigen::AngleAxisd(std::atan2(-left.z(), left.x()), Vec3::UnitY()));
}

/// Direction that a limb's bone has in a T-pose; nought where the sender's own offset is as good.
Vec3 t_pose_direction(int bone) {
  using namespace humanoid;
  switch (bone) {
    case LeftLowerArm:
    case LeftHand:
      return Vec3::UnitX();
    case RightLowerArm:
    case RightHand:
      return -Vec3::UnitX();
    case LeftLowerLeg:
    case LeftFoot:
    case RightLowerLeg:
    case RightFoot:
      return -Vec3::UnitY();
    default:
      return Vec3::Zero();
  }
}

}  // namespace

HumanoidPose::HumanoidPose() {
  position.fill(Vec3::Zero());
  rotation.fill(Rotation::Identity());
}

bool HumanoidPose::lacks_offsets() const {
  double sum = 0;
  for (const int bone : long_arms) sum += position[static_cast<std::size_t>(bone)].norm();
  for (const int bone : long_legs) sum += position[static_cast<std::size_t>(bone)].norm();
  return sum < 0.01;
}

int HumanoidPose::parent(int bone) const {
  int above = humanoid_parent(bone);
  while (above >= 0 && !present[static_cast<std::size_t>(above)]) above = humanoid_parent(above);
  return above;
}

HumanoidPoints::World HumanoidPoints::raw_world(const HumanoidPose& pose) const {
  World world;
  for (int bone = 0; bone < humanoid::bone_count; ++bone) {
    const auto b = static_cast<std::size_t>(bone);
    const int above = pose.parent(bone);
    const Rotation turned = above < 0 ? pose.root_rotation : world.rotation[static_cast<std::size_t>(above)];
    const Vec3 from = above < 0 ? pose.root_position : world.position[static_cast<std::size_t>(above)];
    world.position[b] = from + turned * offset_of(pose, bone);
    world.rotation[b] = turned * pose.rotation[b];
  }
  return world;
}

void HumanoidPoints::calibrate(const HumanoidPose& t_pose) {
  using namespace humanoid;
  const World raw = raw_world(t_pose);
  // Without offsets only upright hips give the facing direction; others have a rest rotation.
  const bool hips_are_upright = (raw.rotation[Hips] * Vec3::UnitY()).y() > 0.85;
  const Rotation& facing = hips_are_upright ? raw.rotation[Hips] : t_pose.root_rotation;
  const Vec3 left = t_pose.lacks_offsets() ? Vec3(facing * Vec3::UnitX())
                                           : Vec3(raw.position[LeftUpperArm] - raw.position[RightUpperArm]);
  const Rotation heading = yaw_of(left);
  Rest rest;
  PerBone<Rotation> swings;  // what a T-pose that was not quite one is put right by, per limb
  for (int bone = 0; bone < humanoid::bone_count; ++bone) {
    const auto b = static_cast<std::size_t>(bone);
    const int above = t_pose.parent(bone);
    const auto a = static_cast<std::size_t>(std::max(above, 0));
    const bool present = t_pose.present[b];
    rest.inverse[b] = !present && above >= 0 ? rest.inverse[a] : raw.rotation[b].inverse() * heading;
    const Vec3 seen =
        above < 0 ? offset_of(t_pose, bone) : Vec3(heading.inverse() * (raw.position[b] - raw.position[a]));
    const Vec3 straight = t_pose_direction(bone);
    swings[b] = above < 0 ? Rotation::Identity() : swings[a];
    if (t_pose.lacks_offsets())
      rest.offset[b] = offset_of(t_pose, bone);
    else if (straight.isZero() || seen.norm() < 1e-6)
      rest.offset[b] = swings[b] * seen;
    else {
      rest.offset[b] = straight * seen.norm();
      swings[b] = smallest_rotation(seen, straight);
    }
    if (bone == LeftFoot || bone == RightFoot) swings[b] = Rotation::Identity();  // it is on the floor
    rest.end[b] = t_pose.end[b] ? Vec3(swings[b] * (heading.inverse() * (raw.rotation[b] * *t_pose.end[b])))
                                : Vec3(size_of(t_pose) * average_end_offset(bone));
  }
  rest_ = rest;
}

HumanoidPoints::World HumanoidPoints::world(const HumanoidPose& pose) const {
  World world = raw_world(pose);
  if (!rest_) return world;
  for (int bone = 0; bone < humanoid::bone_count; ++bone) {
    const auto b = static_cast<std::size_t>(bone);
    world.rotation[b] = world.rotation[b] * rest_->inverse[b];
    const int above = pose.parent(bone);
    if (above < 0) continue;
    const auto a = static_cast<std::size_t>(above);
    world.position[b] = world.position[a] + world.rotation[a] * rest_->offset[b];
  }
  return world;
}

bool HumanoidPoints::has_upright_rest(const HumanoidPose& pose) {
  if (pose.lacks_offsets()) return true;
  return std::all_of(long_arms.begin(), long_arms.end(),
                     [&](int bone) {
                       const Vec3& offset = pose.position[static_cast<std::size_t>(bone)];
                       return offset.dot(t_pose_direction(bone)) > 0.85 * offset.norm();
                     }) &&
         std::all_of(long_legs.begin(), long_legs.end(), [&](int bone) {
           const Vec3& offset = pose.position[static_cast<std::size_t>(bone)];
           return -offset.y() > 0.85 * offset.norm();
         });
}

/// Bones whose ends are points too.
std::vector<int> HumanoidPoints::ends(const HumanoidPose& pose) const {
  using namespace humanoid;
  std::vector<int> bones;
  const bool by_rotation = rest_ || has_upright_rest(pose);
  for (const auto& [last, instead] : {std::pair{Head, Head},
                                      {LeftHand, LeftHand},
                                      {RightHand, RightHand},
                                      {LeftToes, LeftFoot},
                                      {RightToes, RightFoot}}) {
    const int bone = pose.present[last] ? last : instead;
    if (pose.present[static_cast<std::size_t>(bone)] &&
        (by_rotation || pose.end[static_cast<std::size_t>(bone)]))
      bones.push_back(bone);
  }
  return bones;
}

Vec3 HumanoidPoints::end_offset(const HumanoidPose& pose, int bone) const {
  const auto b = static_cast<std::size_t>(bone);
  if (rest_) return rest_->end[b];
  return pose.end[b] ? *pose.end[b] : Vec3(size_of(pose) * average_end_offset(bone));
}

std::shared_ptr<const std::vector<std::string>> HumanoidPoints::names(const HumanoidPose& pose) {
  std::vector<std::string> names;
  for (int bone = 0; bone < humanoid::bone_count; ++bone)
    if (pose.present[static_cast<std::size_t>(bone)]) names.push_back(humanoid_bone_name(bone));
  for (const int bone : ends(pose)) names.push_back(humanoid_bone_name(bone) + "_End");
  if (!names_ || *names_ != names)
    names_ = std::make_shared<const std::vector<std::string>>(std::move(names));
  return names_;
}

Positions HumanoidPoints::positions(const HumanoidPose& pose) const {
  const World placed = world(pose);
  const std::vector<int> last = ends(pose);
  const auto bones = std::count(pose.present.begin(), pose.present.end(), true);
  Positions points(bones + static_cast<Eigen::Index>(last.size()), 3);
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < humanoid::bone_count; ++b)
    if (pose.present[b]) points.row(row++) = placed.position[b].transpose();
  for (const int bone : last) {
    const auto b = static_cast<std::size_t>(bone);
    points.row(row++) = (placed.position[b] + placed.rotation[b] * end_offset(pose, bone)).transpose();
  }
  return points;
}

}  // namespace abrazo
