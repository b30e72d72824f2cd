#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/limits.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/scenes/assimp_scene.hpp"
#include "core/motion/scenes/glb_writer.hpp"
#include "core/motion/scenes/scene_animation.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::scene_reader_test {
namespace {

using test::place;
using ::testing::HasSubstr;

std::vector<Clip> two_dancers(double fps) {
  std::vector<Clip> clips(2);
  for (std::size_t c = 0; c < 2; ++c) {
    clips[c].name = c == 0 ? "active" : "passive";
    clips[c].fps = fps;
    for (int f = 0; f < 50; ++f)
      clips[c].poses.push_back(
          test::moved(test::standing_pose(), 0.11 * f, Vec3(c == 0 ? 0.0 : 1.5, 0, 0.02 * f)));
  }
  return clips;
}

TEST(ReadScene, ReadsBackWhatTheGlbWriterWrote) {
  for (const double fps : {60.0, 120.0, 29.97}) {
    const std::vector<Clip> clips = two_dancers(fps);
    const auto motions = read_scene(*write_glb(clips), MotionFormat::Gltf, "pair.glb");
    ASSERT_TRUE(motions) << motions.error().text();
    ASSERT_EQ(motions->size(), 2U);
    for (std::size_t c = 0; c < 2; ++c) {
      const auto clip = import_clip((*motions)[c], {});
      ASSERT_TRUE(clip) << clip.error().text();
      EXPECT_EQ(clip->clip.name, clips[c].name);
      EXPECT_NEAR(clip->clip.fps, fps, 1e-3);
      ASSERT_EQ(clip->clip.poses.size(), 50U);
      double largest = 0;
      for (std::size_t f = 0; f < 50; ++f)
        largest = std::max(largest, (clip->clip.poses[f] - clips[c].poses[f]).rowwise().norm().maxCoeff());
      EXPECT_LT(largest, 1e-5) << "0.01 mm: rotations are written in single precision";
    }
  }
}

TEST(ReadScene, RefusesBracketsSoDeepThatReadingThemWouldTakeTheWholeStack) {
  const std::string deep = "{\"a\":" + std::string(2'000'000, '[');
  std::string glb("glTF\2\0\0\0", 8);
  for (const std::size_t number : {deep.size() + 20, deep.size()})
    for (unsigned byte = 0; byte < 4; ++byte) glb += static_cast<char>((number >> (8 * byte)) & 0xff);
  glb += "JSON" + deep;
  std::string records("Kaydara FBX Binary  \0\x1a\0\xe8\x1c\0\0", 27),
      collada = "<COLLADA version=\"1.4.1\">", fbx;
  constexpr std::uint32_t levels = 200'000, level_bytes = 13;
  const std::uint32_t whole = 27 + 2 * levels * level_bytes;
  for (std::uint32_t i = 0; i < levels; ++i) {
    const std::uint32_t end = whole - i * level_bytes;
    for (unsigned byte = 0; byte < 4; ++byte) records += static_cast<char>((end >> (8 * byte)) & 0xff);
    records += std::string(9, '\0');
    collada += "<node id='/>'><!-- </node> --><p/>";
    fbx += "a: \"}\" { ; }\n";
  }
  records.resize(whole);
  const std::vector<std::pair<std::string, MotionFormat>> files = {{deep, MotionFormat::Gltf},
                                                                   {glb, MotionFormat::Gltf},
                                                                   {records, MotionFormat::Fbx},
                                                                   {fbx, MotionFormat::Fbx},
                                                                   {collada, MotionFormat::Collada}};
  for (const auto& [bytes, format] : files) {
    const auto motions = read_scene(bytes, format, "deep");
    ASSERT_FALSE(motions);
    EXPECT_THAT(motions.error().text(),
                HasSubstr(format == MotionFormat::Gltf ? "has brackets more than 100 deep"
                                                       : "has elements more than 1000 deep"))
        << bytes.substr(0, 20);
  }
}

TEST(ReadScene, RefusesJsonOfMoreValuesThanASceneHas) {
  const auto refusal = [](std::size_t values) {
    return read_scene("{\"extras\":[" + std::string(values, ',') + "]}", MotionFormat::Gltf, "many.gltf")
        .error()
        .text();
  };
  EXPECT_THAT(refusal(limits::json_values - 2), HasSubstr("its JSON is damaged")) << "nothing but commas";
  EXPECT_THAT(refusal(limits::json_values - 1), HasSubstr("many.gltf: has more than 6 million values"));
}

TEST(ReadScene, SaysWhatIsWrongWithABrokenFile) {
  const auto message = [](std::string_view bytes, MotionFormat format) {
    const auto motions = read_scene(bytes, format, "broken.glb");
    return motions ? "read" : motions.error().text();
  };
  const std::string whole = *write_glb(two_dancers(60));
  EXPECT_THAT(message(whole.substr(0, 100), MotionFormat::Gltf), HasSubstr("cannot be read as glTF"));
  EXPECT_THAT(message("Kaydara FBX Binary  \0rubbish", MotionFormat::Fbx),
              HasSubstr("cannot be read as FBX"));
  EXPECT_THAT(message("<COLLADA><rubbish", MotionFormat::Collada), HasSubstr("cannot be read as Collada"));
}

TEST(ReadScene, TwoArmaturesWithTheSameBonesAreRefused) {
  std::vector<Clip> clips = two_dancers(60);
  clips[0].name = "anna", clips[1].name = "bert";
  std::string bytes = *write_glb(clips);
  ASSERT_EQ(read_scene(bytes, MotionFormat::Gltf, "pair.glb")->size(), 2U);
  for (auto at = bytes.find("bert"); at != std::string::npos; at = bytes.find("bert", at))
    bytes.replace(at, 4, "anna");
  const auto motions = read_scene(bytes, MotionFormat::Gltf, "pair.glb");
  ASSERT_FALSE(motions);
  EXPECT_THAT(motions.error().text(), HasSubstr("pair.glb: 2 nodes are named 'anna"));
  EXPECT_THAT(motions.error().text(), HasSubstr("rename one armature's bones"));
}

/// A chain of bones along x, each 1 long, the first of which turns about z by 90 degrees in a second.
std::vector<SceneNode> turning_chain() {
  std::vector<SceneNode> nodes(10);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    nodes[n].name = n == 0 ? "Armature" : "B" + std::to_string(n);
    nodes[n].parent = static_cast<int>(n) - 1;
    nodes[n].is_bone = n > 0;
    if (n > 1) nodes[n].rest.translation() = Vec3::UnitX();
  }
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
  for (int k = 0; k <= 50; ++k) {
    nodes[1].rotations.times_s.push_back(k / 50.0);
    nodes[1].rotations.values.push_back(Eigen::Quaterniond::Identity().slerp(k / 50.0, turned));
  }
  return nodes;
}

