#include "tests/cli/command_line_fixture.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::test::motion_command_test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

class MotionCommand : public CommandLineTest {};

TEST_F(MotionCommand, InfoIsOneJsonObject) {
  make_demo();
  const Outcome outcome = run("motion info demo/salsa_01_a.bvh --json");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  const auto info = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(info["fps"], 60);
  EXPECT_EQ(info["joints"], 25);
  EXPECT_THAT(info["joint_names"], SizeIs(25));
  EXPECT_THAT(info["performers"], SizeIs(1));
  EXPECT_EQ(info["frames"], parse_table([&] {
                              run("motion positions demo/salsa_01_a.bvh -o a.csv");
                              return read("a.csv");
                            }())
                                .rows.size());
  EXPECT_NEAR(info["height"].get<double>(), 1.67, 0.05);
  EXPECT_EQ(info["guessed"]["metres_per_unit"], true);
  EXPECT_THAT(info["warnings"], SizeIs(1));
}

TEST_F(MotionCommand, NamesInAMotionNeitherSteerATerminalNorPassForLinesOfTheAnswer) {
  make_demo();
  write(hostile_name + ".csv", [&] {
    run("motion convert demo/salsa_01_a.bvh -o plain.csv");
    return read("plain.csv");
  }());
  expect_harmless(run({"motion", "info", hostile_name + ".csv"}).out);
  expect_harmless(run({"motion", "positions", hostile_name + ".csv", "-o", "x.csv", "--performer", "3"}).err);
}

TEST_F(MotionCommand, WhatIsGivenIsNotGuessed) {
  make_demo();
  const auto info = nlohmann::json::parse(
      run("motion info demo/salsa_01_a.bvh --json --fps 30 --metres-per-unit 1.1 --up y").out);
  EXPECT_EQ(info["fps"], 30);
  EXPECT_EQ(info["metres_per_unit"], 1.1);
  for (const char* what : {"fps", "metres_per_unit", "up"}) EXPECT_EQ(info["guessed"][what], false) << what;
}

TEST_F(MotionCommand, PositionsHaveTheContractsHeader) {
  make_demo();
  EXPECT_EQ(run("motion positions demo/salsa_01_b.bvh -o b.csv").status, 0);
  const Table table = parse_table(read("b.csv"));
  EXPECT_THAT(table.columns, SizeIs(2 + 25 * 3));
  EXPECT_THAT(read("b.csv"), ::testing::StartsWith("frame,time,root_x,root_y,root_z,lhipjoint_x,"));
  EXPECT_EQ(table.at(60, "frame"), 60);
  EXPECT_EQ(table.at(60, "time"), 1);
}

TEST_F(MotionCommand, FilesThatAreNoMotionAreRefusedWithTheirName) {
  write("text.bvh", "hello\n");
  write("empty.bvh", "");
  write("noise.bvh", std::string("\x80\x01\xff\0\n{", 6));
  write("cut.bvh", "HIERARCHY\nROOT hip\n{\n OFFSET 0 0");
  write("lonely.amc", ":FULLY-SPECIFIED\n1\nroot 0 0 0 0 0 0\n");
  write("notes.txt", "hello");
  std::filesystem::create_directory(path("folder"));
  expect_failure(run("motion info missing.bvh"), "missing.bvh: cannot be opened: No such file or directory");
  expect_failure(run("motion info folder"), "folder: is a folder");
  expect_failure(run("motion info text.bvh"), "text.bvh:1: expected HIERARCHY");
  expect_failure(run("motion info empty.bvh"), "empty.bvh");
  expect_failure(run("motion info noise.bvh"), "noise.bvh:1");
  expect_failure(run("motion info cut.bvh"), "cut.bvh:4: expected three numbers after OFFSET");
  expect_failure(run("motion info lonely.amc"), "name the .asf (--skeleton FILE)");
  expect_failure(run("motion info lonely.amc --skeleton gone.asf"), "gone.asf: cannot be opened");
  expect_failure(run("motion info notes.txt"), "notes.txt: is not a motion file");
}

TEST_F(MotionCommand, ASkeletonForABvhIsRefusedRatherThanIgnored) {
  make_demo();
  expect_failure(run("motion info demo/salsa_01_a.bvh --skeleton x.asf"),
                 "leave out the other one (--skeleton)");
}

