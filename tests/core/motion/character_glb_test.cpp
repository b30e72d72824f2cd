#include "core/motion/scenes/character_glb.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/humanoid_rig.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::character_glb_test {
namespace {

using test::Naming;
using test::rig;
using test::rig_bones;
using test::RigBone;
using ::testing::HasSubstr;
using Json = nlohmann::json;

/// Where the file's animation puts its bones.
class Played {
 public:
  explicit Played(const std::string& glb) {
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, 4);
    json_ = Json::parse(glb.substr(20, length));
    binary_ = glb.substr(20 + length + 8);
    for (std::size_t n = 0; n < json_["nodes"].size(); ++n)
      if (json_["nodes"][n].contains("children"))
        for (const Json& child : json_["nodes"][n]["children"]) parents_[child.get<std::size_t>()] = n;
  }
  const Json& json() const { return json_; }

  /// Of the bone, in the order of rig_bones().
  Vec3 place(std::size_t bone, std::size_t frame) const { return world(bone + 1, frame).translation(); }

 private:
  std::vector<float> values(std::size_t node, const char* path, std::size_t frame, std::size_t count) const {
    for (const Json& channel : json_["animations"][0]["channels"])
      if (channel["target"]["node"] == node && channel["target"]["path"] == path) {
        const auto sampler = channel["sampler"].get<std::size_t>();
        const auto output = json_["animations"][0]["samplers"][sampler]["output"].get<std::size_t>();
        const auto view = json_["accessors"][output]["bufferView"].get<std::size_t>();
        const auto offset = json_["bufferViews"][view]["byteOffset"].get<std::size_t>();
        std::vector<float> numbers(count);
        std::memcpy(numbers.data(), binary_.data() + offset + frame * count * sizeof(float),
                    count * sizeof(float));
        return numbers;
      }
    const Json& node_json = json_["nodes"][node];
    return node_json.contains(path) ? node_json[path].get<std::vector<float>>() : std::vector<float>();
  }
  Eigen::Affine3d world(std::size_t node, std::size_t frame) const {
    Eigen::Affine3d local = Eigen::Affine3d::Identity();
    if (const auto t = values(node, "translation", frame, 3); !t.empty())
      local.translate(Eigen::Vector3f(t[0], t[1], t[2]).cast<double>());
    if (const auto r = values(node, "rotation", frame, 4); !r.empty())
      local.rotate(Eigen::Quaternionf(r[3], r[0], r[1], r[2]).cast<double>());
    if (json_["nodes"][node].contains("scale")) local.scale(json_["nodes"][node]["scale"][0].get<double>());
    const auto parent = parents_.find(node);
    return parent == parents_.end() ? local : world(parent->second, frame) * local;
  }

  Json json_;
  std::string binary_;
  std::map<std::size_t, std::size_t> parents_;
};

Result<std::string> written_by(std::string_view character, const Clip& clip, const std::string& where) {
  auto files = write_character_glbs(character, {&clip, 1}, where);
  if (!files) return files.error();
  return std::move(files->front());
}

const Clip& dance() {
  static const Clip clip = test::swinging_take("dance", 60, 3).a;
  return clip;
}

std::size_t number_of(const std::string& vrm) {
  for (std::size_t b = 0; b < rig_bones().size(); ++b)
    if (rig_bones()[b].vrm == vrm) return b;
  return 0;
}

TEST(CharacterGlb, ItsLegsPointWhereThoseOfTheClipDoForEveryNamingAndRestPose) {
  using namespace joints;
  for (const Naming naming : {Naming::Mixamo, Naming::Vrm0, Naming::Vrm1}) {
    const auto written = written_by(rig(naming), dance(), "rig.glb");
    ASSERT_TRUE(written) << written.error().text();
    const Played played(*written);
    for (const std::size_t frame : {0U, 20U, 59U})
      for (const auto& [from, to, a, b] : std::vector<std::tuple<const char*, const char*, int, int>>{
               {"leftUpperLeg", "leftLowerLeg", left_hip, left_knee},
               {"rightLowerLeg", "rightFoot", right_knee, right_ankle}}) {
        const Vec3 shown =
            (played.place(number_of(to), frame) - played.place(number_of(from), frame)).normalized();
        const Pose& pose = dance().poses[frame];
        const Vec3 wanted = (joint_at(pose, b) - joint_at(pose, a)).normalized();
        EXPECT_LT((shown - wanted).norm(), 1e-4) << from << ' ' << frame << ' ' << static_cast<int>(naming);
      }
  }
}

