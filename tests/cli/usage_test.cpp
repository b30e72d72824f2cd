#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::usage_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;

class Usage : public CommandLineTest {};

TEST_F(Usage, HelpIsThereAtEveryLevelAndNamesItsCommand) {
  for (const std::string command :
       {"", " motion", " motion info", " motion positions", " library", " library build", " library info",
        " library pair", " synth", " demo", " live", " send"}) {
    const Outcome outcome = run(command + " --help");
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_THAT(outcome.out, HasSubstr("Usage: abrazo" + command + " ")) << command;
    EXPECT_THAT(outcome.err, IsEmpty()) << command;
  }
}

TEST_F(Usage, VersionIsThereAtEveryLevel) {
  for (const std::string command : {"", "motion ", "motion info ", "library build ", "synth ", "demo "}) {
    const Outcome outcome = run(command + "--version");
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_THAT(outcome.out, MatchesRegex("abrazo [0-9]+\\.[0-9]+\\.[0-9]+\n")) << command;
  }
}

TEST_F(Usage, AMissingCommandIsAnsweredWithTheCommandsThereAre) {
  expect_wrong_usage(run(""), "a command is missing; there are motion, library, synth, demo");
  expect_wrong_usage(run("motion"), "there are info, positions, convert; see abrazo motion --help");
}

TEST_F(Usage, AnUnknownCommandIsNamed) {
  expect_wrong_usage(run("dance"), "'dance' is not known here");
  expect_wrong_usage(run("library burn x"),
                     "'burn' is not known here; the commands are build, info, plan, pair");
}

TEST_F(Usage, AnUnknownOptionOrWordIsNamed) {
  expect_wrong_usage(run("motion info a.bvh --upside"), "--upside");
  expect_wrong_usage(run("motion info a.bvh b.bvh"), "b.bvh; see abrazo motion info --help");
}

TEST_F(Usage, WhatIsRequiredIsNamed) {
  expect_wrong_usage(run("motion info"), "FILE is required");
  expect_wrong_usage(run("motion positions a.bvh"), "--output is required");
  expect_wrong_usage(run("library build m.json"), "--output is required");
  expect_wrong_usage(run("library pair l.h5 take"), "FRAME is required");
  expect_wrong_usage(run("synth --library l.h5"), "--input is required");
  expect_wrong_usage(run("demo"), "--output is required");
  expect_wrong_usage(run("synth --library l.h5 --input a.bvh --split"), "--split requires --output");
}

TEST_F(Usage, ANumberOutOfRangeIsRefusedBeforeAnyWork) {
  for (const std::string value : {"0", "-1", "nan", "inf", "1,5", "x"}) {
    expect_wrong_usage(run("motion info a.bvh --fps " + value), "--fps: expected a number above 0");
    expect_wrong_usage(run("synth --library l --input a --metres-per-unit " + value),
                       "--metres-per-unit: expected a number above 0");
    expect_wrong_usage(run("library build m -o l --rate " + value), "--rate: expected a number above 0");
  }
  expect_wrong_usage(run("demo -o d --seed -1"), "--seed: expected a whole number from 0");
  expect_wrong_usage(run("demo -o d --seed 99999999999999999999"), "--seed");
  expect_wrong_usage(run("demo -o d --minutes nan"), "--minutes: expected a number from 0.01 to 600");
  expect_wrong_usage(run("motion positions f -o o.csv --performer 0"), "--performer");
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Usage, AnAnswerThatCannotBeWrittenIsAFailure) {
  const RunningCommand::ErrorsTo file = RunningCommand::ErrorsTo::File;
  for (const std::string words : {"--version", "--help", "demo -o d --minutes 0.1"}) {
    const std::string line = std::string("exec \"$0\" ") + words + " > /dev/full";
    const Outcome outcome = RunningCommand({"/bin/sh", "-c", line, ABRAZO_PROGRAM}, folder(), file).wait();
    EXPECT_EQ(outcome.status, 1) << words;
    EXPECT_THAT(outcome.err, HasSubstr("standard output: No space left on device")) << words;
  }
}

TEST_F(Usage, ProgressIsShownOnATerminalAndTakenAwayAtTheEnd) {
  if (!can_open_terminal()) GTEST_SKIP() << "this system gives no pseudo-terminals";
  const auto on_terminal = [&](std::vector<std::string> words) {
    words.insert(words.begin(), ABRAZO_PROGRAM);
    return RunningCommand(words, folder(), RunningCommand::ErrorsTo::Terminal).wait();
  };
  const Outcome shown = on_terminal({"demo", "-o", "d", "--minutes", "0.1"});
  EXPECT_EQ(shown.status, 0);
  EXPECT_THAT(shown.err, HasSubstr(" 0 %  generating dances"));
  EXPECT_THAT(shown.err, ::testing::EndsWith("\r\033[K"));
  const Outcome quiet = on_terminal({"--quiet", "demo", "-o", "d", "--minutes", "0.1"});
  EXPECT_EQ(quiet.status, 0);
  EXPECT_THAT(quiet.err, IsEmpty());
}

TEST_F(Usage, QuietMayStandAnywhereAndLeavesNothingButWhatWasAskedFor) {
  EXPECT_THAT(run("demo -o d --minutes 0.1 --quiet").out, IsEmpty());
  const Outcome built = run("library --quiet build d/manifest.json -o d.h5");
  EXPECT_THAT(built.out + built.err, IsEmpty());
  const Outcome solved = run("--quiet synth --library d.h5 --input d/salsa_01_a.bvh -o out.csv");
  EXPECT_THAT(solved.out + solved.err, IsEmpty());
  EXPECT_THAT(run("--quiet library info d.h5").out, HasSubstr("demo-salsa-1"));
}

}  // namespace
}  // namespace abrazo::test::usage_test
