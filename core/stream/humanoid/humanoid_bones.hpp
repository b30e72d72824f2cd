#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/positions.hpp"

namespace abrazo {

/// Unity's humanoid bones (55). A parent always comes before its children.
namespace humanoid {
enum Bone : int {
  Hips,
  Spine,
  Chest,
  UpperChest,
  Neck,
  Head,
  Jaw,
  LeftEye,
  RightEye,
  LeftShoulder,
  LeftUpperArm,
  LeftLowerArm,
  LeftHand,
  RightShoulder,
  RightUpperArm,
  RightLowerArm,
  RightHand,
  LeftUpperLeg,
  LeftLowerLeg,
  LeftFoot,
  LeftToes,
  RightUpperLeg,
  RightLowerLeg,
  RightFoot,
  RightToes,
  FirstFinger  ///< left thumb, index, middle, ring, little, then right; three bones each
};
inline constexpr int bone_count = 55;
inline constexpr int left_thumb = FirstFinger, left_middle = FirstFinger + 6, right_thumb = FirstFinger + 15,
                     right_middle = FirstFinger + 21;

/// Bones that every humanoid has; without them there is no pose.
inline constexpr std::array<Bone, 15> required = {Hips,          Spine,         Head,          LeftUpperArm,
                                                  LeftLowerArm,  LeftHand,      RightUpperArm, RightLowerArm,
                                                  RightHand,     LeftUpperLeg,  LeftLowerLeg,  LeftFoot,
                                                  RightUpperLeg, RightLowerLeg, RightFoot};
}  // namespace humanoid

template <typename T>
using PerBone = std::array<T, humanoid::bone_count>;

/// "Hips", "LeftUpperLeg", ..., as VMC spells them.
const std::string& humanoid_bone_name(int bone);
/// By exact name. Thumbs by VRM 0's names (Proximal, Intermediate, Distal).
std::optional<int> humanoid_bone(std::string_view name);
/// -1 for the hips. Optional bones (chest, neck, shoulders, toes) are parents too, present or not.
int humanoid_parent(int bone);

/// Offset of a bone from its parent in a T-pose facing +Z, for an adult of about 1.7 m; of the hips from the
/// floor [m].
Vec3 average_bone_offset(int bone);

/// Offset of an end of a limb from its last bone: the toe tip from the toes (or the foot), the knuckles from
/// the hand, the crown from the head, T-pose [m].
Vec3 average_end_offset(int bone);

}  // namespace abrazo
