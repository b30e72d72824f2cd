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
  EXPECT_THAT(winning_reason(rows()), HasSubstr("Winner by 0.045 m²"));
  EXPECT_THAT(winning_reason(rows()), HasSubstr("follower"));
}

TEST(WinningReason, SayWhenTheSelectedIsNotTheCheapest) {
  auto found = rows();
  found[0].selected = false;
  found[2].selected = true;
  EXPECT_THAT(winning_reason(found), HasSubstr("Not the cheapest"));
}

TEST(WinningReason, NamesThePinOrTheVetoThatDecided) {
  auto found = rows();
  found[0].selected = false;
  found[1].selected = true;
  found[0].vetoed = true;
  EXPECT_THAT(winning_reason(found), HasSubstr("#1 is vetoed by you: #1 costs 0.045"));
  found[0].vetoed = false;
  found[1].pinned = true;
  EXPECT_THAT(winning_reason(found), HasSubstr("Pinned by you: #1 costs 0.045"));
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
  nearer[1].continues_source = true;
  EXPECT_EQ(winning_reason(nearer), "Change: continuing (#2) costs 0.040 m more — partner expected nearer");
  auto likelier = rows_by_intent({{0.10, 0.05, 0.02, 0, 0.03}, {0.11, 0.05, 0.09, 0, 0}});
  likelier[1].continues_source = true;
  EXPECT_EQ(winning_reason(likelier), "Change: continuing (#2) costs 0.050 m more — likelier move")
      << "as the totals say, in which it paid for the change";
}

TEST(WinningReasonOfIntent, SaysThatGoingOnWasVetoed) {
  auto found = rows_by_intent({{0.10, 0.05, 0.02, 0, 0.03}, {0.16, 0.06, 0.02, 0, 0}});
  found[1].continues_source = found[1].vetoed = true;
  EXPECT_EQ(winning_reason(found), "Change: continuing is vetoed");
}

TEST(WinningReasonOfIntent, SaysHowMuchOfTheDifferenceIsForTheChange) {
  EXPECT_EQ(winning_reason(candidate_rows(*test::frame_by_intent(0, 0), *test::two_take_library())),
            "Continues: #2 costs 0.010 m more, because of the 0.030 m for the change");
  auto better = rows_by_intent({{0.10, 0.02, 0.02, 0, 0}, {0.11, 0.05, 0.02, 0, 0.03}});
  better[0].continues_source = true;
  EXPECT_EQ(winning_reason(better), "Continues: #2 costs 0.070 m more — motion of the leader");
  auto mostly = rows_by_intent({{0.10, 0.02, 0.02, 0, 0}, {0.11, 0.02, 0.02, 0, 0.06}});
  mostly[0].continues_source = true;
  EXPECT_EQ(winning_reason(mostly), "Continues: #2 costs 0.070 m more, 0.060 m of it for the change");
  auto equal = rows_by_intent({{0.10, 0.02, 0.02, 0, 0}, {0.10, 0.02, 0.02, 0, 0.03}});
  equal[0].continues_source = true;
  EXPECT_EQ(winning_reason(equal), "Continues: #2 costs 0.030 m more, all of it for the change");
}

TEST(WinningReasonOfIntent, NamesTheDifferenceThatThePersonFindsWhoSubtractsTheRows) {
  // 0.1504 and 0.1796 read 0.150 and 0.180; their difference, 0.0292, would read 0.029.
  auto found = rows_by_intent({{0.1504, 0, 0, 0, 0}, {0.1796, 0, 0, 0, 0}});
  EXPECT_EQ(winning_reason(found), "#2 costs 0.030 m more — partner expected nearer");
  found[0].continues_source = true;
  EXPECT_EQ(winning_reason(found), "Continues: #2 costs 0.030 m more — partner expected nearer");
  const auto near = rows_by_intent({{0.1501, 0, 0, 0, 0}, {0.1503, 0, 0, 0, 0}});
  EXPECT_EQ(winning_reason(near), "#2 costs less than 0.001 m more — partner expected nearer");
}

TEST(WinningReasonOfIntent, TellsTheMarginFromTheDistanceToTheShownPartner) {
  auto found = rows_by_intent({{0.10, 0.02, 0.02, 0, 0, 0}, {0.10, 0.02, 0.02, 0, 0.1, 0.22}});
  found[0].continues_source = true;
  EXPECT_EQ(winning_reason(found),
            "Continues: #2 costs 0.320 m more, 0.220 m of it for leaving the shown partner");
}

TEST(WinningReasonOfIntent, ComparesWithTheSecondWhereNothingGoesOn) {
  const auto found = rows_by_intent({{0.10, 0.05, 0.02, 0, 0}, {0.10, 0.05, 0.02, 0.2, 0}});
  EXPECT_EQ(winning_reason(found), "#2 costs 0.200 m more — the intended move");
  EXPECT_EQ(winning_reason(rows_by_intent({{0.10, 0.05, 0.02, 0, 0}, {0.10, 0.05, 0.02, 0, 0}})),
            "A tie with #2");
}

TEST(WinningReasonOfIntent, SaysWhenTheSelectedIsNotTheCheapest) {
  auto found = rows_by_intent({{0.10, 0.05, 0.02, 0, 0.03}, {0.16, 0.06, 0.02, 0, 0}});
  found[0].selected = false;
  found[1].selected = true;
  EXPECT_EQ(winning_reason(found), "Not the cheapest: #1 costs 0.040 m less");
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
