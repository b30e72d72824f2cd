#include "core/evaluation/tables/suggestion_agreement.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/choreography/salsa.hpp"
#include "core/evaluation/report/suggestion_report.hpp"
#include "core/library/build/motion_library_builder.hpp"

namespace abrazo::suggestion_agreement_test {
namespace {

const std::vector<LabelInterval> truth = {{0, 100, "turn", "alt=cross_body_lead", ""},
                                          {100, 200, "open_hold", "", ""}};

TEST(LabelAgreement, OfTheLabelsThemselvesIsWhole) {
  const LabelAgreement same = label_agreement(truth, truth);
  EXPECT_EQ(same.frame_share(), 1);
  EXPECT_EQ(same.f1(), 1);
  EXPECT_EQ(same.boundary_errors, (std::vector<double>{0, 0, 0, 0}));
}

TEST(LabelAgreement, CountsFramesMovesAndBoundaries) {
  // Begins 20 frames late and ends 10 early: 70 of the turn's frames, all of the hold's.
  const LabelAgreement late =
      label_agreement(truth, {{20, 90, "turn", "", ""}, {90, 200, "open_hold", "", ""}});
  EXPECT_DOUBLE_EQ(late.frame_share(), 170.0 / 200);
  EXPECT_EQ(late.found, 2);
  EXPECT_EQ(late.boundary_errors, (std::vector<double>{20, 10, 10, 0}));
}

TEST(LabelAgreement, FindsNothingThatCoversLessThanHalf) {
  const LabelAgreement half =
      label_agreement(truth, {{0, 49, "turn", "", ""}, {100, 150, "open_hold", "", ""}});
  EXPECT_EQ(half.found, 1);
  EXPECT_DOUBLE_EQ(half.f1(), 0.5);
}

TEST(LabelAgreement, TakesAlternativesWhenLenient) {
  const LabelAgreement other = label_agreement(truth, {{0, 100, "cross_body_lead", "", ""}});
  EXPECT_EQ(other.frame_share(), 0);
  EXPECT_DOUBLE_EQ(other.lenient_frame_share(), 0.5);
  EXPECT_EQ(other.found_lenient, 1);
}

TEST(Reliability, ComparesConfidenceWithWhatWasRight) {
  const std::vector<SuggestionAgreement::Trial> trials = {
      {0.81, true, true}, {0.89, true, true}, {0.15, false, true}, {0.15, true, true}};
  const auto bins = reliability(trials, 10);
  EXPECT_EQ(bins[8].count, 2);
  EXPECT_DOUBLE_EQ(bins[8].mean_confidence, 0.85);
  EXPECT_DOUBLE_EQ(bins[8].right, 1);
  EXPECT_DOUBLE_EQ(bins[1].right, 0.5);
  EXPECT_DOUBLE_EQ(calibration_error(bins), (2 * 0.15 + 2 * 0.35) / 4);
}

MotionLibrary dances() {
  return std::move(*build_library(
      "dances", generate_salsa({.seed = 5, .minutes = 0.7, .take_seconds = 14, .a = {}, .b = {}}),
      {.excluded_takes = {}, .rate_hz = 15}, {}));
}

TEST(SuggestionAgreement, SuggestsEveryTakeFromTheOthers) {
  const auto agreement = measure_suggestions(dances(), {});
  ASSERT_TRUE(agreement) << agreement.error().text();
  EXPECT_EQ(agreement->takes.size(), 3U);
  const LabelAgreement all = agreement->all(&SuggestionAgreement::TakeResult::moves);
  const LabelAgreement majority = agreement->all(&SuggestionAgreement::TakeResult::majority);
  EXPECT_EQ(all.frames, majority.frames);
  EXPECT_GT(all.frame_share(), majority.frame_share());
  EXPECT_EQ(agreement->role_share(), 1);

  const auto json = nlohmann::json::parse(suggestion_json(*agreement, "dances"));
  EXPECT_EQ(json["suggestions"]["frame_share"], all.frame_share());
  EXPECT_EQ(json["takes"].size(), 3U);
  EXPECT_NE(suggestion_html(*agreement, "dances").find("Agreement with the labels"), std::string::npos);
}

TEST(SuggestionAgreement, NeedsTwoLabelledTakes) {
  LibraryColumns columns = dances().columns();
  for (std::size_t take = 1; take < columns.takes.size(); ++take) columns.takes[take].labels = {};
  const auto agreement = measure_suggestions(MotionLibrary(std::move(columns)), {});
  ASSERT_FALSE(agreement);
  EXPECT_EQ(agreement.error().text(),
            "dances: agreement needs at least two labelled takes, each is suggested from the others");
}

}  // namespace
}  // namespace abrazo::suggestion_agreement_test
