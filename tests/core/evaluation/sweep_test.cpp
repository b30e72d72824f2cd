#include "core/evaluation/sweep/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/atomic_file.hpp"
#include "core/evaluation/sweep/sweep_report.hpp"
#include "tests/core/evaluation/report_example.hpp"

namespace abrazo::sweep_test {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// An empty folder for one test.
class SweepFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("abrazo_sweep_") + test->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::set<std::string> files() const {
    std::set<std::string> names;
    if (fs::exists(folder_))
      for (const auto& entry : fs::directory_iterator(folder_))
        names.insert(entry.path().filename().string());
    return names;
  }
  std::string text(const char* name) const { return *read_whole_file(folder_ / name); }

  fs::path folder_;
};

Sweep sweep_of(const char* x = "alpha=0:1:5", const char* y = "velocity-weight=0.1,0.2,0.4") {
  return {.data = "cmu-salsa",
          .settings = *preset("paper"),
          .x = *parse_sweep_axis(x),
          .y = *parse_sweep_axis(y),
          .metric = "partner.mean_joint_error_m"};
}

/// Stands in for an evaluation: the error is smallest at alpha = 0.25, w = 0.2. Counts what it evaluates.
class Bowl {
 public:
  SweepEvaluator evaluator() {
    return [this](const Settings& settings, const Progress&) -> Result<Evaluation> {
      evaluated.push_back({settings.alpha, settings.velocity_weight});
      Evaluation evaluation = test::example_evaluation();
      const double a = settings.alpha - 0.25, w = settings.velocity_weight - 0.2;
      evaluation.result->partner.mean_joint_error_m = 0.3 + a * a + w * w;
      evaluation.result->moves.all = {
          .total = 100, .successful = static_cast<int>(100 * settings.alpha), .lenient = 100};
      return evaluation;
    };
  }
  std::vector<std::pair<double, double>> evaluated;
};

TEST(SweepShard, IsReadAsIOfN) {
  EXPECT_EQ(parse_sweep_shard("2/8")->index, 2);
  EXPECT_EQ(parse_sweep_shard("2/8")->count, 8);
  for (const char* text : {"0/8", "9/8", "2", "2/0", "a/b", "1/2/3", ""})
    EXPECT_FALSE(parse_sweep_shard(text)) << text;
}

TEST(SweepShard, ShardsTakeEveryPointExactlyOnce) {
  const Sweep sweep = sweep_of();
  ASSERT_EQ(point_count(sweep), 15);
  for (const int count : {1, 2, 4, 7, 15, 20}) {
    std::multiset<int> points;
    for (int index = 1; index <= count; ++index)
      for (const int point : points_of(sweep, {index, count})) points.insert(point);
    EXPECT_EQ(points.size(), 15U) << count;
    EXPECT_EQ(std::set<int>(points.begin(), points.end()).size(), 15U) << count;
    EXPECT_EQ(*points.begin(), 0);
    EXPECT_EQ(*points.rbegin(), 14);
  }
}

TEST(SweepShard, PointsAreDealtOutInTurn) {
  EXPECT_THAT(points_of(sweep_of(), {2, 4}), ElementsAre(1, 5, 9, 13));
}

TEST(Sweep, RunsAlongXFirstAndKeepsTheOtherSettings) {
  Sweep sweep = sweep_of();
  sweep.settings.neighbours = 77;
  const Settings settings = settings_at(sweep, 7);  // column 2, row 1
  EXPECT_EQ(settings.alpha, 0.5);
  EXPECT_EQ(settings.velocity_weight, 0.2);
  EXPECT_EQ(settings.neighbours, 77);
}

TEST(Sweep, IsRefusedWithEqualAxesOrAnUnknownMetric) {
  EXPECT_THAT(check_sweep(sweep_of("alpha=0:1:2", "alpha=2:3:2")).error().text(),
              HasSubstr("both axes are alpha"));
  Sweep sweep = sweep_of();
  sweep.metric = "partner.joy";
  EXPECT_THAT(check_sweep(sweep).error().text(), HasSubstr("partner.mean_joint_error_m, "));
  sweep.metric = "moves.per_label.turn.rate";
  EXPECT_TRUE(check_sweep(sweep));
}

