#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::suggest_command_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two generated takes: each is suggested from the other.
class SuggestCommand : public CommandLineTest {
 protected:
  void SetUp() override {
    make_demo("0.5");
    ASSERT_EQ(run("library build demo/manifest.json -o demo.h5").status, 0);
  }
};

TEST_F(SuggestCommand, ProposesLabelsAndRolesOfATake) {
  const Outcome outcome = run("suggest demo/manifest.json --take salsa_01 -o s.json --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["take"], "salsa_01");
  ASSERT_FALSE(json["moves"].empty());
  EXPECT_EQ(json["moves"][0]["start_s"], 0);
  EXPECT_EQ(json["roles"][0]["value"], "a");
  for (const auto& move : json["moves"]) {
    EXPECT_GT(move["end_s"], move["start_s"]);
    EXPECT_GE(move["confidence"], 0);
    EXPECT_LE(move["confidence"], 1);
    EXPECT_THAT(move["reason"].get<std::string>(), HasSubstr("nearest labelled moves"));
  }
  const auto file = nlohmann::json::parse(read("s.json"));
  ASSERT_EQ(file["tiers"].size(), 2U);
  EXPECT_EQ(file["tiers"][1]["intervals"].size(), json["moves"].size());
}

TEST_F(SuggestCommand, MeasuresAgreement) {
  const Outcome outcome = run("suggest demo.h5 --agreement --report r");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("% of frames agree"));
  const auto json = nlohmann::json::parse(read("r/agreement.json"));
  EXPECT_EQ(json["takes"].size(), 2U);
  EXPECT_THAT(read("r/agreement.html"), HasSubstr("What confidences are worth"));
}

TEST_F(SuggestCommand, NamesTheTakesThereAre) {
  expect_failure(run("suggest demo.h5 --take tango"),
                 "demo.h5: has no take \"tango\"; it has salsa_01, salsa_02");
}

TEST_F(SuggestCommand, WritesNoOtherFormats) {
  expect_failure(run("suggest demo.h5 --take salsa_01 -o s.doc"),
                 "s.doc: is none of the label formats .eaf, .csv, .json, .TextGrid, .txt");
  EXPECT_THAT(names(), ElementsAre("demo", "demo.h5"));
}

TEST_F(SuggestCommand, WantsATakeOrAgreement) {
  expect_wrong_usage(run("suggest demo.h5"), "--take TAKE or --agreement");
}

}  // namespace
}  // namespace abrazo::test::suggest_command_test
