// What hangs below what in a scene file, told before a reader is let at it that descends by recursion and
// copies.
#include "core/motion/scenes/scene_hierarchy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/scenes/assimp_scene.hpp"
#include "core/motion/scenes/fbx_records.hpp"
#include "core/motion/scenes/xml_tags.hpp"

namespace abrazo::scene_hierarchy_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

std::string refusal(const std::string& bytes, MotionFormat format) {
  const auto motions = read_scene(bytes, format, "scene");
  return motions ? "read" : motions.error().text();
}

std::string gltf(const std::string& nodes, const std::string& scene = "0") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + scene + R"(]}],"nodes":[)" + nodes +
         "]}";
}

std::string collada(const std::string& library, const std::string& scene) {
  return "<COLLADA version=\"1.4.1\"><library_nodes>" + library +
         "</library_nodes><library_visual_scenes><visual_scene id=\"s\">" + scene +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url=\"#s\"/></scene></COLLADA>";
}

std::string fbx(const std::string& connections) {
  return "; FBX 7.3.0 project file\nObjects:  {\n\tModel: 1, \"Model::a\", \"LimbNode\" {\n\t}\n"
         "\tModel: 2, \"Model::b\", \"LimbNode\" {\n\t}\n}\nConnections:  {\n" +
         connections + "}\n";
}

std::string little_endian(std::uint64_t value, unsigned bytes) {
  std::string text;
  for (unsigned i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8 * i)) & 0xff);
  return text;
}

