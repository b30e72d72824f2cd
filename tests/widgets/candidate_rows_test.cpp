#include "widgets/candidates/candidate_rows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/candidates/candidate_order.hpp"

namespace abrazo::widgets::candidate_rows_test {
namespace {

std::vector<CandidateRow> rows() {
  return candidate_rows(*test::synthetic_frame(0, 0), *test::two_take_library());
}

std::vector<CandidateRow> rows_by_intent() {
  return candidate_rows(*test::frame_by_intent(0, 0), *test::two_take_library());
}

double sum(const CandidateRow& row) {
  double all = 0;
  for (const double term : row.terms) all += term;
  return all;
}

TEST(CandidateRows, ComeCheapestFirst) {
  const auto found = rows();
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LE(found[i - 1].total, found[i].total);
}

TEST(CandidateRows, PartsAddUpToTheTotal) {
  for (const CandidateRow& row : rows()) EXPECT_NEAR(sum(row), row.total, 1e-12);
  for (const CandidateRow& row : rows_by_intent()) EXPECT_NEAR(sum(row), row.total, 1e-12);
}

TEST(CandidateRows, SpeakTheTermsOfEquation7) {
  const CandidateRow first = rows()[0];
  EXPECT_EQ(first.method, SelectionMethod::Paper);
  EXPECT_DOUBLE_EQ(value_of(first, CostTerm::Pose), 0.1);
  EXPECT_DOUBLE_EQ(value_of(first, CostTerm::Active), 0.5 * 0.02) << "times alpha";
  EXPECT_DOUBLE_EQ(value_of(first, CostTerm::Passive), 0.5 * 0.04);
  EXPECT_EQ(value_of(first, CostTerm::Partner), 0) << "no term of it";
  EXPECT_FALSE(first.continues_source);
}

TEST(CandidateRows, SpeakTheTermsOfIntentWhereItDecided) {
  const CandidateRow second = rows_by_intent()[1];
  EXPECT_EQ(second.method, SelectionMethod::Intent);
  EXPECT_DOUBLE_EQ(value_of(second, CostTerm::Partner), 0.09);
  EXPECT_DOUBLE_EQ(value_of(second, CostTerm::Leader), 0.05);
  EXPECT_DOUBLE_EQ(value_of(second, CostTerm::Move), 0.03);
  EXPECT_EQ(value_of(second, CostTerm::Meant), 0);
  EXPECT_DOUBLE_EQ(value_of(second, CostTerm::Change), 0.03);
  EXPECT_DOUBLE_EQ(second.total, 0.20);
  EXPECT_NEAR(second.equation_7, 0.12 + 0.5 * (0.02 + 0.09), 1e-12) << "still told";
}

TEST(CandidateRows, MarkTheOneThatGoesOnWithTheSource) {
  const auto found = rows_by_intent();
  EXPECT_TRUE(found[0].continues_source);
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_FALSE(found[i].continues_source) << i;
}

TEST(CandidateRows, SpeakOfEquation7WhenACandidateLacksTheCostOfIntent) {
  FrameSnapshot frame = *test::frame_by_intent(0, 0);
  frame.result.candidates[3].intent.reset();
  for (const CandidateRow& row : candidate_rows(frame, *test::two_take_library()))
    EXPECT_EQ(row.method, SelectionMethod::Paper);
}

TEST(CandidateRows, ThatAreNotMeantAreOutByEquation7AndDearerByIntent) {
  CandidateRow row = rows()[0];
  row.not_meant = true;
  EXPECT_TRUE(row.is_out());
  row = rows_by_intent()[0];
  row.not_meant = true;
  EXPECT_FALSE(row.is_out());
  row.vetoed = true;
  EXPECT_TRUE(row.is_out());
}

TEST(DecidingMethod, IsThatOfTheCandidatesAndUnknownWithoutAny) {
  EXPECT_EQ(deciding_method(test::synthetic_frame(0, 0)->result), SelectionMethod::Paper);
  EXPECT_EQ(deciding_method(test::frame_by_intent(0, 0)->result), SelectionMethod::Intent);
  EXPECT_FALSE(deciding_method(FrameResult{}));
}

TEST(CostTerms, EachHaveTheirPlaceAndColumnInOneMethod) {
  for (const SelectionMethod method : {SelectionMethod::Paper, SelectionMethod::Intent}) {
    const auto terms = cost_terms(method).terms;
    ASSERT_LE(terms.size(), most_cost_terms);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      EXPECT_EQ(place_of(terms[i].term, method), i);
      EXPECT_EQ(&info_of(terms[i].term), &terms[i]);
      EXPECT_EQ(term_of(column_of(terms[i].term)), terms[i].term);
      EXPECT_EQ(column_title(column_of(terms[i].term)), terms[i].title);
      EXPECT_THAT(candidate_columns(method), testing::Contains(column_of(terms[i].term)));
    }
  }
  EXPECT_FALSE(place_of(CostTerm::Pose, SelectionMethod::Intent));
}

TEST(CandidateOrder, GoesByRankWhereItsColumnIsOneOfTheOtherMethod) {
  const CandidateOrder by_partner{CandidateColumn::Partner, true};
  EXPECT_EQ(order_within(by_partner, SelectionMethod::Intent), by_partner);
  EXPECT_EQ(order_within(by_partner, SelectionMethod::Paper), CandidateOrder{});
  const CandidateOrder by_distance{CandidateColumn::Distance, true};
  EXPECT_EQ(order_within(by_distance, SelectionMethod::Paper), by_distance) << "that both have";
}

TEST(CandidateOrder, SortsByEveryTermOfIntent) {
  auto found = rows_by_intent();
  sort_rows(found, {CandidateColumn::Leader, false});
  EXPECT_EQ(found.front().rank, 2);
  sort_rows(found, {CandidateColumn::Change, true});
  EXPECT_EQ(found.back().rank, 1) << "only the first is no change";
}

TEST(CandidateOrder, ShowsEveryFigureWithItsUnit) {
  EXPECT_EQ(figure_unit(rows()[0], CandidateColumn::Total), " m²");
  EXPECT_EQ(figure_unit(rows()[0], CandidateColumn::Distance), " m");
  EXPECT_EQ(figure_unit(rows_by_intent()[0], CandidateColumn::Total), " m");
}

TEST(CandidateRows, NameTheirSourceAndMove) {
  EXPECT_EQ(rows()[0].take, "salsa_01");
  EXPECT_EQ(rows()[0].label, "turn");
  EXPECT_EQ(rows()[4].take, "salsa_02");
  EXPECT_EQ(rows()[4].label, "open_hold");
}

TEST(CandidateRows, BarsEndWhereTheirPartsDo) {
  CandidateRow row;
  row.terms = {1, 0.5, 0.5};
  row.total = 2;
  const auto ends = bar_ends(row, 4, 0);
  EXPECT_DOUBLE_EQ(ends[0], 0.25);
  EXPECT_DOUBLE_EQ(ends[1], 0.375);
  EXPECT_DOUBLE_EQ(ends[2], 0.5);
  EXPECT_DOUBLE_EQ(ends[4], 0.5) << "terms that there are not take no room";
  EXPECT_DOUBLE_EQ(bar_ends(row, 0, 0)[2], 0);
}

TEST(CandidateRows, BarsShowEveryPartThatThereIs) {
  CandidateRow row;
  row.terms = {0.0001, 3.9999, 0};
  row.total = 4;
  const auto ends = bar_ends(row, 4, 0.01);
  EXPECT_GE(ends[0], 0.01);
  EXPECT_GT(ends[1], 0.9);
  EXPECT_LE(ends[1], 1);
  EXPECT_DOUBLE_EQ(ends[2], ends[1]) << "nothing is shown of a part that is not there";
}

TEST(CandidateRows, TellTheMarginForAChangeFromTheDistanceToTheShownPartner) {
  FrameSnapshot frame = *test::frame_by_intent(0, 0);
  frame.result.candidates[1].intent->temporal = 0.05;
  frame.result.candidates[1].intent->total += 0.05;
  for (const CandidateRow& row : candidate_rows(frame, *test::two_take_library())) {
    EXPECT_NEAR(sum(row), row.total, 1e-12);
    if (row.candidate != 1) continue;
    EXPECT_DOUBLE_EQ(value_of(row, CostTerm::Change), 0.03);
    EXPECT_DOUBLE_EQ(value_of(row, CostTerm::Temporal), 0.05);
  }
}

}  // namespace
}  // namespace abrazo::widgets::candidate_rows_test