TEST(CharacterGlb, HandsThatMeetInTheClipsMeetOnTheRigs) {
  using namespace joints;
  // A follower with shorter legs, so that the two would have different scales.
  std::vector<Clip> pair = {dance(), dance()};
  for (Pose& pose : pair[1].poses)
    for (const int joint :
         {left_ankle, right_ankle, left_toe_base, right_toe_base, left_toe_tip, right_toe_tip})
      pose(joint, 1) += 0.06;
  for (const Naming naming : {Naming::Mixamo, Naming::Vrm0, Naming::Vrm1}) {
    const auto files = write_character_glbs(rig(naming), pair, "rig.glb");
    ASSERT_TRUE(files) << files.error().text();
    const Played first((*files)[0]), second((*files)[1]);
    for (const std::size_t frame : {0U, 20U, 59U})
      for (const char* hand : {"leftHand", "rightHand"})
        EXPECT_LT((first.place(number_of(hand), frame) - second.place(number_of(hand), frame)).norm(), 0.004)
            << hand << ' ' << frame;
  }
}

TEST(CharacterGlb, KeepsItsBoneLengthsAndStandsOnTheFloor) {
  const Played played(*written_by(rig(Naming::Vrm1), dance(), "rig.vrm"));
  for (std::size_t frame = 0; frame < dance().poses.size(); frame += 10) {
    for (std::size_t b = 1; b < rig_bones().size(); ++b) {
      const RigBone& bone = rig_bones()[b];
      const std::size_t parent = number_of(bone.parent);
      EXPECT_NEAR((played.place(b, frame) - played.place(parent, frame)).norm(),
                  (bone.at - rig_bones()[parent].at).norm(), 1e-5);
    }
    EXPECT_NEAR(std::min(played.place(number_of("leftFoot"), frame).y(),
                         played.place(number_of("rightFoot"), frame).y()),
                0.08, 0.05);
  }
}

TEST(CharacterGlb, KeepsEverythingExceptItsAnimations) {
  const std::string file = rig(Naming::Vrm0);
  const Played played(*written_by(file, dance(), "rig.vrm"));
  EXPECT_EQ(played.json()["animations"].size(), 1u);
  EXPECT_EQ(played.json()["animations"][0]["name"], "motion");
  EXPECT_EQ(played.json()["extensions"]["VRM"]["humanoid"]["humanBones"].size(), rig_bones().size());
}

TEST(CharacterGlb, WhatIsNoHumanoidIsRefused) {
  const std::string file = rig(Naming::Mixamo);
  EXPECT_THAT(written_by("no glb", dance(), "a.glb").error().text(), HasSubstr("is no GLB"));
  for (std::size_t size = 0; size < file.size(); size += 7)
    EXPECT_FALSE(written_by(std::string_view(file).substr(0, size), dance(), "a.glb"));
  std::string nameless = file;
  for (std::size_t at = 0; (at = nameless.find("LeftUpLeg", at)) != std::string::npos;) nameless[at] = 'X';
  EXPECT_THAT(written_by(nameless, dance(), "a.glb").error().text(), HasSubstr("it lacks leftupperleg"));
  std::string circle = file;
  const auto at = circle.find("\"children\":[1]");
  ASSERT_NE(at, std::string::npos);
  circle[at + 12] = '0';
  EXPECT_THAT(written_by(circle, dance(), "a.glb").error().text(), HasSubstr("damaged"));
}

}  // namespace
}  // namespace abrazo::character_glb_test
