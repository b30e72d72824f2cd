#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::library_command_test {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class LibraryCommand : public CommandLineTest {
 protected:
  /// Builds from a manifest with these fields in its only take, beside the two motions.
  Outcome build_with(const std::string& fields) const {
    write("demo/m.json",
          "{\"takes\": [{\"name\": \"t\", \"metres_per_unit\": 1, " + fields +
              " \"a\": {\"motion\": \"salsa_01_a.bvh\"}, \"b\": {\"motion\": \"salsa_01_b.bvh\"}}]}");
    return run("library build demo/m.json -o t.h5 --rate 5");
  }
  Outcome build_with_labels(const std::string& rows) const {
    write("demo/l.csv", "take,start_frame,end_frame,label\n" + rows);
    return build_with("\"labels\": \"l.csv\",");
  }
};

TEST_F(LibraryCommand, InfoIsOneJsonObjectThatCountsTheDemo) {
  make_library();
  const Outcome outcome = run("library info demo.h5 --json");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  const auto info = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(info["rate_hz"], 60);
  EXPECT_EQ(info["pairs"], info["frames"]);
  EXPECT_EQ(info["roles"]["a"], info["pairs"]);
  EXPECT_EQ(info["bytes"], std::filesystem::file_size(path("demo.h5")));
  EXPECT_THAT(info["joints"], SizeIs(25));
  ASSERT_THAT(info["takes"], SizeIs(1));
  EXPECT_EQ(info["takes"][0]["name"], "salsa_01");
  ASSERT_THAT(info["bodies"], SizeIs(2));
  EXPECT_THAT(info["bodies"][0]["bone_lengths"], SizeIs(24));
}

TEST_F(LibraryCommand, APairHasTheContractsFields) {
  make_library();
  const Outcome outcome = run("library pair demo.h5 salsa_01 120 --json");
  EXPECT_EQ(outcome.status, 0);
  const auto pair = nlohmann::json::parse(outcome.out);
  for (const char* body : {"active", "passive"}) {
    EXPECT_THAT(pair[body], SizeIs(25));
    EXPECT_THAT(pair[body], Each(SizeIs(3)));
  }
  EXPECT_EQ(pair["active"][0], nlohmann::json({0, 0, 0}));
  EXPECT_THAT(pair["features"], SizeIs(15));
  EXPECT_THAT(pair["tetrahedra"], Each(SizeIs(4)));
  EXPECT_THAT(pair["edges"], Each(SizeIs(2)));
  for (const auto& edge : pair["edges"]) EXPECT_LT(edge[1].get<int>(), 50);
  EXPECT_TRUE(pair["label"].is_string());
  EXPECT_EQ(pair["role"], "a");
}

TEST_F(LibraryCommand, APairThatIsNotThereIsAnsweredWithWhatIs) {
  make_library();
  expect_failure(run("library pair demo.h5 salsa_09 0"), "there is no take \"salsa_09\"; there are salsa_01");
  expect_failure(run("library pair demo.h5 salsa_01 99999"),
                 "frame 99999 does not exist; its frames are 0 to");
  expect_failure(run("library pair demo.h5 salsa_01 0 --swapped"), "leave out --swapped");
  ASSERT_EQ(run("library build demo/manifest.json -o thin.h5 --rate 15").status, 0);
  expect_failure(run("library pair thin.h5 salsa_01 6"), "ask for a multiple of 4");
}

TEST_F(LibraryCommand, FilesThatAreNoLibraryAreRefused) {
  make_library();
  write("text.h5", "hello\n");
  write("empty.h5", "");
  write("cut.h5", read("demo.h5").substr(0, 20000));
  expect_failure(run("library info gone.h5"), "gone.h5: cannot be opened");
  expect_failure(run("library info demo"), "demo: is a folder");
  expect_failure(run("library info text.h5"), "text.h5: is not an HDF5 file");
  expect_failure(run("library info empty.h5"), "empty.h5: is not an HDF5 file");
  expect_failure(run("library info cut.h5"), "cut.h5: is cut short or damaged");
}