TEST(Sweep, HandsOverEveryPointAsItIsDoneAndWritesNothing) {
  Bowl bowl;
  std::vector<int> heard;
  const Sweep sweep = sweep_of();
  const std::vector<int> points = {14, 0, 7};
  EXPECT_TRUE(evaluate_points(sweep, points, bowl.evaluator(),
                              [&](int point, const Result<Figures>& figures) {
                                EXPECT_EQ(bowl.evaluated.size(), heard.size() + 1) << "at once";
                                EXPECT_TRUE(figures->contains(sweep.metric));
                                heard.push_back(point);
                                return true;
                              },
                              {}));
  EXPECT_EQ(heard, points);
}

TEST(Sweep, APointThatCannotBeEvaluatedDoesNotKeepTheOthersFromIt) {
  Bowl bowl;
  const auto evaluator = bowl.evaluator();
  int failed = 0, good = 0;
  const Status done = evaluate_points(
      sweep_of(), std::vector<int>{0, 1, 2},
      [&](const Settings& settings, const Progress& progress) -> Result<Evaluation> {
        if (settings.alpha == 0.25) return Error{"not one of its steps could be solved", "take one"};
        return evaluator(settings, progress);
      },
      [&](int point, const Result<Figures>& figures) {
        figures ? ++good : ++failed;
        if (!figures) {
          EXPECT_EQ(point, 1);
          EXPECT_THAT(figures.error().text(), HasSubstr("alpha = 0.25"));
        }
        return true;
      },
      {});
  EXPECT_TRUE(done);
  EXPECT_EQ(failed, 1);
  EXPECT_EQ(good, 2);
}

TEST(Sweep, EndsWhenTheListenerOrTheProgressSaysSo) {
  Bowl bowl;
  const auto once = [](int, const Result<Figures>&) { return false; };
  const Status stopped = evaluate_points(sweep_of(), std::vector<int>{0, 1, 2}, bowl.evaluator(), once, {});
  EXPECT_EQ(stopped.error().message, "cancelled");
  EXPECT_EQ(bowl.evaluated.size(), 1U);
  const auto always = [](int, const Result<Figures>&) { return true; };
  const Status refused = evaluate_points(sweep_of(), std::vector<int>{0}, bowl.evaluator(), always,
                                         [](double, std::string_view) { return false; });
  EXPECT_EQ(refused.error().message, "cancelled");
  EXPECT_EQ(bowl.evaluated.size(), 1U);
}

TEST(Sweep, CoarseFirstTakesEveryPointOnceAndTheCornersAtTheBeginning) {
  const Sweep sweep = sweep_of();  // 5 columns, 3 rows
  const std::vector<int> order = coarse_first(sweep);
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), 15U);
  EXPECT_EQ(order.size(), 15U);
  EXPECT_EQ(std::set<int>(order.begin(), order.begin() + 4), (std::set<int>{0, 4, 10, 14}));
}

TEST(Sweep, AReportCanBeMadeOfFiguresGatheredByHandEvenWithGaps) {
  Bowl bowl;
  const Sweep sweep = sweep_of();
  std::vector<Figures> points(15);
  ASSERT_TRUE(evaluate_points(sweep, std::vector<int>{0, 6, 14}, bowl.evaluator(),
                              [&](int point, const Result<Figures>& figures) {
                                points[static_cast<std::size_t>(point)] = *figures;
                                return true;
                              },
                              {}));
  const SweepOutcome outcome = sweep_outcome(sweep, points);
  EXPECT_EQ(outcome.best, 6);  // alpha 0.25, w 0.2
  const auto json = nlohmann::json::parse(sweep_json(outcome));
  EXPECT_EQ(json["best"]["x"], 1);
  EXPECT_TRUE(json["points"][1]["value"].is_null());
  EXPECT_THAT(sweep_html(outcome), HasSubstr("</html>"));
  EXPECT_THROW((void)sweep_outcome(sweep, {}), std::invalid_argument);
}

