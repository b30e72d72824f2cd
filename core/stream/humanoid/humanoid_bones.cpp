#include "core/stream/humanoid/humanoid_bones.hpp"

#include <functional>
#include <map>

namespace abrazo {

namespace {

PerBone<std::string> all_names() {
  using namespace humanoid;
  PerBone<std::string> names = {
      "Hips",          "Spine",         "Chest",         "UpperChest",    "Neck",
      "Head",          "Jaw",           "LeftEye",       "RightEye",      "LeftShoulder",
      "LeftUpperArm",  "LeftLowerArm",  "LeftHand",      "RightShoulder", "RightUpperArm",
      "RightLowerArm", "RightHand",     "LeftUpperLeg",  "LeftLowerLeg",  "LeftFoot",
      "LeftToes",      "RightUpperLeg", "RightLowerLeg", "RightFoot",     "RightToes"};
  std::size_t bone = FirstFinger;
  for (const char* side : {"Left", "Right"})
    for (const char* finger : {"Thumb", "Index", "Middle", "Ring", "Little"})
      for (const char* part : {"Proximal", "Intermediate", "Distal"})
        names[bone++] = std::string(side) + finger + part;
  return names;
}

bool is_left_side(int bone) {
  using namespace humanoid;
  return bone >= FirstFinger ? bone < right_thumb
                             : (bone >= LeftShoulder && bone <= LeftHand) || bone == LeftEye ||
                                   (bone >= LeftUpperLeg && bone <= LeftToes);
}

/// Of the left side; the right side's is its mirror image.
Vec3 left_finger_offset(int bone) {
  using namespace humanoid;
  const int finger = (bone - FirstFinger) % 15 / 3, part = (bone - FirstFinger) % 3;
  if (part > 0) return {0.03, 0, 0};
  constexpr std::array<double, 5> along = {0.03, 0.09, 0.09, 0.085, 0.08},
                                  forward = {0.03, 0.025, 0, -0.02, -0.04};
  const auto f = static_cast<std::size_t>(finger);
  return {along[f], 0, forward[f]};
}

Vec3 left_offset(int bone) {
  using namespace humanoid;
  switch (bone) {
    case Hips:
      return {0, 0.95, 0};
    case Spine:
      return {0, 0.10, 0};
    case Chest:
    case UpperChest:
    case Neck:
      return {0, 0.12, 0};
    case Head:
      return {0, 0.09, 0.01};
    case Jaw:
      return {0, 0.02, 0.03};
    case LeftEye:
    case RightEye:
      return {0.03, 0.08, 0.08};
    case LeftShoulder:
    case RightShoulder:
      return {0.03, 0.08, 0};
    case LeftUpperArm:
    case RightUpperArm:
      return {0.13, 0, 0};
    case LeftLowerArm:
    case RightLowerArm:
      return {0.27, 0, 0};
    case LeftHand:
    case RightHand:
      return {0.25, 0, 0};
    case LeftUpperLeg:
    case RightUpperLeg:
      return {0.09, -0.07, 0};
    case LeftLowerLeg:
    case RightLowerLeg:
    case LeftFoot:
    case RightFoot:
      return {0, -0.40, 0};
    case LeftToes:
    case RightToes:
      return {0, -0.05, 0.13};
    default:
      return left_finger_offset(bone);
  }
}

Vec3 sided(int bone, Vec3 left) {
  if (!is_left_side(bone)) left.x() = -left.x();
  return left;
}

}  // namespace

const std::string& humanoid_bone_name(int bone) {
  static const PerBone<std::string> names = all_names();
  return names.at(static_cast<std::size_t>(bone));
}

std::optional<int> humanoid_bone(std::string_view name) {
  static const auto by_name = [] {
    std::map<std::string, int, std::less<>> bones;
    for (int bone = 0; bone < humanoid::bone_count; ++bone) bones.emplace(humanoid_bone_name(bone), bone);
    return bones;
  }();
  const auto found = by_name.find(name);
  return found == by_name.end() ? std::nullopt : std::optional<int>(found->second);
}

int humanoid_parent(int bone) {
  using namespace humanoid;
  switch (bone) {
    case Hips:
      return -1;
    case Jaw:
    case LeftEye:
    case RightEye:
      return Head;
    case LeftShoulder:
    case RightShoulder:
      return UpperChest;
    case LeftUpperLeg:
    case RightUpperLeg:
      return Hips;
    default:
      if (bone < FirstFinger || (bone - FirstFinger) % 3 > 0) return bone - 1;
      return bone < right_thumb ? LeftHand : RightHand;
  }
}

Vec3 average_bone_offset(int bone) {
  return sided(bone, left_offset(bone));
}

Vec3 average_end_offset(int bone) {
  using namespace humanoid;
  switch (bone) {
    case LeftToes:
    case RightToes:
      return {0, 0, 0.06};
    case LeftFoot:
    case RightFoot:
      return {0, -0.06, 0.19};
    case LeftHand:
    case RightHand:
      return sided(bone, {0.09, 0, 0});
    case Head:
      return {0, 0.17, 0};
    default:
      return Vec3::Zero();
  }
}

}  // namespace abrazo
