#include <algorithm>

#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::sweep_command_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two takes; an evaluation of one of them takes well under a second.
class SweepCommand : public CommandLineTest {
 protected:
  void SetUp() override { make_demo("0.5"); }
  Outcome sweep(const std::string& more) const {
    return run(
        "sweep --manifest demo/manifest.json --hold-out salsa_01 --x alpha=0:1:2 --y neighbours=5,10 "
        "--metric partner.mean_joint_error_m --report s " +
        more);
  }
  std::vector<std::string> report_files() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(path("s")))
      found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }
};

TEST_F(SweepCommand, WritesTheGridAndNamesTheBestPoint) {
  const Outcome outcome = sweep("");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("best partner.mean_joint_error_m: 0."));
  EXPECT_THAT(outcome.out, HasSubstr("options: --preset responsive"));
  EXPECT_THAT(report_files(), ElementsAre("shard-1-of-1.json", "sweep.html", "sweep.json"));
  const auto json = nlohmann::json::parse(read("s/sweep.json"));
  ASSERT_EQ(json["points"].size(), 4u);
  for (const auto& point : json["points"]) EXPECT_GE(point["value"], json["best"]["value"]);
  EXPECT_EQ(json["x"]["setting"], "alpha");
  EXPECT_THAT(json["data"], HasSubstr("answered salsa_01"));
}

TEST_F(SweepCommand, ShardsSayWhatIsMissingAndMergeIntoTheSameGrid) {
  const Outcome first = sweep("--shard 2/2 --json");
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(nlohmann::json::parse(first.out), (nlohmann::json{{"shards", 2}, {"missing", {1}}}));
  EXPECT_THAT(run("sweep --merge --report s").out, HasSubstr("missing shards: 1/2"));
  EXPECT_THAT(sweep("--shard 2/2").out, HasSubstr("had been evaluated before"));
  const Outcome last = sweep("--shard 1/2 --json");
  EXPECT_EQ(last.status, 0) << last.err;

  const auto merged = nlohmann::json::parse(last.out);
  EXPECT_EQ(merged, nlohmann::json::parse(read("s/sweep.json")));
  std::filesystem::remove_all(path("s"));
  const auto whole = nlohmann::json::parse(sweep("--json").out);
  ASSERT_EQ(merged["points"].size(), whole["points"].size());
  for (std::size_t i = 0; i < whole["points"].size(); ++i)
    EXPECT_EQ(merged["points"][i]["value"], whole["points"][i]["value"]) << i;
  EXPECT_EQ(merged["best"], whole["best"]);
}

TEST_F(SweepCommand, ShardsOfOtherDataOfTheSameNameAndSizeAreRefused) {
  ASSERT_EQ(sweep("--shard 1/2").status, 0);
  // The two performers of each take change places: as many pairs, by the same names.
  auto manifest = nlohmann::json::parse(read("demo/manifest.json"));
  for (auto& take : manifest["takes"]) std::swap(take["a"], take["b"]);
  write("demo/manifest.json", manifest.dump());
  const Outcome other = sweep("--shard 2/2");
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("it evaluates"));
  EXPECT_THAT(report_files(), ElementsAre("shard-1-of-2.json"));
}

TEST_F(SweepCommand, AMergeDrawsAnotherMetric) {
  ASSERT_EQ(sweep("").status, 0);
  const Outcome outcome = run("sweep --merge --metric contact.hold_change_mean_m --report s");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("best contact.hold_change_mean_m"));
  EXPECT_EQ(nlohmann::json::parse(read("s/sweep.json"))["metric"], "contact.hold_change_mean_m");
}

TEST_F(SweepCommand, RefusesWhatCannotBeSweptBeforeReadingAnyTake) {
  const auto refused = [&](const std::string& words) {
    return run("sweep --manifest nowhere.json --report s --metric moves.rate " + words);
  };
  expect_failure(refused("--x alpha=0:9:3 --y neighbours=5,10"),
                 "alpha=0:9:3: '9' cannot be used: a number from 0 to 5");
  expect_failure(refused("--x alfa=0:1:3 --y neighbours=5,10"), "'alfa' is not a setting");
  expect_failure(refused("--x alpha=0:1:3 --y alpha=2,3"), "both axes are alpha");
  expect_failure(refused("--x alpha=0:1:3 --y neighbours=5,10 --shard 3/2"), "I/N is expected");
  expect_failure(run("sweep --manifest nowhere.json --report s --metric joy --x alpha=0,1 --y neighbours=5"),
                 "'joy' is not a figure of report.json");
  EXPECT_THAT(names(), ElementsAre("demo"));
}

TEST_F(SweepCommand, NeedsItsAxesUnlessItMerges) {
  expect_wrong_usage(run("sweep --manifest demo/manifest.json --report s --metric moves.rate --x alpha=0,1"),
                     "--y");
  expect_wrong_usage(run("sweep --report s --metric moves.rate --x alpha=0,1 --y neighbours=5"),
                     "--manifest");
  expect_wrong_usage(run("sweep --merge --shard 1/2 --report s"), "--merge");
  expect_wrong_usage(run("sweep --merge --x alpha=0,1 --report s"), "--merge");
  expect_failure(run("sweep --merge --report nowhere"), "nowhere: cannot be read");
}

TEST_F(SweepCommand, ATakeThatDoesNotExistIsNamed) {
  expect_failure(
      run("sweep --manifest demo/manifest.json --hold-out tango_09 --x alpha=0,1 --y neighbours=5 --metric "
          "moves.rate --report s"),
      "tango_09");
  EXPECT_THAT(names(), ElementsAre("demo"));
}

}  // namespace
}  // namespace abrazo::test::sweep_command_test
