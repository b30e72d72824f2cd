#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/cli/command_line_fixture.hpp"
#include "tests/support/captured_data.hpp"
#include "tests/support/humanoid_rig.hpp"

namespace abrazo::test::synth_command_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class SynthCommand : public CommandLineTest {
 protected:
  Outcome synth(const std::string& more) const {
    return run("synth --library demo.h5 --input demo/salsa_01_a.bvh " + more);
  }
};

/// Largest difference of the positions in `one` from those in `both`, whose columns have a prefix.
double largest_difference(const Table& one, const Table& both, const std::string& prefix) {
  double largest = one.rows.size() == both.rows.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < one.rows.size(); ++row)
    for (std::size_t column = 2; column < one.columns.size(); ++column)
      largest =
          std::max(largest, std::abs(one.rows[row][column] - both.at(row, prefix + one.columns[column])));
  return largest;
}

TEST_F(SynthCommand, SaysInJsonHowManyStepsItSolved) {
  make_library();
  const Outcome outcome = synth("--json --preset paper");
  EXPECT_EQ(outcome.status, 0);
  const auto summary = nlohmann::json::parse(outcome.out);
  const auto input = nlohmann::json::parse(run("motion info demo/salsa_01_a.bvh --json").out);
  EXPECT_EQ(summary["steps"], (input["frames"].get<int>() + 3) / 4);  // 15 of 60 frames a second
  EXPECT_EQ(summary["step_rate_hz"], 15);
  EXPECT_EQ(summary["failed"], 0);
  EXPECT_LT(summary["bone_length_max"].get<double>(), 1e-3);
  EXPECT_THAT(names(), ElementsAre("demo", "demo.h5"));
}

TEST_F(SynthCommand, BvhAndCsvHoldTheSameMotion) {
  make_library();
  ASSERT_EQ(synth("-o pair.csv --preset paper").status, 0);
  ASSERT_EQ(synth("-o pair.bvh --preset paper").status, 0);
  const Table pair = parse_table(read("pair.csv"));
  EXPECT_THAT(pair.columns, SizeIs(2 + 2 * 25 * 3));
  EXPECT_NEAR(pair.at(15, "time"), 1, 1e-12);
  ASSERT_EQ(run("motion positions pair.bvh --performer 1 -o active.csv").status, 0);
  ASSERT_EQ(run("motion positions pair.bvh --performer 2 -o passive.csv").status, 0);
  EXPECT_LT(largest_difference(parse_table(read("active.csv")), pair, "active."), 1e-3);
  EXPECT_LT(largest_difference(parse_table(read("passive.csv")), pair, "passive."), 1e-3);
}

TEST_F(SynthCommand, SplitWritesOneFileForEachBody) {
  make_library();
  ASSERT_EQ(synth("-o pair.csv").status, 0);
  ASSERT_EQ(synth("-o two.csv --split").status, 0);
  ASSERT_EQ(synth("-o two.bvh --split").status, 0);
  EXPECT_THAT(names(), ElementsAre("demo", "demo.h5", "pair.csv", "two_active.bvh", "two_active.csv",
                                   "two_passive.bvh", "two_passive.csv"));
  const Table pair = parse_table(read("pair.csv"));
  EXPECT_EQ(largest_difference(parse_table(read("two_active.csv")), pair, "active."), 0);
  EXPECT_EQ(largest_difference(parse_table(read("two_passive.csv")), pair, "passive."), 0);
  ASSERT_EQ(run("motion positions two_passive.bvh -o back.csv").status, 0);
  EXPECT_LT(largest_difference(parse_table(read("back.csv")), pair, "passive."), 1e-3);
}

/// The JSON chunk of a binary glTF file.
nlohmann::json gltf_of(const std::string& glb) {
  std::uint32_t bytes = 0;
  std::memcpy(&bytes, glb.data() + 12, 4);
  return nlohmann::json::parse(glb.substr(20, bytes));
}

