#include "core/library/takes/manifest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abrazo::manifest_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string whole_take = R"({"name": "t1", "fps": 60, "metres_per_unit": 0.0564444,
  "a": {"motion": "60_01.amc", "skeleton": "60.asf"}, "b": {"motion": "sub/61_01.amc", "skeleton": "/abs/61.asf"},
  "roles": "a", "labels": "moves.csv"})";

std::string manifest_of(const std::string& takes) {
  return R"({"name": "dance", "takes": [)" + takes + "]}";
}

/// A take with one key replaced or added.
std::string take_with(const std::string& entry) {
  return R"({"name": "t1", "a": {"motion": "a.bvh"}, "b": {"motion": "b.bvh"}, )" + entry + "}";
}

Error refusal(const std::string& json) {
  const auto manifest = parse_manifest(json, "data/manifest.json");
  EXPECT_FALSE(manifest.ok()) << json;
  return manifest.ok() ? Error{} : manifest.error();
}

TEST(Manifest, ReadsEverythingThatATakeCanSay) {
  const auto manifest = parse_manifest(manifest_of(whole_take), "data/manifest.json");
  ASSERT_TRUE(manifest.ok()) << manifest.error().text();
  EXPECT_EQ(manifest->name, "dance");
  ASSERT_EQ(manifest->takes.size(), 1U);
  const Manifest::Take& take = manifest->takes[0];
  EXPECT_EQ(take.name, "t1");
  EXPECT_EQ(take.fps, 60);
  EXPECT_EQ(take.metres_per_unit, 0.0564444);
  EXPECT_THAT(manifest->warnings, IsEmpty());
}

TEST(Manifest, PathsAreRelativeToItsFolder) {
  const auto manifest = parse_manifest(manifest_of(whole_take), "data/manifest.json");
  ASSERT_TRUE(manifest.ok());
  const Manifest::Take& take = manifest->takes[0];
  EXPECT_EQ(take.a.motion, "data/60_01.amc");
  EXPECT_EQ(take.a.skeleton, "data/60.asf");
  EXPECT_EQ(take.b.motion, "data/sub/61_01.amc");
  EXPECT_EQ(take.b.skeleton, "/abs/61.asf");
  EXPECT_EQ(take.labels, "data/moves.csv");
}

TEST(Manifest, OneLetterIsTheRoleOfEveryFrame) {
  const auto manifest = parse_manifest(manifest_of(take_with(R"("roles": "b")")), "m.json");
  ASSERT_TRUE(manifest.ok());
  ASSERT_EQ(manifest->takes[0].roles.size(), 1U);
  EXPECT_EQ(manifest->takes[0].roles[0].start, 0);
  EXPECT_EQ(manifest->takes[0].roles[0].active, ActivePerformer::B);
}

TEST(Manifest, UnknownOrAbsentRolesAreNoIntervals) {
  for (const char* roles : {R"("roles": "unknown")", R"("fps": 30)"}) {
    const auto manifest = parse_manifest(manifest_of(take_with(roles)), "m.json");
    ASSERT_TRUE(manifest.ok());
    EXPECT_THAT(manifest->takes[0].roles, IsEmpty());
  }
}

TEST(Manifest, ReadsRoleIntervals) {
  const auto manifest = parse_manifest(
      manifest_of(take_with(
          R"("roles": [{"start": 0, "end": 120, "active": "a"}, {"start": 120, "end": 200, "active": "unknown"}])")),
      "m.json");
  ASSERT_TRUE(manifest.ok()) << manifest.error().text();
  ASSERT_EQ(manifest->takes[0].roles.size(), 2U);
  EXPECT_EQ(manifest->takes[0].roles[0].end, 120);
  EXPECT_EQ(manifest->takes[0].roles[1].active, ActivePerformer::Unknown);
}

TEST(Manifest, NamesItselfAfterTheFileWhenItHasNoName) {
  const auto manifest = parse_manifest(R"({"takes": [)" + whole_take + "]}", "data/salsa.json");
  ASSERT_TRUE(manifest.ok());
  EXPECT_EQ(manifest->name, "salsa");
}

TEST(Manifest, AnOrderOfJointsIsABuiltInOneOrAFileBesideIt) {
  const auto manifest = parse_manifest(
      R"({"takes": [{"name": "one", "a": {"motion": "a.npy", "joints": "lafan22"},
          "b": {"motion": "b.npy", "joints": "orders/mine.txt"}}]})",
      "data/m.json");
  ASSERT_TRUE(manifest) << manifest.error().text();
  EXPECT_EQ(manifest->takes[0].a.joints, "lafan22");
  EXPECT_EQ(manifest->takes[0].b.joints, "data/orders/mine.txt");
  EXPECT_THAT(manifest->warnings, IsEmpty());
}

