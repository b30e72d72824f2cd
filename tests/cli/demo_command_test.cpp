#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::demo_command_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class DemoCommand : public CommandLineTest {};

TEST_F(DemoCommand, WritesTakesLabelsAndTheManifestThatNamesThem) {
  const Outcome outcome = run("demo -o deep/inside --minutes 0.1");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, HasSubstr("next: abrazo library build deep/inside/manifest.json"));
  const auto manifest = nlohmann::json::parse(read("deep/inside/manifest.json"));
  ASSERT_EQ(manifest["takes"].size(), 1u);
  EXPECT_EQ(manifest["takes"][0]["roles"], "a");
  for (const char* performer : {"a", "b"})
    EXPECT_THAT(read("deep/inside/" + manifest["takes"][0][performer]["motion"].get<std::string>()),
                ::testing::StartsWith("HIERARCHY"));
  EXPECT_THAT(read("deep/inside/labels.csv"), ::testing::StartsWith("take,start_frame,end_frame,label"));
}

TEST_F(DemoCommand, TheSameSeedGivesTheSameFiles) {
  for (const std::string words : {"one --seed 4", "two --seed 4", "other --seed 5"})
    ASSERT_EQ(run("demo --minutes 0.1 -o " + words).status, 0);
  EXPECT_EQ(read("one/salsa_01_b.bvh"), read("two/salsa_01_b.bvh"));
  EXPECT_NE(read("one/salsa_01_b.bvh"), read("other/salsa_01_b.bvh"));
}

TEST_F(DemoCommand, AFileInTheFoldersPlaceIsLeftAlone) {
  write("taken", "mine");
  expect_failure(run("demo -o taken --minutes 0.1"), "taken: the folder cannot be made");
  expect_failure(run("demo -o taken/below --minutes 0.1"), "taken/below: the folder cannot be made");
  EXPECT_EQ(read("taken"), "mine");
}

TEST_F(DemoCommand, AFightHasRolesThatChangeAndItsOwnLabels) {
  ASSERT_EQ(run("demo -o d --style fight --minutes 0.5").status, 0);
  const auto manifest = nlohmann::json::parse(read("d/manifest.json"));
  EXPECT_EQ(manifest["name"], "demo-fight-1");
  EXPECT_TRUE(manifest["takes"][0]["roles"].is_array());
  EXPECT_THAT(read("d/labels.csv"), HasSubstr("punch_"));
}

TEST_F(DemoCommand, PerformersAreAsTallAsAskedFor) {
  ASSERT_EQ(run("demo -o tall --minutes 0.1 --height 2.0,1.5").status, 0);
  ASSERT_EQ(run("demo -o same --minutes 0.1 --height 1.7").status, 0);
  const auto height = [&](const std::string& file) {
    return nlohmann::json::parse(run("motion info " + file + " --json").out)["height"].get<double>();
  };
  EXPECT_NEAR(height("tall/salsa_01_a.bvh") / height("tall/salsa_01_b.bvh"), 2.0 / 1.5, 0.04);
  EXPECT_NEAR(height("same/salsa_01_a.bvh") / height("same/salsa_01_b.bvh"), 1, 0.04);
}

TEST_F(DemoCommand, SkillChangesHowItIsDanced) {
  ASSERT_EQ(run("demo -o expert --minutes 0.1").status, 0);
  ASSERT_EQ(run("demo -o novice --minutes 0.1 --skill 0.1").status, 0);
  ASSERT_EQ(run("demo -o pair --minutes 0.1 --skill 1,0.1").status, 0);
  EXPECT_NE(read("expert/salsa_01_a.bvh"), read("novice/salsa_01_a.bvh"));
  EXPECT_NE(read("expert/salsa_01_b.bvh"), read("pair/salsa_01_b.bvh"));
}

TEST_F(DemoCommand, WhatNobodyMeasuresIsWrongUsage) {
  expect_wrong_usage(run("demo -o d --height 3"), "--height");
  expect_wrong_usage(run("demo -o d --skill 1,1,1"), "--skill");
  expect_wrong_usage(run("demo -o d --tempo 20"), "--tempo");
  EXPECT_THAT(names(), ElementsAre());
}

TEST_F(DemoCommand, AnUnknownStyleIsWrongUsage) {
  expect_wrong_usage(run("demo -o d --style tango"), "tango");
  EXPECT_THAT(names(), ElementsAre());
}

}  // namespace
}  // namespace abrazo::test::demo_command_test
