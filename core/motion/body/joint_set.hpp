#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/positions.hpp"

namespace abrazo {

/// The 25 joints of every body, in the order of docs/guide/index.md. A name is that of the CMU bone that ends
/// there, so `LeftFemur` is the left knee; the aliases in `joints::` give the anatomical names.
namespace joints {
enum Index : int {
  Root,
  LeftHipJoint,
  LeftFemur,
  LeftTibia,
  LeftFoot,
  LeftToes,
  RightHipJoint,
  RightFemur,
  RightTibia,
  RightFoot,
  RightToes,
  LowerBack,
  UpperBack,
  Thorax,
  LowerNeck,
  UpperNeck,
  Head,
  LeftClavicle,
  LeftHumerus,
  LeftWrist,
  LeftHand,
  RightClavicle,
  RightHumerus,
  RightWrist,
  RightHand
};
inline constexpr int left_hip = LeftHipJoint, left_knee = LeftFemur, left_ankle = LeftTibia,
                     left_toe_base = LeftFoot, left_toe_tip = LeftToes, right_hip = RightHipJoint,
                     right_knee = RightFemur, right_ankle = RightTibia, right_toe_base = RightFoot,
                     right_toe_tip = RightToes, left_shoulder = LeftClavicle, left_elbow = LeftHumerus,
                     left_wrist = LeftWrist, left_hand = LeftHand, right_shoulder = RightClavicle,
                     right_elbow = RightHumerus, right_wrist = RightWrist, right_hand = RightHand;
}  // namespace joints

/// "root", "lhipjoint", ... as in files.
inline constexpr std::array<std::string_view, joint_count> joint_names = {
    "root",      "lhipjoint", "lfemur", "ltibia",    "lfoot",     "ltoes",     "rhipjoint",
    "rfemur",    "rtibia",    "rfoot",  "rtoes",     "lowerback", "upperback", "thorax",
    "lowerneck", "upperneck", "head",   "lclavicle", "lhumerus",  "lwrist",    "lhand",
    "rclavicle", "rhumerus",  "rwrist", "rhand"};

/// Parent of each joint; -1 for the root. A parent always comes before its children.
inline constexpr std::array<int, joint_count> joint_parents = {
    -1, 0, 1, 2, 3, 4, 0, 6, 7, 8, 9, 0, 11, 12, 13, 14, 15, 13, 17, 18, 19, 13, 21, 22, 23};

inline constexpr int bone_count = joint_count - 1;

/// Bone b runs from `joint_parents[b + 1]` to joint b + 1.
inline constexpr std::pair<int, int> bone(int b) {
  return {joint_parents[static_cast<std::size_t>(b + 1)], b + 1};
}

/// Distances as rigid as bones, but not spanned by one: pelvis and shoulder girdle.
inline constexpr std::array<std::pair<int, int>, 4> pseudo_bones = {
    {{joints::LeftHipJoint, joints::RightHipJoint},
     {joints::LeftClavicle, joints::RightClavicle},
     {joints::LeftClavicle, joints::LowerNeck},
     {joints::RightClavicle, joints::LowerNeck}}};

/// Joints of the 15-D feature: head, right hand, left hand, right foot, left foot (paper 3.2.2).
inline constexpr std::array<int, 5> feature_joints = {joints::Head, joints::RightHand, joints::LeftHand,
                                                      joints::RightFoot, joints::LeftFoot};

std::optional<int> joint_index(std::string_view name);

/// The joint on the other side of the body, or the joint itself.
int mirrored_joint(int joint);

}  // namespace abrazo
