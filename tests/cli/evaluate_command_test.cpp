#include <unistd.h>

#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::evaluate_command_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Two takes of some 15 s in "demo/".
class EvaluateCommand : public CommandLineTest {
 protected:
  void SetUp() override { make_demo("0.5"); }
};

TEST_F(EvaluateCommand, WritesTheContractsReportAndAPage) {
  const Outcome outcome =
      run("evaluate selection moves zmp contact published --manifest demo/manifest.json --report deep/report "
          "--queries 50 --no-variants");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("successful moves"));
  EXPECT_THAT(outcome.out, HasSubstr("deep/report/report.html"));
  const auto report = nlohmann::json::parse(read("deep/report/report.json"));
  for (const char* part : {"selection", "moves", "zmp", "contact", "published", "partner", "solve_us"})
    EXPECT_TRUE(report.contains(part)) << part;
  EXPECT_FALSE(report.contains("timing"));
  EXPECT_EQ(report["selection"].size(), 10u);
  EXPECT_GT(report["moves"]["total"], 0);
  EXPECT_THAT(read("deep/report/report.html"), StartsWith("<!DOCTYPE html>"));
}

TEST_F(EvaluateCommand, TheReportAlsoGoesToStandardOutputAsOneObject) {
  const Outcome outcome = run(
      "evaluate moves --manifest demo/manifest.json --report out --no-variants --hold-out salsa_02 --json "
      "--quiet");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, read("out/report.json"));
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["takes"], nlohmann::json::parse(R"(["salsa_02"])"));
}

TEST_F(EvaluateCommand, SettingsAreThoseOfEveryCommandThatSolves) {
  const Outcome outcome =
      run("evaluate contact --manifest demo/manifest.json --report out --no-variants --hold-out salsa_01 "
          "--preset "
          "responsive --step-rate 30 --json --quiet");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["settings"]["step-rate"], 30);
  EXPECT_EQ(report["settings"]["alpha"], 0.2);
  EXPECT_EQ(report["step_rate_hz"], 30);
}

TEST_F(EvaluateCommand, OtherPeopleAreAnsweredByTheWholeLibrary) {
  ASSERT_EQ(run("demo -o novices --minutes 0.2 --seed 9 --skill 0.2 --height 1.7,1.6 --quiet").status, 0);
  const Outcome outcome = run(
      "evaluate moves --manifest demo/manifest.json --users novices/manifest.json --report out --no-variants "
      "--json --quiet");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["users"], "demo-salsa-9");
  EXPECT_EQ(report["takes"], nlohmann::json::parse(R"(["salsa_01"])"));
}

TEST_F(EvaluateCommand, FightersWhoTakeTurnsNeedBothRoles) {
  ASSERT_EQ(run("demo -o fight --style fight --minutes 0.5 --quiet").status, 0);
  const std::string words =
      "evaluate moves --manifest fight/manifest.json --report out --no-variants --quiet";
  expect_failure(run(words), "--both-roles");
  EXPECT_THAT(names(), ElementsAre("demo", "fight"));
  const Outcome outcome = run(words + " --both-roles --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["both_roles"], true);
}

TEST_F(EvaluateCommand, ATakeThatDoesNotExistIsNamedWithThoseThatDo) {
  expect_failure(run("evaluate moves --manifest demo/manifest.json --report out --hold-out salsa_9"),
                 "salsa_9: there is no take of this name to be answered; there are salsa_01, salsa_02");
  EXPECT_THAT(names(), ElementsAre("demo"));
}

TEST_F(EvaluateCommand, WhatCannotBeEvaluatedLeavesNoFolderBehind) {
  expect_failure(run("evaluate moves --manifest nowhere.json --report out"), "nowhere.json");
  expect_failure(run("evaluate moves --manifest demo/manifest.json --users nowhere.json --report out"),
                 "nowhere.json");
  EXPECT_THAT(names(), ElementsAre("demo"));
}

TEST_F(EvaluateCommand, AFolderThatWasThereStaysWhateverHappens) {
  std::filesystem::create_directory(path("out"));
  ASSERT_EQ(run("demo -o fight --style fight --minutes 0.5 --quiet").status, 0);
  expect_failure(run("evaluate moves --manifest fight/manifest.json --report out"), "--both-roles");
  EXPECT_THAT(names(), ElementsAre("demo", "fight", "out"));
}

TEST_F(EvaluateCommand, AFolderThatCannotBeWrittenIsRefusedBeforeTheWork) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  std::filesystem::create_directory(path("locked"));
  std::filesystem::permissions(path("locked"), std::filesystem::perms(0555));
  expect_failure(run("evaluate all --manifest demo/manifest.json --report locked"),
                 "locked: the folder is not writable");
}

TEST_F(EvaluateCommand, AFolderThatCannotBeMadeIsRefusedBeforeTheWork) {
  write("taken", "mine");
  expect_failure(run("evaluate all --manifest demo/manifest.json --report taken"),
                 "taken: the folder cannot be made");
  EXPECT_EQ(read("taken"), "mine");
}

TEST_F(EvaluateCommand, WhatToEvaluateMustBeSaid) {
  expect_wrong_usage(run("evaluate --manifest demo/manifest.json --report out"), "parts");
  expect_wrong_usage(run("evaluate everything --manifest demo/manifest.json --report out"), "everything");
  expect_wrong_usage(run("evaluate moves --report out"), "--manifest");
}

}  // namespace
}  // namespace abrazo::test::evaluate_command_test