TEST_F(SynthCommand, GlbHoldsBothCharactersOrOneEach) {
  make_library();
  ASSERT_EQ(synth("-o pair.glb").status, 0);
  const auto pair = gltf_of(read("pair.glb"));
  ASSERT_THAT(pair["skins"], SizeIs(2));
  EXPECT_EQ(pair["skins"][0]["name"], "active");
  EXPECT_EQ(pair["skins"][1]["name"], "passive");
  EXPECT_THAT(pair["animations"], SizeIs(1));
  ASSERT_EQ(synth("-o two.glb --split").status, 0);
  EXPECT_EQ(gltf_of(read("two_active.glb"))["skins"][0]["name"], "active");
  EXPECT_EQ(gltf_of(read("two_passive.glb"))["skins"][0]["name"], "passive");
  EXPECT_THAT(names(), ElementsAre("demo", "demo.h5", "pair.glb", "two_active.glb", "two_passive.glb"));
}

TEST_F(SynthCommand, ACharacterPerformsBothInAFileEach) {
  make_library();
  write("rig.glb", rig(Naming::Mixamo));
  ASSERT_EQ(synth("--character rig.glb -o pair.glb").status, 0);
  EXPECT_THAT(names(), Contains("pair_active.glb"));
  EXPECT_THAT(names(), Contains("pair_passive.glb"));
  EXPECT_THAT(names(), Not(Contains("pair.glb")));
  expect_failure(synth("--character rig.glb -o pair.bvh"), "written as .glb or .vrm");
}

TEST_F(SynthCommand, AnotherInputRateGivesTheSameStepRate) {
  make_library();
  for (const std::string fps : {"30", "120"}) {
    const auto summary = nlohmann::json::parse(synth("--json --preset paper --fps " + fps).out);
    EXPECT_EQ(summary["step_rate_hz"], 15);
    EXPECT_EQ(summary["failed"], 0);
  }
  EXPECT_EQ(nlohmann::json::parse(synth("--json --fps 30").out)["step_rate_hz"], 30);
  EXPECT_EQ(nlohmann::json::parse(synth("--json --fps 240").out)["step_rate_hz"], 120);
}

TEST_F(SynthCommand, AUserOfAnotherSizeGetsTheLibrarysBodies) {
  make_library();
  ASSERT_EQ(synth("-o usual.csv").status, 0);
  const Outcome outcome = synth("-o tall.csv --metres-per-unit 1.2");
  ASSERT_EQ(outcome.status, 0);
  const Table usual = parse_table(read("usual.csv"));
  const Table tall = parse_table(read("tall.csv"));
  const auto shin = [](const Table& table) {
    return std::hypot(table.at(20, "active.lfemur_x") - table.at(20, "active.ltibia_x"),
                      table.at(20, "active.lfemur_y") - table.at(20, "active.ltibia_y"),
                      table.at(20, "active.lfemur_z") - table.at(20, "active.ltibia_z"));
  };
  EXPECT_NEAR(shin(tall), shin(usual), 1e-3 * shin(usual));
}

double shin(const Table& table, const std::string& who) {
  double sum = 0;
  for (const std::string axis : {"_x", "_y", "_z"})
    sum += std::pow(table.at(15, who + ".lfemur" + axis) - table.at(15, who + ".ltibia" + axis), 2);
  return std::sqrt(sum);
}