TEST_F(LibraryCommand, ExcludeTakesOneNameAndLeavesTheWordsThatFollow) {
  make_demo("0.5");
  EXPECT_EQ(run("library build --exclude salsa_01 demo/manifest.json -o rest.h5").status, 0);
  const auto info = nlohmann::json::parse(run("library info rest.h5 --json").out);
  ASSERT_THAT(info["takes"], SizeIs(1));
  EXPECT_EQ(info["takes"][0]["name"], "salsa_02");
  expect_failure(run("library build demo/manifest.json -o no.h5 --exclude salsa_09"), "\"salsa_09\"");
  expect_failure(run("library build demo/manifest.json -o no.h5 --exclude salsa_01 --exclude salsa_02"),
                 "no take is left");
  EXPECT_THAT(names(), Not(Contains("no.h5")));
}

TEST_F(LibraryCommand, AManifestsMistakesAreNamedWithTheirPlace) {
  make_demo();
  write("broken.json", "{\"takes\": [\n{\"name\": \"t\",\n}]}");
  write("list.json", "[]");
  write("none.json", "{\"takes\": []}");
  expect_failure(run("library build gone.json -o t.h5"), "gone.json: cannot be opened");
  expect_failure(run("library build broken.json -o t.h5"), "broken.json:3");
  expect_failure(run("library build list.json -o t.h5"), "expected an object");
  expect_failure(run("library build none.json -o t.h5"), "takes: is empty");
  expect_failure(build_with("\"fps\": \"60\","), "takes[0].fps: expected a number above 0");
  expect_failure(build_with("\"roles\": \"c\","), "takes[0].roles");
  expect_failure(build_with("\"labels\": \"gone.csv\","), "gone.csv: cannot be opened");
  EXPECT_THAT(names(), Not(Contains("t.h5")));
}

TEST_F(LibraryCommand, AMisspeltKeyOfTheManifestIsWarnedOf) {
  make_demo();
  const Outcome outcome = build_with("\"fsp\": 60,");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("abrazo: warning: demo/m.json: takes[0]: \"fsp\" is not read"));
}

TEST_F(LibraryCommand, LabelsThatOverlapOrRunBackwardsAreRefusedWithTheLine) {
  make_demo();
  expect_failure(build_with_labels("t,0,10,turn\nt,5,15,hold\n"), "l.csv:3: frames 5-15 overlap");
  expect_failure(build_with_labels("t,10,5,turn\n"), "l.csv:2");
  expect_failure(build_with_labels("t,0,x,turn\n"), "l.csv:2: expected end_frame");
  EXPECT_EQ(build_with_labels("t,0,10,turn\nt,10,15,hold\n").status, 0);
}

TEST_F(LibraryCommand, NamesInALibraryNeitherSteerATerminalNorPassForLinesOfTheAnswer) {
  make_demo();
  const std::string salsa = path("demo/salsa_01_").string();
  const nlohmann::json take = {{"name", hostile_name},
                               {"metres_per_unit", 1},
                               {"labels", "moves.json"},
                               {"a", {{"motion", salsa + "a.bvh"}}},
                               {"b", {{"motion", salsa + "b.bvh"}}}};
  write("moves.json",
        nlohmann::json{{"tiers",
                        {{{"name", "move"},
                          {"kind", "move"},
                          {"intervals", {{{"start_s", 0}, {"end_s", 5}, {"value", hostile_name}}}}}}}}
            .dump());
  write("m.json", nlohmann::json{{"name", hostile_name}, {"takes", {take}}}.dump());
  const Outcome built = run("library build m.json -o t.h5 --rate 5");
  ASSERT_EQ(built.status, 0) << built.err;
  const Outcome info = run("library info t.h5");
  expect_harmless(info.out);
  EXPECT_THAT(info.out, HasSubstr("label name?"));
  expect_harmless(run({"library", "pair", "t.h5", hostile_name, "0"}).out);
  expect_harmless(run({"library", "pair", "t.h5", "other", "0"}).err);
  expect_harmless(run({"library", "pair", "t.h5", hostile_name, "99999"}).err);
  expect_harmless(run("suggest t.h5 --take other").err);
  // Programs get the name as it is.
  EXPECT_EQ(nlohmann::json::parse(run("library info t.h5 --json").out)["takes"][0]["name"], hostile_name);
}

}  // namespace
}  // namespace abrazo::test::library_command_test
