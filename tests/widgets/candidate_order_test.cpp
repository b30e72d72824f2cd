#include "widgets/candidates/candidate_order.hpp"

#include <gtest/gtest.h>

#include "tests/widgets/synthetic_frames.hpp"

namespace abrazo::widgets::candidate_order_test {
namespace {

std::vector<CandidateRow> rows() {
  return candidate_rows(*test::synthetic_frame(0, 0), *test::two_take_library());
}

std::vector<int> pairs_of(const std::vector<CandidateRow>& rows) {
  std::vector<int> pairs;
  for (const CandidateRow& row : rows) pairs.push_back(row.pair);
  return pairs;
}

TEST(CandidateOrder, SortsByAnyColumnAndTiesStandByRank) {
  auto found = rows();
  found[0].terms[0] = 9, found[1].terms[1] = 9, found[2].terms[2] = 9, found[3].total = 9;
  found[4].feature_distance = 9;
  const auto last_by = [&](CandidateColumn column) {
    auto sorted = found;
    sort_rows(sorted, {column, false});
    return sorted.back().pair;
  };
  EXPECT_EQ(last_by(CandidateColumn::Pose), found[0].pair);
  EXPECT_EQ(last_by(CandidateColumn::Active), found[1].pair);
  EXPECT_EQ(last_by(CandidateColumn::Passive), found[2].pair);
  EXPECT_EQ(last_by(CandidateColumn::Total), found[3].pair);
  EXPECT_EQ(last_by(CandidateColumn::Distance), found[4].pair);
  EXPECT_EQ(last_by(CandidateColumn::Source), 4) << "the only one of salsa_02";
  EXPECT_EQ(last_by(CandidateColumn::Rank), 4);
  auto by_label = found;
  sort_rows(by_label, {CandidateColumn::Label, true});
  EXPECT_EQ(pairs_of(by_label), (std::vector<int>{0, 1, 2, 3, 4})) << "turns by rank, then the open hold";
}

TEST(CandidateOrder, ASecondClickTurnsAroundAndAnotherColumnStartsAscending) {
  CandidateOrder order = order_after_click({}, CandidateColumn::Pose);
  EXPECT_EQ(order, (CandidateOrder{CandidateColumn::Pose, false}));
  order = order_after_click(order, CandidateColumn::Pose);
  EXPECT_TRUE(order.descending);
  EXPECT_EQ(order_after_click(order, CandidateColumn::Total),
            (CandidateOrder{CandidateColumn::Total, false}));
}

TEST(CandidateOrder, KeepsTheRankOfTheTotalCostInEveryOrder) {
  auto found = rows();
  sort_rows(found, {CandidateColumn::Rank, true});
  EXPECT_EQ(found.front().rank, 5);
  EXPECT_EQ(found.back().rank, 1);
  EXPECT_TRUE(found.back().selected);
}

}  // namespace
}  // namespace abrazo::widgets::candidate_order_test
