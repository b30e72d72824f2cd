#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/motion/body/body_proportions.hpp"
#include "core/motion/joints/joint_map.hpp"

namespace abrazo {

namespace {

using Rules = std::vector<JointRule>;

JointRule at(std::string point) {
  return JointRule{{{std::move(point), 1.0}}};
}

/// Between two points, or beyond `to` when fraction > 1.
JointRule along(const std::string& from, const std::string& to, double fraction) {
  return JointRule{{{from, 1.0 - fraction}, {to, fraction}}};
}

void set(JointMap& map, int joint, Rules rules) {
  map.rules[static_cast<std::size_t>(joint)] = std::move(rules);
}

/// Sets a left joint and its mirror image; "%" in a point name stands for the side ("Left" or "Right").
void set_both(JointMap& map, int left_joint, const Rules& rules, const std::string& left,
              const std::string& right) {
  for (const bool is_left : {true, false}) {
    Rules sided = rules;
    for (JointRule& rule : sided)
      for (JointRule::Term& term : rule.terms)
        if (const auto mark = term.point.find('%'); mark != std::string::npos)
          term.point.replace(mark, 1, is_left ? left : right);
    set(map, is_left ? left_joint : mirrored_joint(left_joint), std::move(sided));
  }
}

void set_both(JointMap& map, int left_joint, const Rules& rules) {
  set_both(map, left_joint, rules, "Left", "Right");
}

// Extension of limbs beyond the last point of a file without toe tip or hand end, as fractions of the
// previous part, for an average adult.
constexpr double head_beyond_neck = 2.2;
constexpr double knuckles_in_hand = 0.5;  // from the wrist to the finger tips

JointMap cmu() {
  JointMap map{"cmu", {}};
  for (int j = 0; j < joint_count; ++j)
    set(map, j, {at(std::string(joint_names[static_cast<std::size_t>(j)]))});
  return map;
}

/// The CMU takes as MotionBuilder-friendly BVH: a BVH joint sits where the ASF bone of the same limb begins.
JointMap cmu_bvh() {
  using namespace joints;
  JointMap map{"cmu-bvh", {}};
  set(map, Root, {at("Hips")});
  set_both(map, LeftHipJoint, {at("%UpLeg")});
  set_both(map, LeftFemur, {at("%Leg")});
  set_both(map, LeftTibia, {at("%Foot")});
  set_both(map, LeftFoot, {at("%ToeBase")});
  set_both(map, LeftToes, {at("%ToeBase_End"), along("%Foot", "%ToeBase", toe_tip_beyond_foot)});
  set(map, LowerBack, {at("Spine")});
  set(map, UpperBack, {at("Spine1")});
  set(map, Thorax, {at("Neck")});
  set(map, LowerNeck, {at("Neck1")});
  set(map, UpperNeck, {at("Head")});
  set(map, Head, {at("Head_End"), along("Neck1", "Head", head_beyond_neck)});
  // LowerBack sits at the hips and LHipJoint too; they are what tells this skeleton from others with the same
  // names.
  map.rules[Root].front().terms = {{"Hips", 1.0}, {"LowerBack", 0.0}, {"LHipJoint", 0.0}};
  set_both(map, LeftClavicle, {at("%Arm")});
  set_both(map, LeftHumerus, {at("%ForeArm")});
  set_both(map, LeftWrist, {at("%FingerBase"), at("%Hand")});
  set_both(map, LeftHand, {at("%HandIndex1"), along("%ForeArm", "%Hand", hand_beyond_forearm)});
  return map;
}

/// What the skeletons of Mixamo and LAFAN1 have in common.
JointMap three_part_spine(std::string name, const Rules& toe_base, const Rules& toe_tip, const Rules& head) {
  using namespace joints;
  JointMap map{std::move(name), {}};
  set(map, Root, {at("Hips")});
  set_both(map, LeftHipJoint, {at("%UpLeg")});
  set_both(map, LeftFemur, {at("%Leg")});
  set_both(map, LeftTibia, {at("%Foot")});
  set_both(map, LeftFoot, toe_base);
  set_both(map, LeftToes, toe_tip);
  set(map, LowerBack, {at("Spine")});
  set(map, UpperBack, {at("Spine1")});
  set(map, Thorax, {at("Spine2")});
  set(map, LowerNeck, {at("Neck")});
  set(map, UpperNeck, {at("Head")});
  set(map, Head, head);
  set_both(map, LeftClavicle, {at("%Arm")});
  set_both(map, LeftHumerus, {at("%ForeArm")});
  set_both(map, LeftWrist, {at("%Hand")});
  set_both(map, LeftHand,
           {at("%HandMiddle1"), at("%HandIndex1"), at("%Hand_End"),
            along("%ForeArm", "%Hand", hand_beyond_forearm)});
  return map;
}

JointMap mixamo() {
  // The head's end is the crown; the head joint of the 25 is the middle of the head.
  return three_part_spine(
      "mixamo", {at("%ToeBase")},
      {at("%Toe_End"), at("%ToeBase_End"), along("%Foot", "%ToeBase", toe_tip_beyond_foot)},
      {along("Head", "HeadTop_End", 0.6), along("Neck", "Head", head_beyond_neck)});
}

JointMap lafan() {
  return three_part_spine("lafan", {at("%Toe")},
                          {at("%Toe_End"), along("%Foot", "%Toe", toe_tip_beyond_foot)},
                          {along("Head", "Head_End", 0.6), along("Neck", "Head", head_beyond_neck)});
}

/// Unity's humanoid bones, as VMC sends them. Chest, UpperChest, Neck, shoulders, toes and fingers are
/// optional there.
JointMap unity() {
  using namespace joints;
  const auto shoulders_and = [](const std::string& point, double weight) {
    const double half = (1.0 - weight) / 2;
    return JointRule{{{point, weight}, {"LeftUpperArm", half}, {"RightUpperArm", half}}};
  };
  JointMap map{"unity", {}};
  set(map, Root, {at("Hips")});
  set_both(map, LeftHipJoint, {at("%UpperLeg")});
  set_both(map, LeftFemur, {at("%LowerLeg")});
  set_both(map, LeftTibia, {at("%Foot")});
  // Without toes the foot's direction is unknown: the toe base is put below the ankle, which at least finds
  // the floor.
  set_both(map, LeftFoot, {at("%Toes"), along("%Foot", "%Foot_End", 0.7), along("%LowerLeg", "%Foot", 1.15)});
  set_both(map, LeftToes,
           {at("%Toes_End"), along("%Foot", "%Toes", toe_tip_beyond_foot), at("%Foot_End"),
            along("%LowerLeg", "%Foot", 1.2)});
  set(map, LowerBack, {at("Spine")});
  set(map, UpperBack, {at("Chest"), along("Spine", "Neck", 0.3), shoulders_and("Spine", 0.7)});
  set(map, Thorax,
      {at("UpperChest"), along("Chest", "Neck", 0.5), shoulders_and("Chest", 0.5),
       along("Spine", "Neck", 0.6), shoulders_and("Spine", 0.4)});
  set(map, LowerNeck, {at("Neck"), shoulders_and("Head", 0.2)});
  set(map, UpperNeck, {at("Head")});
  // The head's end is the crown; the head joint of the 25 is the middle of the head.
  set(map, Head,
      {along("Head", "Head_End", 0.6), along("Neck", "Head", head_beyond_neck), along("Hips", "Head", 1.2)});
  set_both(map, LeftClavicle, {at("%UpperArm")});
  set_both(map, LeftHumerus, {at("%LowerArm")});
  set_both(map, LeftWrist, {at("%Hand")});
  set_both(map, LeftHand,
           {at("%MiddleProximal"), at("%IndexProximal"), at("%Hand_End"),
            along("%LowerArm", "%Hand", hand_beyond_forearm)});
  return map;
}

/// Xsens MVN: segment names of the stream first, joint names of its BVH export second.
JointMap xsens() {
  using namespace joints;
  JointMap map{"xsens", {}};
  set(map, Root, {at("Pelvis"), at("Hips")});
  set_both(map, LeftHipJoint, {at("%UpperLeg"), at("%Hip")});
  set_both(map, LeftFemur, {at("%LowerLeg"), at("%Knee")});
  set_both(map, LeftTibia, {at("%Foot"), at("%Ankle")});
  set_both(map, LeftFoot, {at("%Toe")});
  set_both(map, LeftToes,
           {at("%Toe_End"), along("%Foot", "%Toe", toe_tip_beyond_foot),
            along("%Ankle", "%Toe", toe_tip_beyond_foot)});
  set(map, LowerBack, {at("L3"), at("Chest2")});
  set(map, UpperBack, {at("T12"), at("Chest3")});
  set(map, Thorax, {at("T8"), at("Chest4")});
  set(map, LowerNeck, {at("Neck")});
  set(map, UpperNeck, {at("Head")});
  set(map, Head, {along("Head", "Head_End", 0.6), along("Neck", "Head", head_beyond_neck)});
  set_both(map, LeftClavicle, {at("%UpperArm"), at("%Shoulder")});
  set_both(map, LeftHumerus, {at("%Forearm"), at("%Elbow")});
  set_both(map, LeftWrist, {at("%Hand"), at("%Wrist")});
  set_both(map, LeftHand,
           {along("%Hand", "%Hand_End", knuckles_in_hand), along("%Forearm", "%Hand", hand_beyond_forearm),
            at("%Wrist_End"), along("%Elbow", "%Wrist", hand_beyond_forearm)});
  return map;
}

/// OptiTrack Motive's skeletons, as NatNet streams them, in any of its conventions of bone names: Motive,
/// FBX, BVH, Unreal. "_End" points are what the stream's reader adds.
JointMap motive() {
  using namespace joints;
  JointMap map{"motive", {}};
  set(map, Root, {at("Hip"), at("Hips"), at("pelvis")});
  // "Chest" is the upper of two bones in Motive's convention and the lower in BVH's, which has "Chest2" too.
  set(map, LowerBack, {at("Ab"), at("Spine"), at("Chest"), at("spine_01")});
  set(map, UpperBack, {at("Chest2"), at("Spine1"), at("Chest"), at("spine_02")});
  set(map, Thorax,
      {along("Chest2", "Neck", 0.5), along("Spine1", "Neck", 0.5), along("Chest", "Neck", 0.5),
       along("spine_02", "neck_01", 0.5)});
  set(map, LowerNeck, {at("Neck"), at("neck_01")});
  set(map, UpperNeck, {at("Head")});
  set(map, Head,
      {along("Head", "Head_End", 0.6), along("Neck", "Head", head_beyond_neck),
       along("neck_01", "Head", head_beyond_neck)});
  struct Side {
    std::string letter, word, suffix;
  };
  for (const Side& side : {Side{"L", "Left", "_l"}, Side{"R", "Right", "_r"}}) {
    // By convention, in the order of the comment above.
    const auto names = [&](const char* motive, const char* fbx, const char* bvh, const char* unreal) {
      return std::array{side.letter + motive, side.word + fbx, side.word + bvh, unreal + side.suffix};
    };
    const auto place = [&](int left_joint, const auto& points) {
      Rules rules;
      for (const std::string& point : points) rules.push_back(at(point));
      set(map, side.letter == "L" ? left_joint : mirrored_joint(left_joint), std::move(rules));
    };
    const auto forearms = names("FArm", "ForeArm", "Elbow", "lowerarm");
    const auto hands = names("Hand", "Hand", "Wrist", "hand");
    const auto feet = names("Foot", "Foot", "Ankle", "foot");
    const auto toes = names("Toe", "ToeBase", "Toe", "ball");
    place(LeftHipJoint, names("Thigh", "UpLeg", "Hip", "thigh"));
    place(LeftFemur, names("Shin", "Leg", "Knee", "calf"));
    place(LeftTibia, feet);
    place(LeftFoot, toes);
    place(LeftClavicle, names("UArm", "Arm", "Shoulder", "upperarm"));
    place(LeftHumerus, forearms);
    place(LeftWrist, hands);
    Rules hand, toe_tip;
    for (std::size_t n = 0; n < hands.size(); ++n) {
      hand.push_back(along(hands[n], hands[n] + "_End", knuckles_in_hand));
      toe_tip.push_back(at(toes[n] + "_End"));
    }
    hand.push_back(at(side.word + "HandMiddle1"));
    for (std::size_t n = 0; n < hands.size(); ++n) {
      hand.push_back(along(forearms[n], hands[n], hand_beyond_forearm));
      toe_tip.push_back(along(feet[n], toes[n], toe_tip_beyond_foot));
    }
    set(map, side.letter == "L" ? LeftHand : RightHand, std::move(hand));
    set(map, side.letter == "L" ? LeftToes : RightToes, std::move(toe_tip));
  }
  return map;
}

/// SMPL and its kin, whose joints are called L_Hip or left_hip; the foot's joint is the ball of the foot.
JointMap smpl() {
  using namespace joints;
  JointMap map{"smpl", {}};
  const auto both = [&](int left_joint, const std::vector<std::string>& names) {
    for (const auto& [joint, shorter, longer] :
         {std::tuple(left_joint, "L_", "left_"), std::tuple(mirrored_joint(left_joint), "R_", "right_")}) {
      Rules rules;
      for (const std::string& name : names) rules.push_back(at(shorter + name));
      for (const std::string& name : names) rules.push_back(at(longer + name));
      set(map, joint, std::move(rules));
    }
  };
  const auto add_both = [&](int left_joint, const std::string& from, const std::string& to, double fraction) {
    for (const auto& [joint, sides] : {std::pair(left_joint, std::array{"L_", "left_"}),
                                       std::pair(mirrored_joint(left_joint), std::array{"R_", "right_"})})
      for (const std::string side : sides)
        map.rules[static_cast<std::size_t>(joint)].push_back(along(side + from, side + to, fraction));
  };
  set(map, Root, {at("Pelvis")});
  both(LeftHipJoint, {"Hip"});
  both(LeftFemur, {"Knee"});
  both(LeftTibia, {"Ankle"});
  both(LeftFoot, {"Toe", "Foot"});
  add_both(LeftToes, "Ankle", "Toe", toe_tip_beyond_foot);
  add_both(LeftToes, "Ankle", "Foot", toe_tip_beyond_foot);
  set(map, LowerBack, {at("Torso"), at("Spine1")});
  set(map, UpperBack, {at("Spine2"), at("Spine")});
  set(map, Thorax, {at("Spine3"), at("Chest")});
  set(map, LowerNeck, {at("Neck")});
  set(map, UpperNeck, {at("Head")});
  set(map, Head, {along("Neck", "Head", head_beyond_neck)});
  both(LeftClavicle, {"Shoulder"});
  both(LeftHumerus, {"Elbow"});
  both(LeftWrist, {"Wrist"});
  both(LeftHand, {"Middle1", "Hand"});
  add_both(LeftHand, "Elbow", "Wrist", hand_beyond_forearm);
  return map;
}

/// Joint centres without a skeleton: as Xsens MVN writes them to C3D ("jRightHip"), as Visual3D and Theia
/// users export them ("RHJC"), and the key points of OpenPose and HALPE that Pose2Sim writes to TRC ("RHip").
JointMap joint_centres() {
  using namespace joints;
  JointMap map{"joint-centres", {}};
  const auto middle = [](const std::string& left, const std::string& right) {
    return along(left, right, 0.5);
  };
  const auto both = [&](int left_joint, const std::string& xsens, const Rules& others) {
    for (const bool is_left : {true, false}) {
      Rules rules =
          xsens.empty() ? Rules{} : Rules{at("j" + std::string(is_left ? "Left" : "Right") + xsens)};
      for (JointRule rule : others) {
        for (JointRule::Term& term : rule.terms)
          if (const auto mark = term.point.find('%'); mark != std::string::npos)
            term.point.replace(
                mark, 1, term.point.starts_with('j') ? (is_left ? "Left" : "Right") : (is_left ? "L" : "R"));
        rules.push_back(std::move(rule));
      }
      set(map, is_left ? left_joint : mirrored_joint(left_joint), std::move(rules));
    }
  };
  both(LeftHipJoint, "Hip", {at("%HJC"), at("%_HJC"), at("%Hip")});
  both(LeftFemur, "Knee", {at("%KJC"), at("%_KJC"), at("%Knee")});
  both(LeftTibia, "Ankle", {at("%AJC"), at("%_AJC"), at("%Ankle")});
  constexpr double ball_of_foot = 1 / toe_tip_beyond_foot;
  both(LeftFoot, "BallFoot",
       {at("%MTP"), along("%AJC", "%TOE", ball_of_foot), along("%Ankle", "%BigToe", ball_of_foot),
        along("%KJC", "%AJC", 1.15)});
  both(LeftToes, "",
       {along("j%Ankle", "j%BallFoot", toe_tip_beyond_foot), along("%AJC", "%MTP", toe_tip_beyond_foot),
        at("%TOE"), at("%BigToe"), along("%KJC", "%AJC", 1.2)});
  both(LeftClavicle, "Shoulder", {at("%SJC"), at("%_SJC"), at("%Shoulder")});
  both(LeftHumerus, "Elbow", {at("%EJC"), at("%_EJC"), at("%Elbow")});
  both(LeftWrist, "Wrist", {at("%WJC"), at("%_WJC"), at("%Wrist")});
  both(LeftHand, "",
       {along("j%Elbow", "j%Wrist", hand_beyond_forearm), along("%EJC", "%WJC", hand_beyond_forearm),
        along("%_EJC", "%_WJC", hand_beyond_forearm), along("%Elbow", "%Wrist", hand_beyond_forearm)});
  struct Named {
    std::string root_left, root_right, neck_left, neck_right;
  };
  const std::array<Named, 4> named = {{{"jLeftHip", "jRightHip", "jLeftShoulder", "jRightShoulder"},
                                       {"LHJC", "RHJC", "LSJC", "RSJC"},
                                       {"L_HJC", "R_HJC", "L_SJC", "R_SJC"},
                                       {"LHip", "RHip", "LShoulder", "RShoulder"}}};
  Rules root = {at("CHip"), at("midHip")}, neck = {at("jT1C7"), at("Neck")};
  for (const Named& each : named) {
    root.push_back(middle(each.root_left, each.root_right));
    neck.push_back(middle(each.neck_left, each.neck_right));
  }
  set(map, Root, root);
  set(map, LowerNeck, neck);
  // Of the four points, the weights of a place on the line from the hips to the shoulders and beyond.
  const auto on_trunk = [&](double share, Rules before) {
    for (const Named& each : named)
      before.push_back(JointRule{{{each.root_left, (1 - share) / 2},
                                  {each.root_right, (1 - share) / 2},
                                  {each.neck_left, share / 2},
                                  {each.neck_right, share / 2}}});
    return before;
  };
  set(map, LowerBack, on_trunk(0.27, {at("jL4L3")}));
  set(map, UpperBack, on_trunk(0.53, {at("jL1T12")}));
  set(map, Thorax, on_trunk(0.79, {at("jT9T8")}));
  set(map, UpperNeck, on_trunk(1.2, {at("jC1Head"), along("Neck", "Head", 0.4)}));
  set(map, Head, on_trunk(1.41, {along("jT1C7", "jC1Head", head_beyond_neck), along("Neck", "Head", 0.7)}));
  return map;
}

/// The 33 points of MediaPipe's body, as FreeMoCap writes them.
JointMap mediapipe() {
  using namespace joints;
  JointMap map{"mediapipe", {}};
  const auto both = [&](int left_joint, const Rules& rules) {
    set_both(map, left_joint, rules, "left", "right");
  };
  const auto on_trunk = [](double share) {
    return JointRule{{{"left_hip", (1 - share) / 2},
                      {"right_hip", (1 - share) / 2},
                      {"left_shoulder", share / 2},
                      {"right_shoulder", share / 2}}};
  };
  set(map, Root, {on_trunk(0)});
  set(map, LowerBack, {on_trunk(0.27)}), set(map, UpperBack, {on_trunk(0.53)});
  set(map, Thorax, {on_trunk(0.79)}), set(map, LowerNeck, {on_trunk(1)});
  const auto to_ears = [](double share) {
    return JointRule{{{"left_shoulder", (1 - share) / 2},
                      {"right_shoulder", (1 - share) / 2},
                      {"left_ear", share / 2},
                      {"right_ear", share / 2}}};
  };
  set(map, UpperNeck, {to_ears(0.5)}), set(map, Head, {to_ears(1)});
  both(LeftHipJoint, {at("%_hip")}), both(LeftFemur, {at("%_knee")}), both(LeftTibia, {at("%_ankle")});
  both(LeftFoot, {along("%_heel", "%_foot_index", 0.75)}), both(LeftToes, {at("%_foot_index")});
  both(LeftClavicle, {at("%_shoulder")}), both(LeftHumerus, {at("%_elbow")});
  both(LeftWrist, {at("%_wrist")}), both(LeftHand, {along("%_pinky", "%_index", 0.5)});
  return map;
}

/// Segments of Theia3D, as C3dRotations names their origins: the proximal joint of a limb, the middle of the
/// pelvis, the base of the neck (torso), the middle of the ears (head). Source: "Theia model description" of
/// its documentation.
JointMap theia() {
  using namespace joints;
  JointMap map{"theia", {}};
  const auto both = [&](int left_joint, const Rules& rules) { set_both(map, left_joint, rules, "l", "r"); };
  both(LeftHipJoint, {at("%_thigh_4X4")});
  both(LeftFemur, {at("%_shank_4X4")});
  both(LeftTibia, {at("%_foot_4X4")});
  both(LeftFoot, {at("%_toes_4X4")});
  both(LeftToes, {at("%_toes_end"), along("%_foot_4X4", "%_toes_4X4", toe_tip_beyond_foot)});
  both(LeftClavicle, {at("%_uarm_4X4")});
  both(LeftHumerus, {at("%_larm_4X4")});
  both(LeftWrist, {at("%_hand_4X4")});
  both(LeftHand, {at("%_hand_end"), along("%_larm_4X4", "%_hand_4X4", hand_beyond_forearm)});
  set(map, Root, {at("pelvis_4X4")});
  Rules neck, upper_neck;
  std::array<Rules, 3> back;
  for (const std::string trunk : {"torso_4X4", "thorax_4X4"}) {
    neck.push_back(at(trunk));
    for (const char* head : {"head_center", "head_4X4"}) upper_neck.push_back(along(trunk, head, 0.5));
    constexpr std::array shares = {0.265, 0.527, 0.79};
    for (std::size_t b = 0; b < shares.size(); ++b) back[b].push_back(along("pelvis_4X4", trunk, shares[b]));
  }
  set(map, LowerBack, back[0]), set(map, UpperBack, back[1]), set(map, Thorax, back[2]);
  set(map, LowerNeck, neck), set(map, UpperNeck, upper_neck);
  set(map, Head, {at("head_center"), at("head_4X4")});
  return map;
}

}  // namespace

const std::vector<JointMap>& builtin_joint_maps() {
  // Stricter maps first: the first one that finds all joints is used.
  static const std::vector<JointMap> maps = {cmu(),           cmu_bvh(), mixamo(),   lafan(),
                                             unity(),         xsens(),   motive(),   smpl(),
                                             joint_centres(), theia(),   mediapipe()};
  return maps;
}

}  // namespace abrazo
