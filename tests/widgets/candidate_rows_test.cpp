#include "widgets/candidates/candidate_rows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/widgets/synthetic_frames.hpp"

namespace abrazo::widgets {
namespace {

using testing::HasSubstr;

std::vector<CandidateRow> rows() {
  return candidate_rows(*test::synthetic_frame(0, 0), *test::two_take_library());
}

TEST(CandidateRows, ComeCheapestFirst) {
  const auto found = rows();
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LE(found[i - 1].total, found[i].total);
}

TEST(CandidateRows, PartsAddUpToTheTotal) {
  for (const CandidateRow& row : rows()) EXPECT_NEAR(row.pose + row.active + row.passive, row.total, 1e-12);
}

TEST(CandidateRows, NameTheirSourceAndMove) {
  EXPECT_EQ(rows()[0].take, "salsa_01");
  EXPECT_EQ(rows()[0].label, "turn");
  EXPECT_EQ(rows()[4].take, "salsa_02");
  EXPECT_EQ(rows()[4].label, "open_hold");
}

TEST(CandidateRows, BarsEndWhereTheirPartsDo) {
  CandidateRow row;
  row.pose = 1, row.active = 0.5, row.passive = 0.5, row.total = 2;
  const BarEnds ends = bar_ends(row, 4);
  EXPECT_DOUBLE_EQ(ends.pose, 0.25);
  EXPECT_DOUBLE_EQ(ends.active, 0.375);
  EXPECT_DOUBLE_EQ(ends.passive, 0.5);
  EXPECT_DOUBLE_EQ(bar_ends(row, 0).passive, 0);
}

TEST(CandidateRows, SayTheMarginAndTheTermThatDecidedIt) {
  // The second costs 0.02 more in pose and 0.5 x 0.05 more for the follower.
  EXPECT_THAT(winning_reason(rows()), HasSubstr("Winner by 0.045"));
  EXPECT_THAT(winning_reason(rows()), HasSubstr("follower"));
}

TEST(CandidateRows, SayWhenTheSelectedIsNotTheCheapest) {
  auto found = rows();
  found[0].selected = false;
  found[2].selected = true;
  EXPECT_THAT(winning_reason(found), HasSubstr("Not the cheapest"));
}

TEST(CandidateRows, SayWhenThereIsNothingToCompare) {
  EXPECT_EQ(winning_reason({}), "No candidate");
  EXPECT_EQ(winning_reason({rows()[0]}), "The only candidate");
}

}  // namespace
}  // namespace abrazo::widgets
