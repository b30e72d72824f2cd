#include "core/motion/scenes/worn_character.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/base/text.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/scenes/glb_file.hpp"
#include "core/motion/scenes/read_worn_character.hpp"
#include "core/motion/scenes/vrm_bones.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/humanoid_rig.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::worn_character_test {
namespace {

using test::Naming;
using test::rig_bones;
using test::skinned_rig;
using ::testing::HasSubstr;
using Json = nlohmann::json;

const Clip& dance() {
  static const Clip clip = test::swinging_take("dance", 60, 3).a;
  return clip;
}

std::size_t number_of(const std::string& vrm) {
  for (std::size_t b = 0; b < rig_bones().size(); ++b)
    if (rig_bones()[b].vrm == vrm) return b;
  return 0;
}

class WornCharacters : public ::testing::Test {
 protected:
  WornCharacters()
      : folder_(std::filesystem::temp_directory_path() / ("abrazo_worn_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~WornCharacters() override { std::filesystem::remove_all(folder_); }

  Result<std::shared_ptr<const WornCharacter>> read(const std::string& content) const {
    const std::string file = (folder_ / "figure.glb").string();
    EXPECT_TRUE(write_whole_file(file, content));
    return read_worn_character(file);
  }
  /// The rig with a change of its JSON.
  template <typename Change>
  std::string trouble(Change change) const {
    auto glb = *parse_glb(skinned_rig(Naming::Vrm1), "figure.glb");
    change(glb.json);
    const auto got = read(*glb_text(glb, "figure.glb"));
    return got ? "" : got.error().text();
  }
  std::filesystem::path folder_;
};

/// Middle of the triangle that a bone carries.
Vec3 place_of(const std::string& bone, const std::vector<float>& points) {
  Vec3 sum = Vec3::Zero();
  const std::size_t first = 9 * number_of(bone);
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      sum[axis] += static_cast<double>(points[first + 3 * corner + static_cast<std::size_t>(axis)]) / 3;
  return sum;
}

TEST(VrmBones, ACharacterWithoutAnimationHasItsRestPose) {
  for (const Naming naming : {Naming::Vrm0, Naming::Vrm1}) {
    auto glb = *parse_glb(skinned_rig(naming), "figure.vrm");
    glb.json.erase("animations");
    const auto rest = rest_pose_of_vrm(*glb_text(glb, "figure.vrm"), "figure.vrm");
    ASSERT_TRUE(rest) << rest.error().text();
    ASSERT_TRUE(rest->has_value());
    const NamedMotion& motion = **rest;
    ASSERT_EQ(motion.frames.size(), 1U);
    const double front = naming == Naming::Vrm0 ? -1 : 1;
    for (const test::RigBone& bone : rig_bones()) {
      const Vec3 at = test::place(motion, 0, lower_case(bone.vrm));
      EXPECT_LT((at - Vec3(front * bone.at.x(), bone.at.y(), front * bone.at.z())).norm(), 1e-6) << bone.vrm;
    }
    const auto body = import_clip(motion, {});
    ASSERT_TRUE(body) << body.error().text();
    EXPECT_EQ(body->report.joint_map, "unity");
  }
  EXPECT_FALSE(rest_pose_of_vrm(skinned_rig(Naming::Mixamo), "figure.glb")->has_value());
}

TEST(VrmBones, NodesAreCalledAsVrmListsThem) {
  auto glb = *parse_glb(skinned_rig(Naming::Vrm1), "figure.glb");
  NamedMotion motion;
  for (Json& node : glb.json["nodes"]) {
    node["name"] = "n" + std::to_string(motion.points.size());
    motion.points.push_back(node["name"]);
  }
  std::vector<NamedMotion> motions = {motion};
  name_by_vrm(*glb_text(glb, "figure.glb"), motions);
  for (const test::RigBone& bone : rig_bones())
    EXPECT_EQ(std::ranges::count(motions[0].points, lower_case(bone.vrm)), 1) << bone.vrm;
}

TEST_F(WornCharacters, AtRestThePointsAreWhereTheMeshHasThem) {
  for (const Naming naming : {Naming::Mixamo, Naming::Vrm0, Naming::Vrm1}) {
    const auto character = read(skinned_rig(naming));
    ASSERT_TRUE(character) << character.error().text();
    const CharacterSkin& skin = (*character)->skin;
    ASSERT_EQ(skin.points.size(), 3 * rig_bones().size());
    std::vector<Eigen::Affine3d> world;
    for (const RigNode& node : (*character)->rig->nodes) world.push_back(node.world);
    std::vector<float> points(3 * skin.points.size()), normals(points.size());
    SkinShape(skin).place(skin, world, 2, points, normals);
    for (std::size_t p = 0; p < skin.points.size(); ++p)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(points[3 * p + axis], 2 * skin.points[p][static_cast<int>(axis)], 1e-5);
        EXPECT_NEAR(normals[3 * p + axis], skin.normals[p][static_cast<int>(axis)], 1e-5);
      }
  }
}

TEST_F(WornCharacters, HasTheColourOfItsMaterial) {
  const auto character = read(skinned_rig(Naming::Vrm1));
  EXPECT_THAT((*character)->skin.colours[0], ::testing::ElementsAre(186, 0, 255));  // 0.5 linear
}

TEST_F(WornCharacters, TheSkinIsWhereTheBodyIsAndItsWristsAreAtTheBodysWrists) {
  using namespace joints;
  for (const Naming naming : {Naming::Mixamo, Naming::Vrm0, Naming::Vrm1}) {
    const auto character = read(skinned_rig(naming));
    CharacterFit fit(*character, stance_of(dance().poses));
    std::vector<float> points(9 * rig_bones().size()), normals(points.size());
    for (std::size_t f = 0; f < dance().poses.size(); ++f) {
      const Pose& pose = dance().poses[f];
      fit.fit(pose, static_cast<double>(f) / 60, points, normals);
      const auto off = [&](const char* bone, int joint) {
        return (place_of(bone, points) - joint_at(pose, joint)).norm();
      };
      EXPECT_LT(off("leftHand", left_wrist), 0.004) << f;
      EXPECT_LT(off("rightHand", right_wrist), 0.004) << f;
      EXPECT_LT(off("leftFoot", left_ankle), 0.08) << f;
      EXPECT_LT(off("leftUpperLeg", left_hip), 0.05) << f;
      for (const char* bone : {"leftFoot", "rightFoot"}) EXPECT_GT(place_of(bone, points).y(), 0.03) << f;
    }
  }
}

TEST_F(WornCharacters, AFrameThatIsShownAgainLooksTheSame) {
  const auto character = read(skinned_rig(Naming::Vrm1));
  CharacterFit fit(*character, stance_of(dance().poses));
  std::vector<float> first(9 * rig_bones().size()), again(first.size()), normals(first.size());
  fit.fit(dance().poses[0], 5, first, normals);
  fit.fit(dance().poses[30], 40, again, normals);  // the cursor is moved there and back
  fit.fit(dance().poses[0], 5, again, normals);
  EXPECT_EQ(first, again);
}

TEST_F(WornCharacters, WhatCannotBeShownIsRefusedByName) {
  EXPECT_THAT(read_worn_character((folder_ / "none.glb").string()).error().text(), HasSubstr("none.glb"));
  EXPECT_THAT(read("no glb").error().text(), HasSubstr("figure.glb"));
  EXPECT_THAT(read(test::rig(Naming::Vrm1)).error().text(), HasSubstr("has no mesh to show"));
  EXPECT_THAT(trouble([](Json& json) { json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
              HasSubstr("is compressed (KHR_draco_mesh_compression)"));
  EXPECT_THAT(
      trouble([](Json& json) { json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0"); }),
      HasSubstr("lacks the joints and weights"));
  EXPECT_THAT(trouble([](Json& json) { json["meshes"][0]["primitives"][0]["mode"] = 1; }),
              HasSubstr("it needs triangles"));
  EXPECT_THAT(trouble([](Json& json) { json["skins"][0]["joints"][3] = 9999; }),
              HasSubstr("skin is damaged"));
}

TEST_F(WornCharacters, NodesBeyondAllMeasureAreRefusedByName) {
  const auto with = [&](const char* key, double number) {
    return trouble([&](Json& json) {
      json["nodes"][0]["name"] = "far";
      json["nodes"][0][key] = {number, number, number};
    });
  };
  for (const double number : {1.1e9, 1e100, 1e308}) {
    EXPECT_THAT(with("translation", number), HasSubstr("figure.glb: its node 'far' is farther away"));
    EXPECT_THAT(with("scale", number), HasSubstr("its node 'far' is farther away, or scaled by more"));
  }
  EXPECT_EQ(with("translation", 1e8), "");
}

TEST_F(WornCharacters, NodesThatShowOneMeshAgainAndAgainAreRefusedBeforeTheyTakeTheDay) {
  const auto shown = [&](std::size_t primitives) {
    return trouble([&](Json& json) {
      // Of a material that cannot be seen, so that nothing of it is counted as points.
      Json hidden = json["meshes"][0]["primitives"][0];
      hidden["material"] = json["materials"].size();
      json["materials"].push_back(
          {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0}}}}});
      json["meshes"].push_back({{"primitives", Json::array()}});
      for (std::size_t i = 0; i < 100; ++i) json["meshes"].back()["primitives"].push_back(hidden);
      for (std::size_t i = 0; i < primitives / 100; ++i)
        json["nodes"].push_back(
            {{"mesh", json["meshes"].size() - 1}, {"name", "again " + std::to_string(i)}});
    });
  };
  EXPECT_THAT(shown(limits::character_primitives - 100), testing::Not(HasSubstr("primitives")));
  EXPECT_THAT(shown(limits::character_primitives), HasSubstr("its nodes show more than 10000 primitives"));
}

TEST_F(WornCharacters, AccessorsThatLeaveTheirBufferAreRefused) {
  const auto lists = parse_glb(skinned_rig(Naming::Vrm1), "figure.glb")->json;
  for (std::size_t a = 0; a < lists["accessors"].size(); ++a) {
    const auto damaged = [&](auto change) {
      return trouble([&](Json& json) { change(json["accessors"][a], json["bufferViews"][a]); });
    };
    EXPECT_THAT(damaged([](Json& accessor, Json&) { accessor["count"] = 1u << 30U; }),
                HasSubstr("figure.glb"));
    EXPECT_THAT(damaged([](Json& accessor, Json&) { accessor["count"] = ~std::uint64_t{0}; }),
                HasSubstr("figure.glb"));
    EXPECT_THAT(damaged([](Json& accessor, Json&) { accessor["byteOffset"] = ~std::uint64_t{0}; }),
                HasSubstr("figure.glb"));
    EXPECT_THAT(damaged([](Json&, Json& view) { view["byteOffset"] = 1u << 30U; }), HasSubstr("figure.glb"));
    EXPECT_THAT(damaged([](Json&, Json& view) { view["byteLength"] = ~std::uint64_t{0}; }),
                HasSubstr("figure.glb"));
    EXPECT_THAT(damaged([](Json& accessor, Json&) { accessor["type"] = "VEC9"; }), HasSubstr("figure.glb"));
    EXPECT_THAT(damaged([](Json& accessor, Json&) { accessor["componentType"] = "float"; }),
                HasSubstr("figure.glb"));
  }
}

TEST_F(WornCharacters, PointsAndNormalsThatAreNoNumbersAreRefused) {
  const std::string file = skinned_rig(Naming::Vrm1);
  const auto whole = parse_glb(file, "figure.glb");
  const Json& json = whole->json;
  for (const char* attribute : {"POSITION", "NORMAL"}) {
    const Json& accessor =
        json["accessors"][json["meshes"][0]["primitives"][0]["attributes"][attribute].get<std::size_t>()];
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t begin = file.size() - whole->binary.size() + view.value("byteOffset", std::size_t{0}) +
                              accessor.value("byteOffset", std::size_t{0});
    for (const float number :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e7F})
      for (std::size_t coordinate = 0; coordinate < 3; ++coordinate) {
        std::string damaged = file;
        std::memcpy(damaged.data() + begin + sizeof(float) * coordinate, &number, sizeof(float));
        const auto character = read(damaged);
        ASSERT_FALSE(character) << attribute << ' ' << number << " at " << coordinate;
        EXPECT_THAT(character.error().text(), HasSubstr("its meshes are damaged"));
      }
  }
}

TEST_F(WornCharacters, NoDamagedByteOfItsNumbersIsReadBeyondTheMesh) {
  const std::string file = skinned_rig(Naming::Vrm1);
  const auto whole = parse_glb(file, "figure.glb");
  const std::size_t first = file.size() - whole->binary.size();
  for (std::size_t at = first; at < file.size(); at += 7) {
    std::string damaged = file;
    damaged[at] = '\xff';
    if (const auto character = read(damaged)) {
      for (const auto& triangle : (*character)->skin.triangles)
        for (const std::int32_t point : triangle)
          ASSERT_LT(static_cast<std::size_t>(point), (*character)->skin.points.size());
      for (const CharacterSkin::Share& share : (*character)->skin.shares)
        for (const std::uint16_t carrier : share.carriers)
          ASSERT_LT(carrier, (*character)->skin.carriers.size());
    }
  }
}

}  // namespace
}  // namespace abrazo::worn_character_test