TEST_F(MotionCommand, AJointMapThatIsNoneIsRefused) {
  make_demo();
  write("map.json", "{\"joints\": 3}");
  expect_failure(run("motion info demo/salsa_01_a.bvh --joint-map map.json"), "map.json");
  expect_failure(run("motion info demo/salsa_01_a.bvh --joint-map gone.json"), "gone.json: cannot be opened");
}

TEST_F(MotionCommand, OneOfSeveralPerformersMustBeChosen) {
  make_library();
  ASSERT_EQ(run("synth --library demo.h5 --input demo/salsa_01_a.bvh -o pair.bvh").status, 0);
  expect_failure(run("motion positions pair.bvh -o a.csv"),
                 "holds 2 performers: 1 active, 2 passive; choose one (--performer)");
  expect_failure(run("motion positions pair.bvh -o a.csv --performer 3"),
                 "has no performer 3; it holds 1 active, 2 passive");
  EXPECT_EQ(run("motion positions pair.bvh -o a.csv --performer 2").status, 0);
  EXPECT_EQ(run("motion positions pair.bvh -o b.csv --performer passive").status, 0);
  EXPECT_EQ(read("a.csv"), read("b.csv"));
  const auto info = nlohmann::json::parse(run("motion info pair.bvh --performer passive --json").out);
  EXPECT_THAT(info["performers"], SizeIs(1));
  EXPECT_EQ(info["name"], "passive");
}

TEST_F(MotionCommand, AnAnimationIsChosenWhereAFileMayHoldSeveral) {
  make_demo();
  ASSERT_EQ(run("motion convert demo/salsa_01_a.bvh -o one.glb").status, 0);
  expect_failure(run("motion info one.glb --animation sleep"), "has no animation 'sleep'; it holds");
  expect_failure(run("motion info demo/salsa_01_a.bvh --animation walk"), "leave out the animation 'walk'");
  const auto info = nlohmann::json::parse(run("motion info one.glb --json").out);
  ASSERT_THAT(info["animations"], SizeIs(1));
  EXPECT_EQ(run({"motion", "info", "one.glb", "--animation", info["animations"][0]}).status, 0);
}

// From an implementation of the ASF/AMC definition in Python, apart from this program, printed to 1e-9 m.
TEST_F(MotionCommand, CapturedPositionsAreThoseOfAnotherProgram) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  const std::string salsa = std::filesystem::absolute(data / "cmu_salsa").string();
  const Outcome outcome = run({"motion", "positions", salsa + "/60_01.amc", "--skeleton", salsa + "/60.asf",
                               "--fps", "60", "-o", "leader.csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Table table = parse_table(read("leader.csv"));
  ASSERT_THAT(table.rows, SizeIs(2242));
  struct Sample {
    std::size_t frame;
    std::string joint;
    double x, y, z;
  };
  for (const Sample& sample : {Sample{0, "root", -0.708445511, 0.987213333, -0.033459928},
                               Sample{0, "head", -0.674688208, 1.620890923, -0.023996565},
                               Sample{1000, "lhand", 0.541017444, 0.803411539, -0.44057588},
                               Sample{1500, "rtoes", 0.569901884, 0.053587236, 0.463763476},
                               Sample{2241, "rhand", 1.083127876, 1.077847409, -0.051410727},
                               Sample{2241, "lfemur", 1.272305077, 0.461222818, 0.106343862}}) {
    EXPECT_NEAR(table.at(sample.frame, sample.joint + "_x"), sample.x, 1e-6) << sample.joint;
    EXPECT_NEAR(table.at(sample.frame, sample.joint + "_y"), sample.y, 1e-6) << sample.joint;
    EXPECT_NEAR(table.at(sample.frame, sample.joint + "_z"), sample.z, 1e-6) << sample.joint;
  }
}

TEST_F(MotionCommand, ACapturedMotionsRateIsMarkedAsGuessed) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  const std::string salsa = std::filesystem::absolute(data / "cmu_salsa").string();
  const auto info = nlohmann::json::parse(
      run({"motion", "info", salsa + "/61_03.amc", "--skeleton", salsa + "/61.asf", "--json"}).out);
  EXPECT_EQ(info["guessed"]["fps"], true);
  EXPECT_NEAR(info["metres_per_unit"].get<double>(), 0.0254 / 0.45, 1e-12);
}

}  // namespace
}  // namespace abrazo::test::motion_command_test
