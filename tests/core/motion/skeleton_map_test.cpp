#include <tuple>

#include "core/motion/joints/skeleton_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/map_choice.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::skeleton_map_test {
namespace {

using test::the_warning;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// What a program calls its bones; "%" stands for the side. Ends that it does not write are left empty.
struct Naming {
  std::string program;
  std::string left = "Left", right = "Right";
  std::string root;
  std::vector<std::string> spine;
  std::string neck, head, head_end;
  std::string collar, shoulder, elbow, wrist, hand_end;
  std::string hip, knee, ankle, toe, toe_end;
};

/// A standing person of 1.75 m in centimetres, with bones of those names.
NamedMotion person(const Naming& naming) {
  NamedMotion motion;
  motion.name = naming.program;
  std::vector<Vec3> places;
  const auto add = [&](const std::string& name, int parent, const Vec3& place) {
    if (name.empty()) return parent;
    motion.points.push_back(name);
    motion.parents.push_back(parent);
    places.push_back(place);
    return static_cast<int>(places.size()) - 1;
  };
  const int root = add(naming.root, -1, {0, 95, 0});
  int trunk = root;
  for (std::size_t s = 0; s < naming.spine.size(); ++s)
    trunk =
        add(naming.spine[s], trunk,
            {0, 95 + 50.0 * static_cast<double>(s + 1) / static_cast<double>(naming.spine.size() + 1), 0});
  const int chest = trunk;
  trunk = add(naming.neck, trunk, {0, 148, 0});
  trunk = add(naming.head, trunk, {0, 158, 1});
  add(naming.head_end, trunk, {0, 177, 2});
  for (const double side : {1.0, -1.0}) {
    const auto sided = [&](std::string name) {
      if (const auto mark = name.find('%'); mark != std::string::npos)
        name.replace(mark, 1, side > 0 ? naming.left : naming.right);
      return name;
    };
    int arm = add(sided(naming.collar), chest, {3 * side, 144, 0});
    arm = add(sided(naming.shoulder), arm, {18 * side, 144, 0});
    arm = add(sided(naming.elbow), arm, {45 * side, 144, 0});
    arm = add(sided(naming.wrist), arm, {70 * side, 144, 0});
    add(sided(naming.hand_end), arm, {86 * side, 144, 0});
    int leg = add(sided(naming.hip), root, {9 * side, 91, 0});
    leg = add(sided(naming.knee), leg, {9 * side, 50, 1});
    leg = add(sided(naming.ankle), leg, {9 * side, 9, 0});
    leg = add(sided(naming.toe), leg, {9 * side, 3, 12});
    add(sided(naming.toe_end), leg, {9 * side, 2, 19});
  }
  Positions frame(static_cast<Eigen::Index>(places.size()), 3);
  for (std::size_t p = 0; p < places.size(); ++p)
    frame.row(static_cast<Eigen::Index>(p)) = places[p].transpose();
  motion.frames.assign(5, frame);
  motion.fps = 60;
  return motion;
}

const std::vector<Naming>& namings() {
  static const std::vector<Naming> list = {
      {"biped",
       "L",
       "R",
       "Bip01 Pelvis",
       {"Bip01 Spine", "Bip01 Spine1"},
       "Bip01 Neck",
       "Bip01 Head",
       "Bip01 HeadNub",
       "Bip01 % Clavicle",
       "Bip01 % UpperArm",
       "Bip01 % Forearm",
       "Bip01 % Hand",
       "",
       "Bip01 % Thigh",
       "Bip01 % Calf",
       "Bip01 % Foot",
       "Bip01 % Toe0",
       "Bip01 % Toe0Nub"},
      {"daz",
       "l",
       "r",
       "hip",
       {"abdomenLower", "abdomenUpper", "chestLower", "chestUpper"},
       "neckLower",
       "head",
       "",
       "%Collar",
       "%ShldrBend",
       "%ForearmBend",
       "%Hand",
       "",
       "%ThighBend",
       "%Shin",
       "%Foot",
       "%Toe",
       ""},
      {"poser",
       "l",
       "r",
       "hip",
       {"abdomen", "chest"},
       "neck",
       "head",
       "",
       "%Collar",
       "%Shldr",
       "%ForeArm",
       "%Hand",
       "",
       "%Thigh",
       "%Shin",
       "%Foot",
       "",
       "%Foot_End"},
      {"rokoko",
       "Left",
       "Right",
       "Hips",
       {"Spine1", "Spine2", "Spine3", "Spine4"},
       "Neck",
       "Head",
       "",
       "%Shoulder",
       "%Arm",
       "%ForeArm",
       "%Hand",
       "",
       "%Thigh",
       "%Shin",
       "%Foot",
       "%Toe",
       "%ToeTip"},
      {"perception neuron",
       "Left",
       "Right",
       "Robot_Hips",
       {"Robot_Spine", "Robot_Spine1", "Robot_Spine2"},
       "Robot_Neck",
       "Robot_Head",
       "Robot_Head_End",
       "Robot_%Shoulder",
       "Robot_%Arm",
       "Robot_%ForeArm",
       "Robot_%Hand",
       "Robot_%HandMiddle1",
       "Robot_%UpLeg",
       "Robot_%Leg",
       "Robot_%Foot",
       "",
       "Robot_%Foot_End"},
      {"capture suite",
       "Left",
       "Right",
       "Hips",
       {"Chest", "Chest2"},
       "Neck",
       "Head",
       "Head_End",
       "%Collar",
       "%Shoulder",
       "%Elbow",
       "%Wrist",
       "%Wrist_End",
       "%Hip",
       "%Knee",
       "%Ankle",
       "",
       "%Ankle_End"},
      {"smpl",
       "L",
       "R",
       "Pelvis",
       {"Spine1", "Spine2", "Spine3"},
       "Neck",
       "Head",
       "",
       "%_Collar",
       "%_Shoulder",
       "%_Elbow",
       "%_Wrist",
       "%_Hand",
       "%_Hip",
       "%_Knee",
       "%_Ankle",
       "%_Foot",
       ""},
      {"smpl-x",
       "left",
       "right",
       "pelvis",
       {"spine1", "spine2", "spine3"},
       "neck",
       "head",
       "",
       "%_collar",
       "%_shoulder",
       "%_elbow",
       "%_wrist",
       "%_middle1",
       "%_hip",
       "%_knee",
       "%_ankle",
       "%_foot",
       ""},
      {"smpl in a game engine",
       "L",
       "R",
       "m_avg_Pelvis",
       {"m_avg_Spine1", "m_avg_Spine2", "m_avg_Spine3"},
       "m_avg_Neck",
       "m_avg_Head",
       "",
       "m_avg_%_Collar",
       "m_avg_%_Shoulder",
       "m_avg_%_Elbow",
       "m_avg_%_Wrist",
       "m_avg_%_Hand",
       "m_avg_%_Hip",
       "m_avg_%_Knee",
       "m_avg_%_Ankle",
       "m_avg_%_Foot",
       ""},
      {"avatar",
       "L",
       "R",
       "J_Bip_C_Hips",
       {"J_Bip_C_Spine", "J_Bip_C_Chest", "J_Bip_C_UpperChest"},
       "J_Bip_C_Neck",
       "J_Bip_C_Head",
       "",
       "J_Bip_%_Shoulder",
       "J_Bip_%_UpperArm",
       "J_Bip_%_LowerArm",
       "J_Bip_%_Hand",
       "",
       "J_Bip_%_UpperLeg",
       "J_Bip_%_LowerLeg",
       "J_Bip_%_Foot",
       "J_Bip_%_ToeBase",
       ""},
      {"rig",
       "L",
       "R",
       "DEF-hips",
       {"DEF-spine.001", "DEF-spine.002"},
       "DEF-neck",
       "DEF-head",
       "",
       "DEF-shoulder.%",
       "DEF-upper_arm.%",
       "DEF-forearm.%",
       "DEF-hand.%",
       "",
       "DEF-thigh.%",
       "DEF-shin.%",
       "DEF-foot.%",
       "DEF-toe.%",
       ""},
      {"one bone of a spine",
       "Left",
       "Right",
       "Hips",
       {"Torso"},
       "Neck",
       "Head",
       "",
       "",
       "%Arm",
       "%ForeArm",
       "%Hand",
       "",
       "%UpLeg",
       "%Leg",
       "%Foot",
       "",
       ""},
      {"advanced skeleton",
       "L",
       "R",
       "Root_M",
       {"Spine1_M", "Spine2_M", "Chest_M"},
       "Neck_M",
       "Head_M",
       "",
       "Scapula_%",
       "Shoulder_%",
       "Elbow_%",
       "Wrist_%",
       "",
       "Hip_%",
       "Knee_%",
       "Ankle_%",
       "Toes_%",
       ""},
      {"deepmotion",
       "l",
       "r",
       "hips_JNT",
       {"spine_JNT", "spine1_JNT", "spine2_JNT"},
       "neck_JNT",
       "head_JNT",
       "",
       "%_shoulder_JNT",
       "%_arm_JNT",
       "%_forearm_JNT",
       "%_hand_JNT",
       "",
       "%_upleg_JNT",
       "%_leg_JNT",
       "%_foot_JNT",
       "%_toebase_JNT",
       ""},
      {"rigify",
       "L",
       "R",
       "DEF-spine",
       {"DEF-spine.001", "DEF-spine.002", "DEF-spine.003"},
       "DEF-spine.004",
       "DEF-spine.006",
       "",
       "DEF-shoulder.%",
       "DEF-upper_arm.%",
       "DEF-forearm.%",
       "DEF-hand.%",
       "",
       "DEF-thigh.%",
       "DEF-shin.%",
       "DEF-foot.%",
       "DEF-toe.%",
       ""},
      {"motive behind the name of its skeleton",
       "L",
       "R",
       "Anna_Hip",
       {"Anna_Ab", "Anna_Chest"},
       "Anna_Neck",
       "Anna_Head",
       "",
       "Anna_%Shoulder",
       "Anna_%UArm",
       "Anna_%FArm",
       "Anna_%Hand",
       "",
       "Anna_%Thigh",
       "Anna_%Shin",
       "Anna_%Foot",
       "Anna_%Toe",
       ""},
      {"sketchfab, every node numbered",
       "Left",
       "Right",
       "Hips_01",
       {"Spine_02", "Spine1_03", "Spine2_04"},
       "Neck_05",
       "Head_06",
       "",
       "%Shoulder_07",
       "%Arm_08",
       "%ForeArm_09",
       "%Hand_010",
       "",
       "%UpLeg_011",
       "%Leg_012",
       "%Foot_013",
       "%ToeBase_014",
       ""},
      {"bones of an anatomist",
       "l",
       "r",
       "root",
       {"lowerback", "upperback", "thorax"},
       "lowerneck",
       "head",
       "",
       "%clavicle",
       "%humerus",
       "%radius",
       "%hand",
       "",
       "%femur",
       "%tibia",
       "%foot",
       "%toes",
       ""},
  };
  return list;
}

std::string point_of(const SkeletonMap& skeleton, int joint) {
  const auto& rules = skeleton.map.rules[static_cast<std::size_t>(joint)];
  return rules.empty() ? "" : rules.front().terms.front().point;
}

TEST(SkeletonMap, FindsTheLimbsByTheNamesOfManyPrograms) {
  for (const Naming& naming : namings()) {
    SCOPED_TRACE(naming.program);
    const SkeletonMap skeleton = skeleton_map(person(naming));
    EXPECT_THAT(skeleton.missing, IsEmpty());
    const auto right = [&](std::string name) { return name.replace(name.find('%'), 1, naming.right); };
    EXPECT_EQ(point_of(skeleton, joints::Root), naming.root);
    EXPECT_EQ(point_of(skeleton, joints::LowerNeck), naming.neck);
    EXPECT_EQ(point_of(skeleton, joints::UpperNeck), naming.head);
    EXPECT_EQ(point_of(skeleton, joints::right_hip), right(naming.hip));
    EXPECT_EQ(point_of(skeleton, joints::right_knee), right(naming.knee));
    EXPECT_EQ(point_of(skeleton, joints::right_ankle), right(naming.ankle));
    EXPECT_EQ(point_of(skeleton, joints::right_shoulder), right(naming.shoulder));
    EXPECT_EQ(point_of(skeleton, joints::right_elbow), right(naming.elbow));
    EXPECT_EQ(point_of(skeleton, joints::right_wrist), right(naming.wrist));
  }
}

TEST(SkeletonMap, EveryOneOfThemStandsAsTheSamePerson) {
  for (const Naming& naming : namings()) {
    SCOPED_TRACE(naming.program);
    const auto imported = import_clip(person(naming), {});
    ASSERT_TRUE(imported) << imported.error().text();
    const Pose& pose = imported->clip.poses.front();
    EXPECT_NEAR(imported->report.height_m, 1.70, 0.05);
    for (const auto& [joint, height_m, tolerance] : {std::tuple(joints::left_toe_base, 0.03, 0.04),
                                                     {joints::right_toe_tip, 0.02, 0.04},
                                                     {int(joints::LowerBack), 1.09, 0.07},
                                                     {int(joints::Thorax), 1.36, 0.07},
                                                     {int(joints::Head), 1.68, 0.05}})
      EXPECT_NEAR(pose(joint, 1), height_m, tolerance) << joint_names[static_cast<std::size_t>(joint)];
    EXPECT_NEAR(pose(joints::left_hand, 0), 0.77, 0.1);
  }
}

TEST(SkeletonMap, AFootThatEndsInAnEndSiteHasItsToesThere) {
  const NamedMotion motion = person(namings()[5]);
  const auto imported = import_clip(motion, {});
  ASSERT_TRUE(imported);
  EXPECT_THAT(
      the_warning(imported->report.warnings, "inferred-joints").detail,
      HasSubstr(
          "6 of the 25 joints are not in the file and were inferred: lfoot, ltoes, rfoot, rtoes, lhand, "
          "rhand"));
  const Pose& pose = imported->clip.poses.front();
  EXPECT_NEAR(pose(joints::left_toe_tip, 2), 0.19, 1e-9);
  EXPECT_NEAR(pose(joints::left_toe_base, 2), 0.7 * 0.19, 1e-9);
}

TEST(SkeletonMap, AnEndOfNoLengthIsNone) {
  NamedMotion motion = person(namings()[5]);
  for (Positions& frame : motion.frames)
    for (std::size_t p = 0; p < motion.points.size(); ++p)
      if (motion.points[p].ends_with("Ankle_End"))
        frame.row(static_cast<Eigen::Index>(p)) = frame.row(motion.parents[p]);
  const auto imported = import_clip(motion, {});
  ASSERT_TRUE(imported);
  EXPECT_LT(imported->clip.poses.front()(joints::left_toe_base, 1), 0.05) << "below the ankle, on the floor";
}

TEST(SkeletonMap, SaysWhatABodyWithoutArmsLacks) {
  Naming legs = namings()[1];
  legs.collar = legs.shoulder = legs.elbow = legs.wrist = "";
  const SkeletonMap skeleton = skeleton_map(person(legs));
  EXPECT_THAT(skeleton.missing,
              UnorderedElementsAre(joints::LeftClavicle, joints::LeftHumerus, joints::LeftWrist,
                                   joints::LeftHand, joints::RightClavicle, joints::RightHumerus,
                                   joints::RightWrist, joints::RightHand));
  const auto imported = import_clip(person(legs), {});
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().message,
              HasSubstr("the closest, 'skeleton', lacks lclavicle, lhumerus, lwrist and 5 more"));
}

TEST(ChooseMap, ABuiltInMapThatLacksOnlyEndsFits) {
  NamedMotion motion;
  for (int j = 0; j < joint_count; ++j) {
    if (j == joints::LeftToes || j == joints::Head) continue;
    motion.points.emplace_back(joint_names[static_cast<std::size_t>(j)]);
    motion.parents.push_back(-1);
  }
  motion.frames.assign(2, Positions::Random(static_cast<Eigen::Index>(motion.points.size()), 3));
  const ChosenMap chosen = choose_map(motion, {});
  EXPECT_TRUE(chosen.fits());
  EXPECT_EQ(chosen.map.name, "cmu");
  EXPECT_THAT(chosen.inferred, ElementsAre(joints::LeftToes, joints::Head));
  motion.points[2] = "somewhere";
  EXPECT_THAT(choose_map(motion, {}).binding.missing, Contains(2));
}

}  // namespace
}  // namespace abrazo::skeleton_map_test