TEST(Manifest, WarnsOfKeysThatNobodyReads) {
  const auto manifest = parse_manifest(manifest_of(take_with(R"("frame_rate": 60)")), "m.json");
  ASSERT_TRUE(manifest.ok());
  EXPECT_THAT(manifest->warnings, ElementsAre(HasSubstr("m.json: takes[0]: \"frame_rate\" is not read")));
}

TEST(Manifest, SaysTheLineWhereItIsNotJson) {
  const Error error = refusal("{\"name\": \"x\",\n \"takes\": [,]}");
  EXPECT_EQ(error.where, "data/manifest.json:2");
  EXPECT_THAT(error.message, HasSubstr("not JSON"));
}

struct BrokenManifest {
  const char* what;
  std::string json;
  const char* where;
  const char* message;
};

class BrokenManifests : public testing::TestWithParam<BrokenManifest> {};

TEST_P(BrokenManifests, AreRefusedWithThePlaceAndWhatToChange) {
  const Error error = refusal(GetParam().json);
  EXPECT_EQ(error.where, GetParam().where);
  EXPECT_THAT(error.message, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Manifest, BrokenManifests,
    testing::Values(
        BrokenManifest{"ListAtTheTop", "[]", "data/manifest.json", "expected an object"},
        BrokenManifest{"NoTakes", "{}", "data/manifest.json", "\"takes\" is missing"},
        BrokenManifest{"EmptyTakes", manifest_of(""), "data/manifest.json: takes", "is empty"},
        BrokenManifest{"TakesAsObject", R"({"takes": {}})", "data/manifest.json: takes", "expected a list"},
        BrokenManifest{"NoTakeName", manifest_of(R"({"a": {}})"), "data/manifest.json: takes[0]",
                       "\"name\" is missing"},
        BrokenManifest{"NoMotion",
                       manifest_of(whole_take + R"(, {"name": "t2", "a": {"motion": "x"}, "b": {}})"),
                       "data/manifest.json: takes[1].b", "\"motion\" is missing"},
        BrokenManifest{"MotionAsNumber",
                       manifest_of(R"({"name": "t", "a": {"motion": "x"}, "b": {"motion": 3}})"),
                       "data/manifest.json: takes[0].b.motion", "expected a text in quotes, found number"},
        BrokenManifest{"DuplicateName", manifest_of(whole_take + "," + whole_take),
                       "data/manifest.json: takes[1]", "\"t1\" is already taken"},
        BrokenManifest{"ZeroFps", manifest_of(take_with(R"("fps": 0)")), "data/manifest.json: takes[0].fps",
                       "above 0, found 0"},
        BrokenManifest{"FpsAsText", manifest_of(take_with(R"("fps": "60")")),
                       "data/manifest.json: takes[0].fps", "expected a number"},
        BrokenManifest{"UnknownRole", manifest_of(take_with(R"("roles": "leader")")),
                       "data/manifest.json: takes[0].roles", "found \"leader\""},
        BrokenManifest{"NegativeRoleFrame",
                       manifest_of(take_with(R"("roles": [{"start": -1, "end": 3, "active": "a"}])")),
                       "data/manifest.json: takes[0].roles[0].start", "found -1"},
        BrokenManifest{"EmptyRole",
                       manifest_of(take_with(R"("roles": [{"start": 3, "end": 3, "active": "a"}])")),
                       "data/manifest.json: takes[0].roles[0]", "not after its start"},
        BrokenManifest{
            "OverlappingRoles",
            manifest_of(take_with(
                R"("roles": [{"start": 0, "end": 9, "active": "a"}, {"start": 8, "end": 12, "active": "b"}])")),
            "data/manifest.json: takes[0].roles[1]", "before the one above it ends (9)"}),
    [](const auto& test) { return test.param.what; });

TEST(Manifest, ANumberThatNoDoubleHoldsIsRefusedWhereverItStands) {
  EXPECT_THAT(refusal(manifest_of(take_with(R"("fps": 1e999)"))).text(),
              HasSubstr("a number that is too large"));
  EXPECT_THAT(refusal(R"({"unused": -31e308})").text(), HasSubstr("a number that is too large"));
}

TEST(Manifest, BracketsThatWouldTakeTheWholeStackAreRefused) {
  const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
  EXPECT_THAT(refusal(manifest_of(take_with("\"fps\": " + deep))).text(),
              HasSubstr("100 deep inside each other"));
}

TEST(Manifest, SaysWhichFileCannotBeOpened) {
  const auto manifest = read_manifest("no/such/manifest.json");
  ASSERT_FALSE(manifest.ok());
  EXPECT_THAT(manifest.error().text(), HasSubstr("no/such/manifest.json: cannot be opened"));
}

}  // namespace
}  // namespace abrazo::manifest_test
