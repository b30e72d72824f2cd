#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::labels_command_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class LabelsCommand : public CommandLineTest {
 protected:
  LabelsCommand() {
    write("moves.csv",
          "take,start_frame,end_frame,label,detail,confidence\n"
          "one,0,60,basic,,\none,60,90,turn,slow,low\ntwo,0,30,basic,,\n");
    write("gaps.csv", "tier,start,end,value\nmove,0,1,basic\nmove,2,3,trun\nrole,0,3,a\n");
  }
};

TEST_F(LabelsCommand, InfoSaysHowLongEachValueLasts) {
  const Outcome text = run("labels info moves.csv --take one --fps 60");
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("move (move): 2 intervals from 0.000 to 1.500 s, 1.500 s annotated"));
  const auto info = nlohmann::json::parse(run("labels info gaps.csv --json").out);
  EXPECT_EQ(info["tiers"][0]["values"]["trun"], 1);
  EXPECT_EQ(info["tiers"][1]["kind"], "role");
  EXPECT_EQ(info["tiers"][1]["annotated_s"], 3);
}

TEST_F(LabelsCommand, NamesInALabelFileNeitherSteerATerminalNorPassForLinesOfTheAnswer) {
  const nlohmann::json moves = {{"name", hostile_name},
                                {"kind", "move"},
                                {"intervals",
                                 {{{"start_s", 0}, {"end_s", 1}, {"value", hostile_name}},
                                  {{"start_s", 2}, {"end_s", 3}, {"value", "basic"}}}}};
  write("moves.json", nlohmann::json{{"tiers", {moves}}}.dump());
  expect_harmless(run("labels info moves.json").out);
  expect_harmless(run("labels check moves.json").out);
  expect_harmless(run("labels convert moves.json -o x.txt --tier other").err);
}

TEST_F(LabelsCommand, ConvertComesBackToTheSameLabelFile) {
  for (const char* format : {"x.eaf", "x.json", "x.TextGrid", "x.csv"}) {
    const bool keeps_remarks = std::string(format) != "x.TextGrid";
    const Outcome there =
        run(std::string("labels convert moves.csv -o ") + format + " --take one --fps 60 --seconds");
    EXPECT_EQ(there.status, 0) << there.err;
    const Outcome back =
        run(std::string("labels convert ") + format + " -o back.csv --take one --fps 60 --tier move");
    EXPECT_EQ(back.status, 0) << back.err;
    EXPECT_EQ(
        read("back.csv"),
        std::string("take,start_frame,end_frame,label,detail,confidence\none,0,60,basic,,\none,60,90,turn,") +
            (keeps_remarks ? "slow,low" : ",") + "\n")
        << format;
  }
}

TEST_F(LabelsCommand, ConvertSaysWhatIsLeftOut) {
  const Outcome outcome = run("labels convert moves.csv -o x.txt --take one --fps 60");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("detail and confidence of 1 interval were left out"));
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST_F(LabelsCommand, CheckListsProblemsWithStatus1) {
  write("words.txt", "basic\nturn\n");
  const Outcome outcome = run("labels check gaps.csv --fps 60 --vocabulary words.txt");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("move: nothing between 1.00 s and 2.00 s (frames 60-120)\n"));
  EXPECT_THAT(outcome.out, HasSubstr("'trun' (2.000-3.000 s) is not in the vocabulary"));
  EXPECT_THAT(outcome.err, HasSubstr("gaps.csv: has 2 problems"));
  const auto problems = nlohmann::json::parse(run("labels check gaps.csv --json").out)["problems"];
  ASSERT_THAT(problems, SizeIs(1));
  EXPECT_EQ(problems[0]["kind"], "gap");
  EXPECT_EQ(run("labels check moves.csv --take one --fps 60").status, 0);
}

TEST_F(LabelsCommand, WhatCannotBeDoneIsSaid) {
  expect_failure(run("labels info moves.csv --fps 60"), "has labels of 2 takes: one, two");
  expect_failure(run("labels info moves.csv --take one"), "counts frames; give their rate (--fps)");
  expect_failure(run("labels convert gaps.csv -o x.doc"), ".eaf, .csv, .json, .TextGrid, .txt");
  expect_failure(run("labels convert gaps.csv -o gaps.csv"), "gaps.csv");
  expect_failure(run("labels convert gaps.csv -o x.json --tier note"),
                 "has no tier 'note'; it has move, role");
  expect_wrong_usage(run("labels convert gaps.csv"), "--output is required");
  EXPECT_EQ(names(), (std::vector<std::string>{"gaps.csv", "moves.csv"}));
}

}  // namespace
}  // namespace abrazo::test::labels_command_test