TEST(SweepMetric, CanBeEveryFigureOfTheContract) {
  for (const char* name : {"moves.rate",
                           "zmp.original_m",
                           "zmp.synthesised_m",
                           "zmp.synthesised_asf",
                           "contact.hold_change_mean_m",
                           "contact.hold_change_p95_m",
                           "contact.holds_kept",
                           "contact.penetration_excess_p99_m",
                           "contact.foot_slide_m_per_s.synthesised",
                           "contact.bone_length_max",
                           "partner.mean_joint_error_m",
                           "partner.median_joint_error_m",
                           "partner.source_changes_per_100",
                           "partner.displacement_p99_m",
                           "partner.lag_ms",
                           "solve_us.p50",
                           "solve_us.p95",
                           "solve_us.p99",
                           "published.mpjpe_m.synthesised",
                           "published.fid_cd.synthesised"})
    EXPECT_TRUE(check_metric(name)) << name;
  for (const char* name : {"selection.10", "zmp.settings.floor_m", "moves", "", "seconds"})
    EXPECT_FALSE(check_metric(name)) << name;
}

TEST(SweepMetric, EveryFigureStatesItsGoal) {
  for (const std::string& name : metric_names()) {
    EXPECT_NO_THROW(goal_of(name)) << name;
    EXPECT_NE(goal_of(name), FigureGoal::None) << name;
  }
  EXPECT_EQ(goal_of("movement.pace.p50"), FigureGoal::None);
  EXPECT_EQ(goal_of("published.diversity.synthesised"), FigureGoal::None) << "best near the recording's";
  EXPECT_THROW(goal_of("contact.hugs"), std::invalid_argument);
}

TEST(SweepMetric, KnowsWhichValueIsBetter) {
  EXPECT_TRUE(is_better(goal_of("moves.rate"), 0.9, 0.8));
  EXPECT_TRUE(is_better(goal_of("moves.per_label.turn.lenient_rate"), 0.9, 0.8));
  EXPECT_TRUE(is_better(goal_of("contact.holds_kept"), 0.9, 0.8));
  EXPECT_TRUE(is_better(goal_of("partner.mean_joint_error_m"), 0.2, 0.3));
  EXPECT_TRUE(is_better(goal_of("solve_us.p99"), 200, 300));
  EXPECT_TRUE(is_better(goal_of("partner.lag_ms"), -10, 40));
  EXPECT_FALSE(is_better(goal_of("partner.lag_ms"), -50, 40));
  EXPECT_TRUE(is_better(goal_of("published.contact_f1.synthesised"), 0.9, 0.8));
  EXPECT_TRUE(is_better(goal_of("published.fid_cd.synthesised"), 3, 8));
}

TEST_F(SweepFolder, AnUnshardedSweepFindsTheBestPoint) {
  Bowl bowl;
  const auto outcome = run_sweep(sweep_of(), {}, folder_, bowl.evaluator(), {});
  ASSERT_TRUE(outcome) << outcome.error().text();
  EXPECT_THAT(outcome->missing, IsEmpty());
  EXPECT_EQ(bowl.evaluated.size(), 15U);
  EXPECT_EQ(grid_place(outcome->sweep, *outcome->best), std::pair(1, 1));
  EXPECT_THAT(files(), ElementsAre("shard-1-of-1.json", "sweep.html", "sweep.json"));
  const auto json = nlohmann::json::parse(text("sweep.json"));
  EXPECT_EQ(json["best"]["value"], 0.3);
  EXPECT_EQ(json["best"]["options"], "--preset paper --alpha 0.25");
  EXPECT_EQ(json["points"].size(), 15);
  EXPECT_EQ(json["points"][14]["x"], 4);
  EXPECT_EQ(json["points"][14]["y"], 2);
  EXPECT_EQ(json["points"][14]["figures"]["moves.rate"], 1.0);
}

TEST_F(SweepFolder, MergedShardsAreTheSameAsOneRun) {
  Bowl bowl;
  ASSERT_TRUE(run_sweep(sweep_of(), {}, folder_ / "whole", bowl.evaluator(), {}));
  for (const int index : {3, 1, 4, 2}) {
    EXPECT_FALSE(fs::exists(folder_ / "parts" / "sweep.json"));
    ASSERT_TRUE(run_sweep(sweep_of(), {index, 4}, folder_ / "parts", bowl.evaluator(), {}));
  }
  EXPECT_EQ(bowl.evaluated.size(), 30U);
  for (const char* name : {"sweep.json", "sweep.html"})
    EXPECT_EQ(*read_whole_file(folder_ / "parts" / name), *read_whole_file(folder_ / "whole" / name)) << name;
}

