#include <cmath>

#include "tests/cli/command_line_fixture.hpp"
#include "tests/support/humanoid_rig.hpp"

namespace abrazo::test::retarget_command_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A second of a generated take.
class RetargetCommand : public CommandLineTest {
 protected:
  void SetUp() override { make_demo(); }
  Outcome retarget(const std::string& more) const {
    return run("retarget --manifest demo/manifest.json --take salsa_01 --from 120 --to 180 " + more);
  }
  static double shin(const Table& table, const std::string& who) {
    double sum = 0;
    for (const std::string axis : {"_x", "_y", "_z"})
      sum += std::pow(table.at(30, who + ".lfemur" + axis) - table.at(30, who + ".ltibia" + axis), 2);
    return std::sqrt(sum);
  }
};

TEST_F(RetargetCommand, GivesBothCharactersTheirBodies) {
  ASSERT_EQ(retarget("-o same.csv").status, 0);
  const Outcome outcome = retarget("--active-body scale:0.85 -o small.csv");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("salsa_01: 60 frames, active scale:0.85"));
  EXPECT_THAT(outcome.out, HasSubstr("holds change by"));
  const Table same = parse_table(read("same.csv")), small = parse_table(read("small.csv"));
  ASSERT_EQ(small.rows.size(), 60u);
  EXPECT_NEAR(shin(small, "active"), 0.85 * shin(same, "active"), 1e-4);
  EXPECT_NEAR(shin(small, "passive"), shin(same, "passive"), 1e-4);
}

TEST_F(RetargetCommand, ALibraryGivesTheSameAsItsManifest) {
  make_library();
  const std::string rest = " --take salsa_01 --from 120 --to 150 --passive-body scale:1.15 --quiet -o ";
  ASSERT_EQ(run("retarget --manifest demo/manifest.json" + rest + "a.csv").status, 0);
  ASSERT_EQ(run("retarget --library demo.h5" + rest + "b.csv").status, 0);
  const Table a = parse_table(read("a.csv")), b = parse_table(read("b.csv"));
  EXPECT_NEAR(a.at(20, "passive.head_y"), b.at(20, "passive.head_y"), 1e-3);
}

TEST_F(RetargetCommand, ABodyIsMeasuredInAMotionFile) {
  ASSERT_EQ(retarget("--active-body demo/salsa_01_b.bvh -o swapped.csv --json").status, 0);
  ASSERT_EQ(retarget("-o same.csv").status, 0);
  EXPECT_NEAR(shin(parse_table(read("swapped.csv")), "active"),
              shin(parse_table(read("same.csv")), "passive"), 1e-3);
}

TEST_F(RetargetCommand, TheTraceHasEveryFrameWithRecordingMeshAndStatus) {
  ASSERT_EQ(retarget("--active-body scale:1.1 -o pair.glb --trace pair.jsonl").status, 0);
  const auto lines = parse_lines(read("pair.jsonl"));
  ASSERT_EQ(lines.size(), 61u);
  EXPECT_EQ(lines[0]["abrazo_trace"], 1);
  EXPECT_EQ(lines[1]["frame"], 120);
  EXPECT_EQ(lines[1]["active"].size(), 25u);
  EXPECT_GT(lines[1]["mesh"]["edges"].size(), 100u);
  EXPECT_EQ(lines[1]["status"], "ok");
  EXPECT_LT(lines[60]["residual"]["bone_length_max"], 1e-3);
}

TEST_F(RetargetCommand, SeveralTakesHaveFilesOfTheirOwn) {
  make_demo("0.5");
  ASSERT_EQ(run("retarget --manifest demo/manifest.json --take salsa_01 --take salsa_02 --from 0 --to 20 "
                "--active-body scale:0.9 -o out.npz --quiet")
                .status,
            0);
  EXPECT_THAT(names(), Contains("out_salsa_01.npz"));
  EXPECT_THAT(names(), Contains("out_salsa_02.npz"));
  EXPECT_THAT(names(), Not(Contains("out.npz")));
}

TEST_F(RetargetCommand, ACharacterPerformsBothInAFileEach) {
  write("rig.glb", rig(Naming::Mixamo));
  const Outcome outcome = retarget("--passive-body scale:0.9 --character rig.glb -o pair.glb");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("to pair_active.glb and pair_passive.glb"));
  EXPECT_THAT(names(), Contains("pair_active.glb"));
  EXPECT_THAT(names(), Contains("pair_passive.glb"));
  EXPECT_THAT(names(), Not(Contains("pair.glb")));
  expect_failure(retarget("--character rig.glb -o pair.bvh"), "written as .glb or .vrm");
}

TEST_F(RetargetCommand, WhatCannotBeDoneIsSaidBeforeAnythingIsWritten) {
  const auto before = names();
  expect_failure(retarget("--active-body scale:9 -o a.csv"), "a number from 0.3 to 3 is expected");
  expect_failure(retarget("--active-body user -o a.csv"), "a recorded pair has no user");
  expect_failure(retarget("--active-body gone.bvh -o a.csv"), "gone.bvh");
  expect_failure(retarget("-o a.fbx"), "this file type cannot be written");
  expect_failure(retarget("-o a.csv --trace a.csv"), "cannot share a file");
  expect_failure(run("retarget --manifest demo/manifest.json --take tango -o a.csv"),
                 "has no take tango; there are salsa_01");
  expect_failure(run("retarget --manifest demo/manifest.json --take salsa_01 --from 9 --to 3 -o a.csv"),
                 "frames 9 to 3 are not in it");
  expect_failure(run("retarget --take salsa_01 -o a.csv"), "--library or from --manifest");
  EXPECT_EQ(names(), before);
}

TEST_F(RetargetCommand, WrongUsageIsAnsweredWithTheHelp) {
  expect_wrong_usage(run("retarget --manifest demo/manifest.json -o a.csv"), "--take");
  expect_wrong_usage(retarget("--library demo.h5 -o a.csv"), "--library");
}

}  // namespace
}  // namespace abrazo::test::retarget_command_test
