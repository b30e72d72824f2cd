// `abrazo motion convert`: what is written means what was read.
#include <algorithm>
#include <cmath>

#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::convert_command_test {
namespace {

using ::testing::HasSubstr;

class ConvertCommand : public CommandLineTest {
 protected:
  ConvertCommand() { make_demo(); }

  /// World positions of a file's performer, by the program.
  Table positions(const std::string& file, const std::string& more = "") {
    const Outcome outcome = run("motion positions " + file + " -o positions.csv " + more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return parse_table(read("positions.csv"));
  }
  static double distance_m(const Table& a, const Table& b) {
    EXPECT_EQ(a.rows.size(), b.rows.size());
    double most = 0;
    for (std::size_t f = 0; f < std::min(a.rows.size(), b.rows.size()); ++f)
      for (const std::string joint : {"root", "lhand", "rtoes", "head"})
        for (const std::string axis : {"_x", "_y", "_z"})
          most = std::max(most, std::abs(a.at(f, joint + axis) - b.at(f, joint + axis)));
    return most;
  }
};

TEST_F(ConvertCommand, ABvhBecomesABvhOfTheSameMotion) {
  const Outcome outcome = run("motion convert demo/salsa_01_a.bvh -o again.bvh");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("again.bvh: a body of"));
  EXPECT_THAT(outcome.out, HasSubstr("60 Hz"));
  EXPECT_LT(distance_m(positions("demo/salsa_01_a.bvh"), positions("again.bvh")), 1e-3);
}

TEST_F(ConvertCommand, UnitAndAxisAreThoseThatWereAskedFor) {
  ASSERT_EQ(run("motion convert demo/salsa_01_a.bvh -o cm.bvh --out-units cm").status, 0);
  EXPECT_LT(distance_m(positions("demo/salsa_01_a.bvh"), positions("cm.bvh", "--metres-per-unit 0.01")),
            1e-3);
  ASSERT_EQ(run("motion convert demo/salsa_01_a.bvh -o z.bvh --out-up z").status, 0);
  EXPECT_LT(distance_m(positions("demo/salsa_01_a.bvh"), positions("z.bvh", "--up z --metres-per-unit 1")),
            1e-3);
  ASSERT_EQ(run("motion convert demo/salsa_01_a.bvh -o mm.csv --out-units mm").status, 0);
  EXPECT_NEAR(parse_table(read("mm.csv")).at(5, "head_y"),
              1000 * positions("demo/salsa_01_a.bvh").at(5, "head_y"), 1e-6);
}

TEST_F(ConvertCommand, AllPerformersComeAlongOrTheChosenOne) {
  ASSERT_EQ(run("motion convert demo/salsa_01_a.bvh -o a.csv").status, 0);
  ASSERT_EQ(run("library build demo/manifest.json -o demo.h5").status, 0);
  ASSERT_EQ(run("synth --library demo.h5 --input demo/salsa_01_a.bvh -o pair.bvh").status, 0);
  const Outcome both = run("motion convert pair.bvh -o pair.glb");
  ASSERT_EQ(both.status, 0) << both.err;
  EXPECT_THAT(both.out, HasSubstr("2 bodies"));
  EXPECT_EQ(read("pair.glb").substr(0, 4), "glTF");
  ASSERT_EQ(run("motion convert pair.bvh --performer 2 -o passive.csv").status, 0);
  EXPECT_LT(distance_m(positions("pair.bvh", "--performer 2"), parse_table(read("passive.csv"))), 1e-9);
}

TEST_F(ConvertCommand, ANumPyFileComesBackToTheLastBitAndHasTheOrderThatWasAskedFor) {
  ASSERT_EQ(run("motion convert demo/salsa_01_a.bvh -o a.npz").status, 0);
  EXPECT_EQ(distance_m(positions("demo/salsa_01_a.bvh"), positions("a.npz")), 0);
  ASSERT_EQ(run("motion convert demo/salsa_01_a.bvh -o lafan.npy --out-joints lafan22").status, 0);
  EXPECT_THAT(run("motion info lafan.npy").out,
              HasSubstr("the order lafan22 was guessed, since by it the bones keep their lengths"));
  ASSERT_EQ(run("motion convert lafan.npy --joints lafan22 --fps 60 --up y --metres-per-unit 1 -o again.npy "
                "--out-joints lafan22")
                .status,
            0);
  EXPECT_EQ(read("again.npy"), read("lafan.npy"));
  expect_failure(run("motion info lafan.npy --joints nobody"), "is no built-in joint order");
  expect_failure(run("motion convert a.npz -o a.bvh --out-joints lafan22"),
                 "an order of joints is for .npz and .npy");
}

TEST_F(ConvertCommand, WhatCannotBeWrittenIsRefusedBeforeTheWork) {
  expect_failure(run("motion convert demo/salsa_01_a.bvh -o a.fbx"),
                 "a.fbx: this file type cannot be written; use .bvh, .glb, .csv, .npz or .npy");
  expect_failure(run("motion convert demo/salsa_01_a.bvh -o a.glb --out-units cm"),
                 "a.glb: a GLB is in metres with Y up");
  expect_failure(run("motion convert demo/salsa_01_a.bvh -o demo/salsa_01_a.bvh"), "is also read");
  expect_wrong_usage(run("motion convert demo/salsa_01_a.bvh -o a.bvh --out-units feet"), "feet");
}

}  // namespace
}  // namespace abrazo::test::convert_command_test