TEST(SceneAnimation, SamplesAtTheRateOfTheKeys) {
  const auto motions = skeletons_of(turning_chain(), std::nullopt, "chain");
  ASSERT_TRUE(motions) << motions.error().text();
  const NamedMotion& motion = motions->front();
  EXPECT_EQ(motion.fps, 50.0);
  ASSERT_EQ(motion.frames.size(), 51U);
  test::expect_near(place(motion, 0, "B9"), {8, 0, 0}, 1e-9);
  test::expect_near(place(motion, 50, "B9"), {0, 8, 0}, 1e-9);
  test::expect_near(place(motion, 25, "B2"), {std::sqrt(0.5), std::sqrt(0.5), 0}, 1e-9);
}

TEST(SceneAnimation, TakesHelperNodesIntoTheirNodesPlace) {
  std::vector<SceneNode> nodes = turning_chain();
  // The turn of B1 stands in a helper above it, as FBX has it.
  SceneNode helper = nodes[1];
  helper.name = "B1_$AssimpFbx$_Rotation", helper.is_helper = true, helper.is_bone = false;
  nodes[1].rotations = {};
  nodes.insert(nodes.begin() + 1, helper);
  for (std::size_t n = 2; n < nodes.size(); ++n) nodes[n].parent = static_cast<int>(n) - 1;
  const auto motions = skeletons_of(nodes, std::nullopt, "chain");
  ASSERT_TRUE(motions) << motions.error().text();
  const NamedMotion& motion = motions->front();
  EXPECT_EQ(motion.points.front(), "B1");
  EXPECT_EQ(motion.points.size(), 9U);
  test::expect_near(place(motion, 50, "B9"), {0, 8, 0}, 1e-9);
}

TEST(SceneAnimation, GivesEveryArmatureAMotion) {
  std::vector<SceneNode> nodes(1);
  nodes[0].name = "Scene";
  for (const char* who : {"Anna", "Ben"}) {
    const int first = static_cast<int>(nodes.size());
    for (SceneNode node : turning_chain()) {
      node.parent = node.parent < 0 ? 0 : node.parent + first;
      if (node.name == "Armature") node.name = who;
      nodes.push_back(node);
    }
  }
  const auto motions = skeletons_of(nodes, std::nullopt, "pair");
  ASSERT_TRUE(motions);
  ASSERT_EQ(motions->size(), 2U);
  EXPECT_EQ((*motions)[0].name, "Anna");
  EXPECT_EQ((*motions)[1].name, "Ben");
  EXPECT_EQ((*motions)[1].points.size(), 9U);
}

TEST(SceneAnimation, SaysWhatIsMissing) {
  std::vector<SceneNode> nodes = turning_chain();
  nodes[1].rotations = {};
  EXPECT_THAT(skeletons_of(nodes, std::nullopt, "still.fbx").error().text(), HasSubstr("holds no animation"));
  nodes.resize(4);
  EXPECT_THAT(skeletons_of(nodes, std::nullopt, "chair.fbx").error().text(),
              HasSubstr("no skeleton of at least 8 bones"));
}

}  // namespace
}  // namespace abrazo::scene_reader_test
