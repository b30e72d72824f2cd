#include "core/motion/joints/joint_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/bvh/bvh.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::joint_map_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const JointMap& builtin(const std::string& name) {
  for (const JointMap& map : builtin_joint_maps())
    if (map.name == name) return map;
  throw std::invalid_argument(name);
}

std::string json_map(const std::string& of_root) {
  std::string json = R"({"name": "mine", "joints": {"root": )" + of_root;
  for (std::size_t j = 1; j < joint_count; ++j)
    json += ", \"" + std::string(joint_names[j]) + "\": \"p" + std::to_string(j) + "\"";
  return json + "}}";
}

std::vector<std::string> points_of_json_map() {
  std::vector<std::string> points = {"p0"};
  for (int j = 1; j < joint_count; ++j) points.push_back("p" + std::to_string(j));
  return points;
}

TEST(JointMap, WeightsOfEveryBuiltInRuleAddUpToOne) {
  for (const JointMap& map : builtin_joint_maps())
    for (const auto& rules : map.rules) {
      EXPECT_THAT(rules, testing::Not(IsEmpty())) << map.name;
      for (const JointRule& rule : rules) {
        double sum = 0;
        for (const JointRule::Term& term : rule.terms) sum += term.weight;
        EXPECT_NEAR(sum, 1.0, 1e-12) << map.name;
      }
    }
}

TEST(JointMap, CmuTakesTheNamesOfTheJointSetWithOrWithoutANamespace) {
  std::vector<std::string> points;
  for (const std::string_view name : joint_names) points.push_back("active:" + std::string(name));
  std::reverse(points.begin(), points.end());
  const JointBinding binding = bind_joints(builtin("cmu"), points);
  ASSERT_THAT(binding.missing, IsEmpty());
  EXPECT_EQ(binding.terms[0], (std::vector<std::pair<int, double>>{{24, 1.0}}));
}

TEST(JointMap, CmuBvhTellsTheCmuConversionFromOtherSkeletonsWithTheSameNames) {
  std::vector<std::string> points = {"Hips",   "LHipJoint", "RHipJoint", "LowerBack", "Spine",
                                     "Spine1", "Neck",      "Neck1",     "Head",      "Head_End"};
  for (const std::string side : {"Left", "Right"})
    for (const char* part : {"UpLeg", "Leg", "Foot", "ToeBase", "ToeBase_End", "Shoulder", "Arm", "ForeArm",
                             "Hand", "FingerBase", "HandIndex1"})
      points.push_back(side + part);
  EXPECT_THAT(bind_joints(builtin("cmu-bvh"), points).missing, IsEmpty());
  points.erase(points.begin() + 3);
  EXPECT_THAT(bind_joints(builtin("cmu-bvh"), points).missing, testing::ElementsAre(joints::Root));
}

TEST(JointMap, MixamoNamesMayHaveTheirPrefixInAnySpelling) {
  for (const std::string prefix :
       {"", "mixamorig:", "mixamorig_", "mixamorig", "Anna:mixamorig:", "mixamorig5:"}) {
    std::vector<std::string> points;
    for (const char* part : {"Hips", "Spine", "Spine1", "Spine2", "Neck", "Head", "HeadTop_End"})
      points.push_back(prefix + part);
    for (const std::string side : {"Left", "Right"})
      for (const char* part : {"UpLeg", "Leg", "Foot", "ToeBase", "Toe_End", "Shoulder", "Arm", "ForeArm",
                               "Hand", "HandMiddle1"})
        points.push_back(prefix + side + part);
    EXPECT_THAT(bind_joints(builtin("mixamo"), points).missing, IsEmpty()) << prefix;
    EXPECT_THAT(bind_joints(builtin("mixamo"), points).estimated, IsEmpty()) << prefix;
  }
}

TEST(JointMap, UnityFillsInWhatAvatarsMayLack) {
  std::vector<std::string> required = {"Hips", "Spine", "Head"};
  for (const std::string side : {"Left", "Right"})
    for (const char* part : {"UpperLeg", "LowerLeg", "Foot", "UpperArm", "LowerArm", "Hand"})
      required.push_back(side + part);
  const JointBinding least = bind_joints(builtin("unity"), required);
  EXPECT_THAT(least.missing, IsEmpty());
  EXPECT_THAT(least.estimated, testing::Contains(joints::Thorax));
  std::vector<std::string> full = required;
  for (const char* part :
       {"Chest", "UpperChest", "Neck", "LeftToes", "RightToes", "LeftMiddleProximal", "RightMiddleProximal"})
    full.push_back(part);
  const JointBinding better = bind_joints(builtin("unity"), full);
  EXPECT_THAT(better.missing, IsEmpty());
  EXPECT_THAT(better.estimated, testing::ElementsAre(joints::LeftToes, joints::RightToes, joints::Head));
  for (const char* end : {"Head_End", "LeftToes_End", "RightToes_End"}) full.emplace_back(end);
  EXPECT_THAT(bind_joints(builtin("unity"), full).estimated, IsEmpty());
}