TEST_F(SynthCommand, TheCharactersAreShownOnTheChosenBodies) {
  make_library();
  ASSERT_EQ(synth("-o library.csv").status, 0);
  ASSERT_EQ(synth("--active-body scale:0.85 --passive-body demo/salsa_01_a.bvh -o others.csv").status, 0);
  ASSERT_EQ(synth("--active-body user -o user.csv").status, 0);
  ASSERT_EQ(run("motion positions demo/salsa_01_a.bvh -o input.csv").status, 0);
  const Table library = parse_table(read("library.csv")), others = parse_table(read("others.csv"));
  const Table user = parse_table(read("user.csv")), input = parse_table(read("input.csv"));
  EXPECT_NEAR(shin(others, "active"), 0.85 * shin(library, "active"), 1e-3);
  const double of_input = std::sqrt(std::pow(input.at(15, "lfemur_x") - input.at(15, "ltibia_x"), 2) +
                                    std::pow(input.at(15, "lfemur_y") - input.at(15, "ltibia_y"), 2) +
                                    std::pow(input.at(15, "lfemur_z") - input.at(15, "ltibia_z"), 2));
  EXPECT_NEAR(shin(others, "passive"), of_input, 1e-3);
  EXPECT_NEAR(shin(user, "active"), of_input, 1e-3);
  EXPECT_NEAR(user.at(15, "active.head_y"), input.at(60, "head_y"), 0.02);
}

TEST_F(SynthCommand, ABodyThatCannotBeHadIsRefused) {
  make_library();
  EXPECT_THAT(synth("--passive-body user -o a.csv").err, HasSubstr("library, scale:NUMBER"));
  EXPECT_THAT(synth("--active-body scale:9 -o a.csv").err, HasSubstr("0.3 to 3"));
  EXPECT_THAT(synth("--active-body nowhere.bvh -o a.csv").err, HasSubstr("nowhere.bvh"));
  EXPECT_THAT(names(), ElementsAre("demo", "demo.h5"));
}

TEST_F(SynthCommand, AThinnedLibraryServesToo) {
  make_library();
  ASSERT_EQ(run("library build demo/manifest.json -o thin.h5 --rate 15").status, 0);
  const Outcome outcome = run("synth --library thin.h5 --input demo/salsa_01_a.bvh --json");
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["failed"], 0);
}

TEST_F(SynthCommand, AnExcludedTakeIsNeverSelectedAndAnUnknownOneRefused) {
  make_demo("0.5");
  ASSERT_EQ(run("library build demo/manifest.json -o demo.h5 --rate 30").status, 0);
  ASSERT_EQ(synth("--exclude salsa_01 --trace t.jsonl").status, 0);
  const auto trace = parse_lines(read("t.jsonl"));
  for (std::size_t step = 1; step < trace.size(); ++step)
    for (const auto& candidate : trace[step]["candidates"]) ASSERT_EQ(candidate["take"], "salsa_02");
  expect_failure(synth("--exclude salsa_09"), "salsa_09: the library has no take of this name");
  expect_failure(synth("--exclude salsa_01 --exclude salsa_02"), "no pair is left");
}

TEST_F(SynthCommand, WrongFilesAreRefusedWithTheirName) {
  make_library();
  const std::string user = " --input demo/salsa_01_a.bvh";
  expect_failure(run("synth --library gone.h5" + user), "gone.h5: cannot be opened");
  expect_failure(run("synth --library demo/labels.csv" + user), "demo/labels.csv: is not an HDF5 file");
  expect_failure(run("synth --library demo.h5 --input gone.bvh"), "gone.bvh: cannot be opened");
  expect_failure(run("synth --library demo.h5 --input demo.h5"), "demo.h5: is an HDF5 file");
  expect_failure(synth("-o pair.fbx"),
                 "pair.fbx: this file type cannot be written; use .bvh, .glb, .csv, .npz or .npy");
}

TEST_F(SynthCommand, ACapturedFollowerOfAnotherBuildIsAnswered) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  make_library();
  const std::string salsa = std::filesystem::absolute(data / "cmu_salsa").string();
  const Outcome outcome = run({"synth", "--library", "demo.h5", "--input", salsa + "/61_03.amc", "--skeleton",
                               salsa + "/61.asf", "--fps", "60", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  const auto summary = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(summary["failed"], 0);
  EXPECT_LT(summary["bone_length_max"].get<double>(), 1e-3);
}

}  // namespace
}  // namespace abrazo::test::synth_command_test
