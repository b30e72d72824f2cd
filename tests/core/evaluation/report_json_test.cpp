#include "core/evaluation/report/report_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/core/evaluation/report_example.hpp"

namespace abrazo::report_json_test {
namespace {

using ::testing::ElementsAre;

nlohmann::json report(const Evaluation& evaluation) {
  return nlohmann::json::parse(report_json(evaluation));
}

void expect_keys(const nlohmann::json& object, std::initializer_list<const char*> keys) {
  for (const char* key : keys) EXPECT_TRUE(object.contains(key)) << key;
}

TEST(ReportJson, HasTheFieldsOfTheContract) {
  const nlohmann::json json = report(test::example_evaluation());
  expect_keys(json.at("selection").at(0), {"k", "recall_best", "recall_best2", "query_us"});
  expect_keys(json.at("timing").at(0), {"pairs", "knn_us", "brute_us"});
  expect_keys(json.at("moves"), {"total", "successful", "rate", "per_take", "per_label", "confusion"});
  expect_keys(json.at("zmp"),
              {"original_m", "synthesised_m", "original_asf", "synthesised_asf", "skipped_frames"});
  expect_keys(json.at("contact"), {"hold_change_mean_m", "hold_change_p95_m", "holds_kept",
                                   "penetration_excess_p99_m", "foot_slide_m_per_s", "bone_length_max"});
  expect_keys(json.at("contact").at("foot_slide_m_per_s"), {"original", "synthesised"});
  expect_keys(json.at("movement"),
              {"speed_p99_m_per_s", "acceleration_rms", "slide_m_per_s", "slide_share_fast", "hover_p90_m",
               "captured_holds_held", "captured_hold_distance_mean_m", "changes_per_s", "pace"});
  for (const char* key : {"speed_p99_m_per_s", "acceleration_rms", "slide_m_per_s", "slide_share_fast"})
    expect_keys(json.at("movement").at(key), {"captured", "synthesised"});
  expect_keys(json.at("movement").at("pace"), {"p05", "p50", "p95"});
  expect_keys(json.at("partner"), {"mean_joint_error_m", "median_joint_error_m", "source_changes_per_100",
                                   "displacement_p99_m", "lag_ms"});
  expect_keys(json.at("solve_us"), {"p50", "p95", "p99"});
}

TEST(ReportJson, HasTheFiguresOfTheLiteratureWithTheirBaselines) {
  const nlohmann::json published = report(test::example_evaluation()).at("published");
  EXPECT_EQ(published.at("clips"), 44);
  expect_keys(published, {"mpjpe_m", "mpjve_m", "foot_sliding_m", "skating_share", "jitter_10_m_s3",
                          "penetration_share", "penetration_depth_m", "contact_precision", "contact_recall",
                          "contact_f1", "turned_away_share", "beat_echo_degree", "fid_cd", "diversity"});
  EXPECT_NEAR(published.at("mpjpe_m").at("synthesised"), 0.02, 1e-12);
  EXPECT_NEAR(published.at("mpjpe_m").at("nearest_neighbour"), 0.16, 1e-12);
  EXPECT_NEAR(published.at("mpjpe_m").at("recording"), 0.3, 1e-12);
}

TEST(ReportJson, KeepsEveryNumberToTheLastBit) {
  Evaluation evaluation = test::example_evaluation();
  evaluation.result->partner.mean_joint_error_m = 1.0 / 3;
  evaluation.result->solve.p99_us = 700.1;
  evaluation.selection[0].rows[1].recall_best = 0.1 + 0.2;
  const nlohmann::json json = report(evaluation);
  EXPECT_EQ(json["partner"]["mean_joint_error_m"].get<double>(), 1.0 / 3);
  EXPECT_EQ(json["solve_us"]["p99"].get<double>(), 700.1);
  EXPECT_EQ(json["selection"][1]["recall_best"].get<double>(), 0.1 + 0.2);
}

TEST(ReportJson, PutsEachFigureUnderItsOwnName) {
  const nlohmann::json json = report(test::example_evaluation());
  EXPECT_EQ(json["data"], "cmu-salsa");
  EXPECT_THAT(json["takes"], ElementsAre("salsa_01", "salsa_02"));
  EXPECT_EQ(json["settings"]["neighbours"], 25);
  EXPECT_EQ(json["settings"]["collisions"], true);
  EXPECT_EQ(json["moves"]["successful"], 14);
  EXPECT_EQ(json["moves"]["lenient"], 16);
  EXPECT_EQ(json["moves"]["rate"], 0.7);
  EXPECT_EQ(json["moves"]["per_label"]["turn"]["total"], 8);
  EXPECT_EQ(json["moves"]["confusion"][0], (nlohmann::json{2, 2, 0, 1}));
  EXPECT_EQ(json["moves"]["steps"][2][2], 82);
  EXPECT_EQ(json["contact"]["foot_slide_m_per_s"]["original"], 0.155);
  EXPECT_EQ(json["contact"]["foot_slide_m_per_s"]["synthesised"], 0.048);
  EXPECT_EQ(json["contact"]["penetration_excess_p99_m"], 0.004);
  EXPECT_EQ(json["partner"]["displacement_p99_m"], 0.22);
  EXPECT_EQ(json["partner"]["original"]["displacement_p99_m"], 0.11);
}

TEST(ReportJson, HasTheMovementOverAllTakesAndOfEach) {
  Evaluation evaluation = test::example_evaluation();
  evaluation.result->movement.per_take[1].captured_holds_held = std::nan("");
  const nlohmann::json movement = report(evaluation)["movement"];
  EXPECT_EQ(movement["speed_p99_m_per_s"]["synthesised"], 4.46);
  EXPECT_EQ(movement["speed_p99_m_per_s"]["captured"], 1.57);
  EXPECT_EQ(movement["hover_p90_m"], 0.072);
  EXPECT_EQ(movement["pace"]["standing_share"], 0.5);
  ASSERT_EQ(movement["per_take"].size(), 2);
  EXPECT_EQ(movement["per_take"][1]["take"], "salsa_02");
  EXPECT_EQ(movement["per_take"][1]["pace"]["p95"], 3);
  EXPECT_TRUE(movement["per_take"][1]["captured_holds_held"].is_null()) << "nobody held hands in the take";
}

TEST(ReportJson, HasTheZmpErrorOverFramesThatCountInBothMotions) {
  const nlohmann::json zmp = report(test::example_evaluation())["zmp"];
  EXPECT_EQ(zmp["common_frames"]["frames"], 1650);
  EXPECT_NEAR(zmp["partner_common_frames"]["ratio"], 0.04 / 0.035, 1e-12);
  EXPECT_EQ(zmp["partner_left_out"]["free_fall_frames"]["synthesised"], 30);
  EXPECT_EQ(zmp["partner_left_out"]["no_support_frames"]["original"], 2);
  EXPECT_EQ(zmp["partner_left_out"]["frames_that_count"]["synthesised"], 850);
}

TEST(ReportJson, GivesTheLagInMillisecondsAndTheZmpErrorInAsfUnits) {
  Evaluation evaluation = test::example_evaluation();
  evaluation.result->partner.lag_s = -0.125;
  evaluation.result->zmp.original_m = 0.0564444;  // one unit: 1 / 0.45 inch
  const nlohmann::json json = report(evaluation);
  EXPECT_EQ(json["partner"]["lag_ms"], -125);
  EXPECT_NEAR(json["zmp"]["original_asf"].get<double>(), 1, 1e-5);
  EXPECT_EQ(json["zmp"]["settings"]["contact_height_m"], 0.1);
}

TEST(ReportJson, HasTheFullRateTableAsSelectionAndAllTablesBesideIt) {
  const nlohmann::json json = report(test::example_evaluation());
  ASSERT_EQ(json["selection_tables"].size(), 2);
  EXPECT_EQ(json["selection_tables"][0]["rate_hz"], 60);
  EXPECT_EQ(json["selection_tables"][1]["pairs"], 6500);
  EXPECT_EQ(json["selection"], json["selection_tables"][0]["rows"]);
  EXPECT_NE(json["selection"], json["selection_tables"][1]["rows"]);
}

TEST(ReportJson, ListsOtherBuildsAndDisturbedUsersByName) {
  const nlohmann::json json = report(test::example_evaluation());
  ASSERT_EQ(json["builds"].size(), 2);
  ASSERT_EQ(json["disturbed"].size(), 3);
  EXPECT_EQ(json["builds"][1]["name"], "arms 20 % longer");
  EXPECT_EQ(json["disturbed"][2]["partner"]["mean_joint_error_m"], 0.47);
  expect_keys(json["disturbed"][0], {"moves", "partner", "contact", "zmp", "solve_us"});
}

TEST(ReportJson, LeavesOutWhatWasNotAskedFor) {
  Evaluation only_selection = test::example_evaluation();
  only_selection.result.reset();
  only_selection.timing.clear();
  only_selection.builds.clear();
  only_selection.disturbed.clear();
  const nlohmann::json selection = report(only_selection);
  EXPECT_TRUE(selection.contains("selection"));
  for (const char* part : {"timing", "moves", "zmp", "contact", "partner", "solve_us", "builds", "disturbed"})
    EXPECT_FALSE(selection.contains(part)) << part;

  Evaluation only_zmp = test::example_evaluation();
  only_zmp.selection.clear();
  only_zmp.has_moves = only_zmp.has_contact = false;
  const nlohmann::json zmp = report(only_zmp);
  EXPECT_TRUE(zmp.contains("zmp"));
  EXPECT_TRUE(zmp.contains("partner")) << "any synthesis gives it";
  for (const char* part : {"selection", "selection_tables", "moves", "contact"})
    EXPECT_FALSE(zmp.contains(part)) << part;
  EXPECT_FALSE(zmp["builds"][0].contains("moves"));

  Evaluation only_moves = test::example_evaluation();
  only_moves.has_zmp = only_moves.has_contact = false;
  EXPECT_FALSE(report(only_moves).contains("zmp"));
  EXPECT_FALSE(report(only_moves)["builds"][0].contains("zmp"));
}

TEST(ReportJson, SaysNullAndNotZeroWhereAFigureIsNotDefined) {
  Evaluation evaluation = test::example_evaluation();
  evaluation.result->moves = {};
  evaluation.step_rate_hz = 0;
  evaluation.result->contact.bone_length_max = std::numeric_limits<double>::quiet_NaN();
  const nlohmann::json json = report(evaluation);
  EXPECT_EQ(json["moves"]["total"], 0);
  EXPECT_TRUE(json["moves"]["rate"].is_null());
  EXPECT_TRUE(json["step_rate_hz"].is_null());
  EXPECT_TRUE(json["contact"]["bone_length_max"].is_null());
}

}  // namespace
}  // namespace abrazo::report_json_test