TEST(JointMap, XsensTakesSegmentAndJointNames) {
  std::vector<std::string> segments = {"Pelvis", "L5", "L3", "T12", "T8", "Neck", "Head"};
  for (const std::string side : {"Left ", "Right "})
    for (const char* part :
         {"Upper Leg", "Lower Leg", "Foot", "Toe", "Shoulder", "Upper Arm", "Forearm", "Hand"})
      segments.push_back(side + part);
  const JointBinding live = bind_joints(builtin("xsens"), segments);
  EXPECT_THAT(live.missing, IsEmpty());
  const auto at = [&](int joint) {
    return segments[static_cast<std::size_t>(live.terms[static_cast<std::size_t>(joint)][0].first)];
  };
  EXPECT_EQ(at(joints::left_shoulder),
            "Left Upper Arm");  // not "Left Shoulder", which is the collar bone's segment
  std::vector<std::string> joints_of_bvh = {"Hips", "Chest", "Chest2", "Chest3", "Chest4", "Neck", "Head"};
  for (const std::string side : {"Left", "Right"})
    for (const char* part : {"Collar", "Shoulder", "Elbow", "Wrist", "Hip", "Knee", "Ankle", "Toe"})
      joints_of_bvh.push_back(side + part);
  EXPECT_THAT(bind_joints(builtin("xsens"), joints_of_bvh).missing, IsEmpty());
}

TEST(JointMap, PrefersAnExactNameToASimilarOne) {
  std::vector<std::string> points = {"other:ROOT"};
  for (const std::string_view name : joint_names) points.emplace_back(name);
  EXPECT_EQ(bind_joints(builtin("cmu"), points).terms[0][0].first, 1);
}

TEST(JointMap, MixesPointsByWeight) {
  const auto map = parse_joint_map(json_map(R"({"p0": 1.5, "p1": -0.5})"), "map.json");
  ASSERT_TRUE(map) << map.error().text();
  EXPECT_EQ(map->name, "mine");
  const JointBinding binding = bind_joints(*map, points_of_json_map());
  Positions points = Positions::Zero(joint_count, 3);
  points.row(0) << 1, 2, 3;
  points.row(1) << 1, 1, 1;
  EXPECT_TRUE(binding.joints_of(points).row(0).isApprox(Eigen::RowVector3d(1, 2.5, 4)));
  EXPECT_TRUE(binding.joints_of(points).row(1).isApprox(Eigen::RowVector3d(1, 1, 1)));
}

TEST(JointMap, TakesTheFirstAlternativeWhosePointsExist) {
  const auto map = parse_joint_map(
      json_map(R"(["absent", {"p0": 0.5, "absent": 0.5}, {"p0": 0.5, "p2": 0.5}, "p3"])"), "map.json");
  ASSERT_TRUE(map) << map.error().text();
  const JointBinding binding = bind_joints(*map, points_of_json_map());
  EXPECT_EQ(binding.terms[0], (std::vector<std::pair<int, double>>{{0, 0.5}, {2, 0.5}}));
  EXPECT_THAT(binding.estimated, testing::ElementsAre(0));
}

TEST(JointMap, SaysWhatIsWrongWithAMapItCannotUse) {
  const auto refusal = [](const std::string& json) {
    return parse_joint_map(json, "map.json").error().text();
  };
  EXPECT_THAT(refusal("{\n\"name\": oops}"), HasSubstr("map.json:2: is not JSON"));
  EXPECT_THAT(refusal(json_map(R"({"p0": 1e999})")), HasSubstr("cannot be read"));
  EXPECT_THAT(refusal("[]"), HasSubstr("expected {"));
  EXPECT_THAT(refusal(R"({"joints": {"nose": "p"}})"), HasSubstr("there is no joint 'nose'"));
  EXPECT_THAT(refusal(R"({"joints": {"root": "p"}})"), HasSubstr("gives no point for lhipjoint, lfemur"));
  EXPECT_THAT(refusal(json_map(R"({"p0": 0.5, "p1": 0.4})")),
              HasSubstr("map.json: joints.root: the weights add up to 0.9"));
  EXPECT_THAT(refusal(json_map(R"({"p0": "half"})")), HasSubstr("not a number"));
  EXPECT_THAT(refusal(json_map("[]")), HasSubstr("empty"));
  EXPECT_THAT(refusal(json_map("3")), HasSubstr("expected a point name"));
}

}  // namespace
}  // namespace abrazo::joint_map_test