TEST(SceneHierarchy, NodesThatHangBelowThemselvesAreRefused) {
  EXPECT_THAT(refusal(gltf(R"({"children":[1]},{"children":[0]})"), MotionFormat::Gltf),
              HasSubstr("in a circle"));
  EXPECT_THAT(refusal(fbx("\tC: \"OO\",1,2\n\tC: \"OO\",2,1\n\tC: \"OO\",1,0\n"), MotionFormat::Fbx),
              HasSubstr("in a circle"));
  EXPECT_THAT(refusal(collada(R"(<node id="a"><instance_node url="#a"/></node>)",
                              R"(<node id="b"><instance_node url="#a"/></node>)"),
                      MotionFormat::Collada),
              HasSubstr("in a circle"));
}

TEST(SceneHierarchy, AChainThatIsTooDeepIsRefusedThoughNoBracketsAre) {
  std::string chain;
  for (int n = 0; n < 20'000; ++n) chain += "{\"children\":[" + std::to_string(n + 1) + "]},";
  EXPECT_THAT(refusal(gltf(chain + "{}"), MotionFormat::Gltf), HasSubstr("more than 1000 deep"));
}

TEST(SceneHierarchy, NodesThatWouldBeCopiedIntoMillionsAreRefused) {
  std::string doubling;
  for (int n = 0; n < 40; ++n)
    doubling += "{\"children\":[" + std::to_string(n + 1) + "," + std::to_string(n + 1) + "]},";
  EXPECT_THAT(refusal(gltf(doubling + "{}"), MotionFormat::Gltf), HasSubstr("more than 100000 nodes"));
  std::string same = "0", links;
  for (int n = 0; n < 200'000; ++n) same += ",0", links += "C: \"OO\",1,0\n";
  EXPECT_THAT(refusal(gltf("{}", same), MotionFormat::Gltf), HasSubstr("more than 100000 nodes"));
  EXPECT_THAT(refusal(fbx(links), MotionFormat::Fbx), HasSubstr("more than 100000 nodes"));
  std::string instances = R"(<node id="n0"/>)";
  for (int n = 1; n < 40; ++n) {
    const std::string below = "<node><instance_node url=\"#n" + std::to_string(n - 1) + "\"/></node>";
    instances += "<node id=\"n" + std::to_string(n) + "\">" + below + below + "</node>";
  }
  EXPECT_THAT(refusal(collada(instances, R"(<node id="b"><instance_node url="#n39"/></node>)"),
                      MotionFormat::Collada),
              HasSubstr("more than 100000 nodes"));
}

TEST(SceneHierarchy, WhatCannotBeToldIsRefused) {
  EXPECT_THAT(refusal(gltf(R"({"children":[7]})"), MotionFormat::Gltf),
              HasSubstr("node 0 has a node below it"));
  EXPECT_THAT(refusal(gltf("{}", "1"), MotionFormat::Gltf), HasSubstr("a scene has a node below it"));
  EXPECT_THAT(refusal(gltf(R"({"children":[1],"children":[0]},{})"), MotionFormat::Gltf),
              HasSubstr("two values of one key"));
  EXPECT_THAT(refusal(collada(R"(<node id="a"/>)", R"(<node><instance_node url="#&#97;"/></node>)"),
                      MotionFormat::Collada),
              HasSubstr("character references"));
}

std::string with_accessor(const std::string& accessor, const std::string& view) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{}],"buffers":[{"byteLength":68}],)"
         R"("bufferViews":[)" +
         view + R"(],"accessors":[)" + accessor + "]}";
}

/// Found by fuzzing: values were copied from beyond the end of a buffer.
TEST(SceneHierarchy, ValuesOutsideOfTheirBufferAreRefused) {
  const std::string view = R"({"buffer":0,"byteOffset":56,"byteLength":12})";
  const auto said = [](const std::string& file) {
    const auto hierarchy = scene_hierarchy(file, MotionFormat::Gltf, "scene");
    return hierarchy ? std::string("read") : hierarchy.error().text();
  };
  const auto vector_at = [](int offset, int count) {
    return R"({"bufferView":0,"componentType":5126,"type":"VEC3","byteOffset":)" + std::to_string(offset) +
           R"(,"count":)" + std::to_string(count) + "}";
  };
  EXPECT_EQ(said(with_accessor(vector_at(0, 1), view)), "read");
  for (const std::string& accessor :
       {vector_at(5, 1), vector_at(0, 2), std::string(R"({"bufferView":0,"type":"VEC3","count":1})"),
        std::string(R"({"bufferView":1,"componentType":5126,"type":"VEC3","count":1})"),
        std::string(R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":-1})")})
    EXPECT_THAT(said(with_accessor(accessor, view)), HasSubstr("values of accessor 0 lie outside"));
  EXPECT_THAT(said(with_accessor(vector_at(0, 1), R"({"buffer":0,"byteOffset":60,"byteLength":12})")),
              HasSubstr("values of accessor 0 lie outside"))
      << "the view itself leaves the buffer";
  EXPECT_THAT(
      said(with_accessor(vector_at(0, 1), R"({"buffer":0,"byteOffset":0,"byteLength":60,"byteStride":64})")),
      ::testing::StrEq("read"));
}

TEST(SceneHierarchy, OfVersionOneGoesByNames) {
  const auto read =
      scene_hierarchy(R"({"scenes":{"s":{"nodes":["b"]}},"nodes":{"a":{},"b":{"children":["a"]}}})",
                      MotionFormat::Gltf, "one.gltf");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_THAT(*read, ElementsAre(IsEmpty(), ElementsAre(0), ElementsAre(1)));
}

TEST(FbxLinks, AreTheSameFromTextAndFromRecords) {
  std::string records("Kaydara FBX Binary  \0\x1a\0", 23);
  records += little_endian(7300, 4);
  const auto record = [&records](const std::string& name, const std::string& properties) {
    const std::size_t whole = 13 + name.size() + properties.size();
    records += little_endian(records.size() + whole, 4) + little_endian(3, 4) +
               little_endian(properties.size(), 4) + static_cast<char>(name.size()) + name + properties;
  };
  const auto number = [](std::uint64_t value) { return "L" + little_endian(value, 8); };
  const auto word = [](const std::string& text) { return "S" + little_endian(text.size(), 4) + text; };
  record("Model", number(1) + word("a") + word("LimbNode"));
  record("Model", number(2) + word("b") + word("LimbNode"));
  record("C", word("OO") + number(1) + number(0));
  record("C", word("OP") + number(2) + number(1));
  for (const FbxLinks& links :
       {fbx_links(records), fbx_links(fbx("C: \"OO\",1,0 ; C: \"OO\",9,9\n\tC: \"OP\",2,1, \"d|X\"\n"))}) {
    EXPECT_THAT(links.models, ElementsAre(1, 2));
    EXPECT_THAT(links.connections, UnorderedElementsAre(Pair(1, 0), Pair(2, 1)));
  }
}

TEST(FbxLinks, EndWhereTheFileIsCutShort) {
  const std::string whole = fbx("C: \"OO\",1,0\n");
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_LE(fbx_links(whole.substr(0, size)).models.size(), 2U);
}

TEST(XmlTags, CommentsAndDataAreNone) {
  std::vector<std::string> tags;
  each_xml_tag("<?xml version='1.0'?><a x='>'><!-- <b> --><![CDATA[<c>]]><d key = \"v\" /></a",
               [&](const XmlTag& tag) {
                 tags.push_back((tag.closes ? "/" : "") + std::string(tag.name) + (tag.is_empty ? "/" : "") +
                                std::string(tag.attribute("key")));
               });
  EXPECT_THAT(tags, ElementsAre("a", "d/v", "/a"));
}

}  // namespace
}  // namespace abrazo::scene_hierarchy_test