TEST_F(SweepFolder, MissingShardsAreNamed) {
  Bowl bowl;
  ASSERT_TRUE(run_sweep(sweep_of(), {2, 4}, folder_, bowl.evaluator(), {}));
  const auto outcome = run_sweep(sweep_of(), {4, 4}, folder_, bowl.evaluator(), {});
  EXPECT_THAT(outcome->missing, ElementsAre(1, 3));
  EXPECT_FALSE(outcome->best);
  EXPECT_THAT(files(), ElementsAre("shard-2-of-4.json", "shard-4-of-4.json"));
  EXPECT_THAT(merge_sweep(folder_, "")->missing, ElementsAre(1, 3));
}

TEST_F(SweepFolder, AShardThatIsThereIsNotEvaluatedAgain) {
  Bowl bowl;
  ASSERT_TRUE(run_sweep(sweep_of(), {1, 2}, folder_, bowl.evaluator(), {}));
  const std::size_t evaluated = bowl.evaluated.size();
  const auto again = run_sweep(sweep_of(), {1, 2}, folder_, bowl.evaluator(), {});
  EXPECT_TRUE(again->was_there);
  EXPECT_EQ(bowl.evaluated.size(), evaluated);
  const auto other = run_sweep(sweep_of(), {2, 2}, folder_, bowl.evaluator(), {});
  EXPECT_FALSE(other->was_there);
  EXPECT_EQ(bowl.evaluated.size(), 15U);
}

TEST_F(SweepFolder, ShardsOfAnotherSweepAreRefusedBeforeAnythingIsEvaluated) {
  Bowl bowl;
  ASSERT_TRUE(run_sweep(sweep_of(), {1, 2}, folder_, bowl.evaluator(), {}));
  bowl.evaluated.clear();
  const auto refusal = [&](const Sweep& sweep, SweepShard shard = {2, 2}) {
    const auto outcome = run_sweep(sweep, shard, folder_, bowl.evaluator(), {});
    return outcome ? "accepted" : outcome.error().text();
  };
  EXPECT_THAT(
      refusal(sweep_of("alpha=0:2:5")),
      HasSubstr("shard-1-of-2.json: belongs to another sweep: alpha has the values 0, 0.25, 0.5, 0.75, 1 "
                "instead of 0, 0.5, 1, 1.5, 2"));
  EXPECT_THAT(refusal(sweep_of("neighbours=5:20:4")), HasSubstr("x is alpha instead of neighbours"));
  Sweep other = sweep_of();
  other.data = "demo";
  EXPECT_THAT(refusal(other), HasSubstr("it evaluates cmu-salsa instead of demo"));
  other = sweep_of();
  other.settings.collisions = false;
  EXPECT_THAT(refusal(other), HasSubstr("collisions is on instead of off"));
  EXPECT_THAT(refusal(sweep_of(), {2, 3}), HasSubstr("is one of 2 shards, not of 3"));
  EXPECT_THAT(bowl.evaluated, IsEmpty());
  EXPECT_THAT(files(), ElementsAre("shard-1-of-2.json"));
}

TEST_F(SweepFolder, FilesThatAreNoShardsAreRefusedByName) {
  fs::create_directories(folder_);
  const auto refusal = [&](const std::string& content) {
    std::ofstream(folder_ / "shard-1-of-2.json") << content;
    return merge_sweep(folder_, "").error().text();
  };
  EXPECT_THAT(refusal("hello"), HasSubstr("shard-1-of-2.json: is no shard"));
  EXPECT_THAT(refusal(R"({"abrazo_sweep":1})"), HasSubstr("is damaged"));
  EXPECT_THAT(
      refusal(
          R"({"abrazo_sweep":1,"data":"d","metric":"moves.rate","x":{"setting":"alpha","values":["1","2"]},
      "y":{"setting":"neighbours","values":["5"]},"shard":1,"of":1,"points":[],"settings":{}})"),
      HasSubstr("does not hold the points"));
  EXPECT_THAT(
      refusal(R"({"abrazo_sweep":1,"data":"d","metric":"moves.rate","x":{"setting":"alfa","values":["1"]},
      "y":{"setting":"neighbours","values":["5"]},"shard":1,"of":1,"points":[{"figures":{}}],"settings":{}})"),
      HasSubstr("alfa"));
}

