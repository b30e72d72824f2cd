#include "core/motion/scenes/glb_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::glb_writer_test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

/// A GLB taken apart by hand, from the specification (glTF 2.0, section 4): header, JSON chunk, BIN chunk.
struct Glb {
  explicit Glb(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(bytes, 4), 2U);
    EXPECT_EQ(word(bytes, 8), bytes.size());
    const std::size_t json_bytes = word(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    gltf = json::parse(bytes.substr(20, json_bytes));
    EXPECT_EQ((20 + json_bytes) % 4, 0U);
    EXPECT_EQ(bytes.substr(20 + json_bytes + 4, 4), std::string("BIN\0", 4));
    buffer = bytes.substr(20 + json_bytes + 8, word(bytes, 20 + json_bytes));
    EXPECT_GE(buffer.size(), gltf["buffers"][0]["byteLength"].get<std::size_t>());
  }

  /// The numbers of an accessor of floats, one row each.
  std::vector<std::vector<double>> floats(int number) const {
    const json& accessor = gltf["accessors"][static_cast<std::size_t>(number)];
    EXPECT_EQ(accessor["componentType"], 5126);
    const std::map<std::string, std::size_t> widths = {{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    const std::size_t width = widths.at(accessor["type"]);
    const json& view = gltf["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::size_t at = view.value("byteOffset", 0) + accessor.value("byteOffset", 0);
    std::vector<std::vector<double>> rows(accessor["count"].get<std::size_t>(), std::vector<double>(width));
    for (auto& row : rows)
      for (double& value : row) {
        float stored = 0;
        std::memcpy(&stored, buffer.data() + at, 4);
        value = static_cast<double>(stored);
        at += 4;
      }
    return rows;
  }

  /// Number of the node with this name; -1 when there is none or more than one.
  int node(const std::string& name) const {
    int found = -1;
    for (std::size_t n = 0; n < gltf["nodes"].size(); ++n)
      if (gltf["nodes"][n]["name"] == name) found = found < 0 ? static_cast<int>(n) : -1;
    return found;
  }

  json gltf;
  std::string buffer;
};

/// The nodes of a GLB moved by its animation, as a viewer would.
class Player {
 public:
  explicit Player(const Glb& glb) : glb_(glb) {
    parents_.assign(glb.gltf["nodes"].size(), -1);
    for (std::size_t n = 0; n < parents_.size(); ++n)
      for (const int child : glb.gltf["nodes"][n].value("children", json::array()))
        parents_[static_cast<std::size_t>(child)] = static_cast<int>(n);
    const json& animation = glb.gltf["animations"].at(0);
    for (const json& channel : animation["channels"]) {
      const json& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
      EXPECT_EQ(sampler.value("interpolation", "LINEAR"), "LINEAR");
      const auto times = glb.floats(sampler["input"]);
      Track track{{}, glb.floats(sampler["output"])};
      for (const auto& time : times) track.times_s.push_back(time[0]);
      EXPECT_EQ(track.times_s.size(), track.values.size());
      tracks_[{channel["target"]["node"], channel["target"]["path"]}] = track;
    }
  }

  struct Track {
    std::vector<double> times_s;
    std::vector<std::vector<double>> values;
  };
  using Target = std::pair<int, std::string>;  ///< node, path
  const std::map<Target, Track>& tracks() const { return tracks_; }
  const Track* find(int node, const std::string& path) const {
    const Target target(node, path);
    const auto found = tracks_.find(target);
    return found == tracks_.end() ? nullptr : &found->second;
  }

  Eigen::Isometry3d world(int node, std::size_t key) const {
    const json& facts = glb_.gltf["nodes"][static_cast<std::size_t>(node)];
    std::vector<double> t = facts.value("translation", std::vector<double>{0, 0, 0});
    std::vector<double> r = facts.value("rotation", std::vector<double>{0, 0, 0, 1});
    if (const Track* track = find(node, "translation")) t = track->values[key];
    if (const Track* track = find(node, "rotation")) r = track->values[key];
    const Eigen::Quaterniond rotation(r[3], r[0], r[1], r[2]);
    EXPECT_NEAR(rotation.norm(), 1, 1e-5);
    const Eigen::Isometry3d local = Eigen::Translation3d(t[0], t[1], t[2]) * rotation.normalized();
    const int parent = parents_[static_cast<std::size_t>(node)];
    return parent < 0 ? local : world(parent, key) * local;
  }

 private:
  const Glb& glb_;
  std::vector<int> parents_;
  std::map<Target, Track> tracks_;
};

std::string written(const std::vector<Clip>& clips) {
  const auto glb = write_glb(clips);
  if (!glb) ADD_FAILURE() << glb.error().text();
  return glb ? *glb : std::string();
}

double largest_error_m(const Glb& glb, const Player& player, const Clip& clip, const std::string& prefix) {
  double largest = 0;
  for (int j = 0; j < joint_count; ++j) {
    const int node = glb.node(prefix + std::string(joint_names[static_cast<std::size_t>(j)]));
    if (node < 0) return std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < clip.poses.size(); ++f)
      largest =
          std::max(largest, (player.world(node, f).translation() - clip.poses[f].row(j).transpose()).norm());
  }
  return largest;
}

Clip swinging(const std::string& name, unsigned seed = 4, int frames = 90) {
  Clip clip = test::swinging_take(name, frames, seed).a;
  clip.name = name;
  return clip;
}

std::size_t translation_tracks(const Player& player) {
  std::size_t count = 0;
  for (const auto& [target, track] : player.tracks()) count += target.second == "translation" ? 1 : 0;
  return count;
}

TEST(GlbWriter, TheNodesStandWhereTheJointsAre) {
  const Clip clip = swinging("dancer");
  const Glb glb(written({clip}));
  EXPECT_LT(largest_error_m(glb, Player(glb), clip, ""), 1e-4);
}

TEST(GlbWriter, FarFromTheOriginToo) {
  Clip clip = swinging("dancer");
  for (Pose& pose : clip.poses) pose = test::moved(pose, 2.0, Vec3(12, 0.5, -9));
  const Glb glb(written({clip}));
  EXPECT_LT(largest_error_m(glb, Player(glb), clip, ""), 1e-4);
}

TEST(GlbWriter, BonesThatChangeTheirLengthAreFollowed) {
  Clip clip = swinging("soft");
  std::mt19937 random(5);
  for (Pose& pose : clip.poses) pose = test::shaken(pose, 0.02, random);
  const Glb glb(written({clip}));
  const Player player(glb);
  EXPECT_LT(largest_error_m(glb, player, clip, ""), 1e-4);
  EXPECT_GE(translation_tracks(player), static_cast<std::size_t>(joint_count));
}

TEST(GlbWriter, RigidBonesNeedNoTranslationsButTheRoots) {
  const Glb glb(written({swinging("rigid")}));
  EXPECT_EQ(translation_tracks(Player(glb)), 1U);
}

TEST(GlbWriter, TwoCharactersOfDifferentLengthAndRateShareAnAnimation) {
  Clip one = swinging("active", 4, 90), two = swinging("passive", 7, 31);
  two.fps = 20;
  const Glb glb(written({one, two}));
  const Player player(glb);
  EXPECT_THAT(glb.gltf["animations"], SizeIs(1));
  EXPECT_THAT(glb.gltf["skins"], SizeIs(2));
  EXPECT_LT(largest_error_m(glb, player, one, "active:"), 1e-4);
  EXPECT_LT(largest_error_m(glb, player, two, "passive:"), 1e-4);
  EXPECT_NEAR(player.find(glb.node("active:root"), "translation")->times_s.back(), 89 / 60.0, 1e-6);
  EXPECT_NEAR(player.find(glb.node("passive:root"), "translation")->times_s.back(), 30 / 20.0, 1e-6);
}

TEST(GlbWriter, NeighbouringKeysTurnTheShortWay) {
  Clip clip = swinging("spin", 4, 240);
  for (std::size_t f = 0; f < clip.poses.size(); ++f)
    clip.poses[f] = test::moved(clip.poses[f], 0.1 * static_cast<double>(f), Vec3::Zero());
  const Glb glb(written({clip}));
  const Player player(glb);
  for (const auto& [target, track] : player.tracks()) {
    if (target.second != "rotation") continue;
    for (std::size_t k = 1; k < track.values.size(); ++k) {
      double dot = 0;
      for (std::size_t i = 0; i < 4; ++i) dot += track.values[k][i] * track.values[k - 1][i];
      ASSERT_GT(dot, 0) << glb.gltf["nodes"][static_cast<std::size_t>(target.first)]["name"];
    }
  }
}

TEST(GlbWriter, TheSkinBindsATPoseOverTheOrigin) {
  const Glb glb(written({swinging("dancer")}));
  const json& skin = glb.gltf["skins"][0];
  const auto inverse_binds = glb.floats(skin["inverseBindMatrices"]);
  ASSERT_EQ(inverse_binds.size(), skin["joints"].size());
  std::map<std::string, Vec3> places;
  for (std::size_t i = 0; i < inverse_binds.size(); ++i) {
    const auto& m = inverse_binds[i];  // columns: a translation stands in the last one
    const std::string name = glb.gltf["nodes"][skin["joints"][i].get<std::size_t>()]["name"];
    places[name] = -Vec3(m[12], m[13], m[14]);
    EXPECT_THAT(std::vector<double>(m.begin(), m.begin() + 12),
                ElementsAre(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0));
  }
  for (const std::string_view joint : joint_names) ASSERT_TRUE(places.contains(std::string(joint))) << joint;
  EXPECT_NEAR(places["root"].x(), 0, 1e-6);
  EXPECT_NEAR(places["root"].z(), 0, 1e-6);
  EXPECT_NEAR(places["ltoes"].y(), 0, 1e-6);                        // on the floor
  EXPECT_NEAR(places["lhand"].y(), places["lclavicle"].y(), 1e-6);  // arms held sideways,
  EXPECT_GT(places["lhand"].x(), places["lclavicle"].x() + 0.4);    // the left one towards +X:
  EXPECT_GT(places["ltoes"].z(), places["lfoot"].z());              // so it faces +Z
  EXPECT_GT(places["head"].y(), 1.3);
}

TEST(GlbWriter, EveryBoneHasABodyThatMovesWithIt) {
  const Glb glb(written({swinging("dancer")}));
  const json& primitive = glb.gltf["meshes"][0]["primitives"][0];
  const auto corners = glb.floats(primitive["attributes"]["POSITION"]);
  const auto normals = glb.floats(primitive["attributes"]["NORMAL"]);
  ASSERT_EQ(normals.size(), corners.size());
  for (const auto& normal : normals) EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, 1e-5);
  for (const auto& weights : glb.floats(primitive["attributes"]["WEIGHTS_0"]))
    EXPECT_THAT(weights, ElementsAre(1, 0, 0, 0));
  int with_skin = 0;
  for (const json& node : glb.gltf["nodes"]) with_skin += node.contains("skin") ? 1 : 0;
  EXPECT_EQ(with_skin, 1);
}

TEST(GlbWriter, EachCharacterIsASkeletonOfItsOwnInItsOwnColour) {
  const Glb glb(written({swinging("active"), swinging("passive")}));
  for (const std::string name : {"active", "passive"}) {
    const json& group = glb.gltf["nodes"][static_cast<std::size_t>(glb.node(name))];
    EXPECT_THAT(group["children"], testing::Contains(glb.node(name + ":root")));
  }
  EXPECT_NE(glb.gltf["materials"][0]["pbrMetallicRoughness"],
            glb.gltf["materials"][1]["pbrMetallicRoughness"]);
}

TEST(GlbWriter, WhatItCannotWriteIsRefused) {
  const auto refusal = [](const std::vector<Clip>& clips) {
    const auto glb = write_glb(clips);
    return glb ? "written" : glb.error().text();
  };
  EXPECT_THAT(refusal({}), HasSubstr("no clip"));
  EXPECT_THAT(refusal({Clip{"a", 60, {}}}), HasSubstr("a: has no frames"));
  EXPECT_THAT(refusal({Clip{"a", 0, {test::standing_pose()}}}), HasSubstr("a: has no frame rate"));
  EXPECT_THAT(refusal({swinging("a"), swinging("a")}), HasSubstr("names that differ"));
  Clip broken = swinging("a");
  broken.poses[3](5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal({broken}), HasSubstr("a: frame 3: has a position that is not finite"));
}

TEST(GlbWriter, TheSameClipsGiveTheSameBytes) {
  EXPECT_EQ(written({swinging("a"), swinging("b")}), written({swinging("a"), swinging("b")}));
}

}  // namespace
}  // namespace abrazo::glb_writer_test
