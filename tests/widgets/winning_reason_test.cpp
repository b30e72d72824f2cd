#include "widgets/candidates/winning_reason.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/widgets/synthetic_frames.hpp"

namespace abrazo::widgets::winning_reason_test {
namespace {

using testing::HasSubstr;

std::vector<CandidateRow> rows() {
  return candidate_rows(*test::synthetic_frame(0, 0), *test::two_take_library());
}

TEST(WinningReason, SayTheMarginAndTheTermThatDecidedIt) {
  // The second costs 0.02 more in pose and 0.5 x 0.05 more for the follower.
  EXPECT_THAT(winning_reason(rows()), HasSubstr("Winner by 0.045"));
  EXPECT_THAT(winning_reason(rows()), HasSubstr("follower"));
}

TEST(WinningReason, SayWhenTheSelectedIsNotTheCheapest) {
  auto found = rows();
  found[0].selected = false;
  found[2].selected = true;
  EXPECT_THAT(winning_reason(found), HasSubstr("Not the cheapest"));
}

TEST(WinningReason, SayWhenThereIsNothingToCompare) {
  EXPECT_EQ(winning_reason({}), "No candidate");
  EXPECT_EQ(winning_reason({rows()[0]}), "The only candidate");
}

/// Rows by intent, cheapest first; the first is selected. Terms [m] as in IntentCost.
std::vector<CandidateRow> rows_by_intent(const std::vector<std::array<double, most_cost_terms>>& terms) {
  std::vector<CandidateRow> found;
  for (const auto& of_row : terms) {
    CandidateRow row;
    row.method = SelectionMethod::Intent;
    row.terms = of_row;
    for (const double term : of_row) row.total += term;
    row.selected = found.empty();
    row.rank = static_cast<int>(found.size()) + 1;
    found.push_back(row);
  }
  return found;
}

TEST(WinningReasonOfIntent, SaysWhatAChangeIsFor) {
  auto nearer = rows_by_intent({{0.10, 0.05, 0.02, 0, 0.03}, {0.16, 0.06, 0.02, 0, 0}});
  nearer[1].goes_on = true;
  EXPECT_EQ(winning_reason(nearer), "Change: partner expected 0.060 m nearer than going on");
  auto likelier = rows_by_intent({{0.10, 0.05, 0.02, 0, 0.03}, {0.11, 0.05, 0.09, 0, 0}});
  likelier[1].goes_on = true;
  EXPECT_EQ(winning_reason(likelier), "Change: 0.080 m better than going on — likelier move")
      << "the margin, which it paid, left out";
}

TEST(WinningReasonOfIntent, SaysThatGoingOnWasVetoed) {
  auto found = rows_by_intent({{0.10, 0.05, 0.02, 0, 0.03}, {0.16, 0.06, 0.02, 0, 0}});
  found[1].goes_on = found[1].vetoed = true;
  EXPECT_EQ(winning_reason(found), "Change: continuing is vetoed");
}

TEST(WinningReasonOfIntent, SaysWhetherOnlyTheMarginHeldTheSource) {
  EXPECT_EQ(winning_reason(candidate_rows(*test::frame_by_intent(0, 0), *test::two_take_library())),
            "Continues: #2 is 0.020 m better, less than the margin");
  auto better = rows_by_intent({{0.10, 0.02, 0.02, 0, 0}, {0.11, 0.05, 0.02, 0, 0.03}});
  better[0].goes_on = true;
  EXPECT_EQ(winning_reason(better), "Continues, 0.040 m better than #2 — motion of the leader");
  auto equal = rows_by_intent({{0.10, 0.02, 0.02, 0, 0}, {0.10, 0.02, 0.02, 0, 0.03}});
  equal[0].goes_on = true;
  EXPECT_EQ(winning_reason(equal), "Continues: #2 is as good, but would be a change");
}

TEST(WinningReasonOfIntent, ComparesWithTheSecondWhereNothingGoesOn) {
  const auto found = rows_by_intent({{0.10, 0.05, 0.02, 0, 0}, {0.10, 0.05, 0.02, 0.2, 0}});
  EXPECT_EQ(winning_reason(found), "Margin 0.200 m to #2 — the intended move");
  EXPECT_EQ(winning_reason(rows_by_intent({{0.10, 0.05, 0.02, 0, 0}, {0.10, 0.05, 0.02, 0, 0}})),
            "A tie with #2");
}

TEST(WinningReasonOfIntent, SaysWhenTheSelectedIsNotTheCheapest) {
  auto found = rows_by_intent({{0.10, 0.05, 0.02, 0, 0.03}, {0.16, 0.06, 0.02, 0, 0}});
  found[0].selected = false;
  found[1].selected = true;
  EXPECT_EQ(winning_reason(found), "Not the cheapest: 0.040 m above it");
}

TEST(LikelyMoves, AreTheLikeliestAndASecondThatIsLikely) {
  const std::vector<std::string> labels = {"turn", "", "cross_body", "walk"};
  EXPECT_EQ(likely_moves(labels, std::vector<float>{0.2F, 0.05F, 0.72F, 0.03F}),
            "Likely move: cross body 72 %, turn 20 %");
  EXPECT_EQ(likely_moves(labels, std::vector<float>{0.04F, 0.9F, 0.03F, 0.03F}),
            "Likely move: no label 90 %");
}

TEST(LikelyMoves, AreNotToldWhereNothingIsKnownOfThem) {
  EXPECT_EQ(likely_moves({}, {}), "");
  EXPECT_EQ(likely_moves(std::vector<std::string>{""}, std::vector<float>{1}), "") << "no labels at all";
  EXPECT_EQ(likely_moves(std::vector<std::string>{"turn"}, {}), "") << "of another model";
}

}  // namespace
}  // namespace abrazo::widgets::winning_reason_test