TEST_F(SweepFolder, AnEmptyFolderHasNothingToMerge) {
  fs::create_directories(folder_);
  EXPECT_THAT(merge_sweep(folder_, "").error().text(), HasSubstr("holds no shards"));
  EXPECT_THAT(merge_sweep(folder_ / "nowhere", "").error().text(), HasSubstr("cannot be read"));
}

TEST_F(SweepFolder, FinishedShardsCanBeDrawnForAnotherMetric) {
  Bowl bowl;
  ASSERT_TRUE(run_sweep(sweep_of(), {}, folder_, bowl.evaluator(), {}));
  const auto outcome = merge_sweep(folder_, "moves.rate");
  ASSERT_TRUE(outcome) << outcome.error().text();
  EXPECT_EQ(grid_place(outcome->sweep, *outcome->best).first, 4);
  EXPECT_THAT(text("sweep.html"), HasSubstr("moves.rate is best (highest) at alpha 1"));
  EXPECT_FALSE(merge_sweep(folder_, "moves.joy"));
}

TEST_F(SweepFolder, AFailedOrCancelledEvaluationLeavesNoFile) {
  const auto failing = [](const Settings&, const Progress&) -> Result<Evaluation> {
    return Error{"no takes", "m.json"};
  };
  EXPECT_EQ(run_sweep(sweep_of(), {}, folder_, failing, {}).error().text(),
            "m.json: no takes (at alpha = 0, velocity-weight = 0.1)");
  Bowl bowl;
  const Progress stop = [&](double, std::string_view) { return bowl.evaluated.size() < 3; };
  EXPECT_THAT(run_sweep(sweep_of(), {}, folder_, bowl.evaluator(), stop).error().text(),
              HasSubstr("cancelled"));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(SweepFolder, AMetricWithoutAValueIsAnErrorThatNamesThePoint) {
  Sweep sweep = sweep_of();
  sweep.metric = "moves.per_label.tango.rate";
  Bowl bowl;
  EXPECT_THAT(run_sweep(sweep, {}, folder_, bowl.evaluator(), {}).error().text(),
              HasSubstr("alpha = 0, velocity-weight = 0.1: moves.per_label.tango.rate has no value here"));
}

TEST_F(SweepFolder, ThePageShowsTheGridTheBestPointAndHowToUseIt) {
  Bowl bowl;
  ASSERT_TRUE(run_sweep(sweep_of(), {}, folder_, bowl.evaluator(), {}));
  const std::string html = text("sweep.html");
  EXPECT_THAT(
      html,
      HasSubstr(
          "partner.mean_joint_error_m is best (lowest) at alpha 0.25 and velocity-weight 0.2: 0.3000."));
  EXPECT_THAT(html, HasSubstr("<code>--preset paper --alpha 0.25</code>"));
  EXPECT_THAT(html, HasSubstr("stroke-width:3")) << "the best cell has a frame";
  EXPECT_THAT(html, Not(HasSubstr("lies at the edge")));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
}

TEST_F(SweepFolder, ThePageWarnsOfABestPointAtTheEdge) {
  Bowl bowl;
  ASSERT_TRUE(run_sweep(sweep_of("alpha=0.5:1:3"), {}, folder_, bowl.evaluator(), {}));
  EXPECT_THAT(text("sweep.html"), HasSubstr("lies at the edge of alpha (0.5)"));
}

TEST_F(SweepFolder, AnEdgeThatIsTheSettingsOwnEndIsNoReasonToGoOn) {
  const auto rising = [](const Settings& settings, const Progress&) -> Result<Evaluation> {
    Evaluation evaluation = test::example_evaluation();
    evaluation.result->partner.mean_joint_error_m = 1 + settings.alpha;
    return evaluation;
  };
  ASSERT_TRUE(run_sweep(sweep_of("alpha=0:1:3", "velocity-weight=0.2"), {}, folder_, rising, {}));
  EXPECT_THAT(text("sweep.html"), Not(HasSubstr("lies at the edge")));
}

TEST(SettingsOptions, GiveTheSettingsBack) {
  Settings settings = *preset("responsive");
  settings.neighbours = 25;
  settings.edge_weights = EdgeWeights::Uniform;
  EXPECT_EQ(settings_options(settings), "--preset responsive --neighbours 25 --edge-weights uniform");
}

}  // namespace
}  // namespace abrazo::sweep_test
