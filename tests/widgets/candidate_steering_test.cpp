#include "widgets/candidates/steering.hpp"

#include <gtest/gtest.h>

#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/candidates/candidate_order.hpp"

namespace abrazo::widgets::candidate_steering_test {
namespace {

std::vector<CandidateRow> rows() {
  return candidate_rows(*test::synthetic_frame(0, 0), *test::two_take_library());
}

std::vector<int> pairs_of(const std::vector<CandidateRow>& rows) {
  std::vector<int> pairs;
  for (const CandidateRow& row : rows) pairs.push_back(row.pair);
  return pairs;
}

TEST(Steering, APinTakesThePlaceOfTheOneBeforeAndLiftsThePairsOwnVeto) {
  const auto library = test::two_take_library();
  Steering steering = with_veto_toggled({}, Reach::Pair, 3, *library);
  steering = with_pin_toggled(steering, 1);
  EXPECT_EQ(steering.pinned, 1);
  steering = with_pin_toggled(steering, 3);
  EXPECT_EQ(steering.pinned, 3);
  EXPECT_TRUE(steering.vetoes.empty());
  EXPECT_TRUE(with_pin_toggled(steering, 3).empty()) << "the second time lets it go";
}

TEST(Steering, AVetoCoversThePairItsTakeOrItsLabel) {
  const auto library = test::two_take_library();  // pairs 0..3 salsa_01 turn, 4..7 salsa_02 open hold
  const Steering pair = with_veto_toggled({}, Reach::Pair, 1, *library);
  EXPECT_TRUE(is_vetoed(pair, 1, *library));
  EXPECT_FALSE(is_vetoed(pair, 2, *library));
  const Steering take = with_veto_toggled({}, Reach::Take, 5, *library);
  EXPECT_EQ(take.vetoes.takes, std::set<std::string>{"salsa_02"});
  EXPECT_TRUE(is_vetoed(take, 7, *library));
  EXPECT_FALSE(is_vetoed(take, 0, *library));
  const Steering label = with_veto_toggled({}, Reach::Label, 0, *library);
  EXPECT_EQ(label.vetoes.labels, std::set<std::string>{"turn"});
  EXPECT_TRUE(is_vetoed(label, 3, *library));
  EXPECT_TRUE(with_veto_toggled(label, Reach::Label, 2, *library).empty()) << "the second time lifts it";
}

TEST(Steering, AVetoThatCoversThePinnedPairLetsItGo) {
  const auto library = test::two_take_library();
  const Steering pinned = with_pin_toggled({}, 5);
  for (const Reach reach : {Reach::Pair, Reach::Take, Reach::Label})
    EXPECT_FALSE(with_veto_toggled(pinned, reach, 5, *library).pinned);
  EXPECT_EQ(with_veto_toggled(pinned, Reach::Take, 0, *library).pinned, 5);
}

TEST(Steering, EachDecisionInForceCanBeLiftedByItself) {
  const auto library = test::two_take_library();
  Steering steering = with_pin_toggled({}, 6);
  steering = with_veto_toggled(steering, Reach::Pair, 2, *library);
  steering = with_veto_toggled(steering, Reach::Label, 0, *library);
  steering = with_veto_toggled(steering, Reach::Take, 0, *library);
  const auto decisions = decisions_in_force(steering, *library);
  ASSERT_EQ(decisions.size(), 4U);
  EXPECT_EQ(decisions[0].kind, Decision::Kind::Pin);
  EXPECT_EQ(decisions[0].text, "salsa_02 2");
  EXPECT_FALSE(decisions[0].without.pinned);
  EXPECT_EQ(decisions[1].text, "all turn");
  EXPECT_TRUE(decisions[1].without.vetoes.labels.empty());
  EXPECT_EQ(decisions[2].text, "take salsa_01");
  EXPECT_TRUE(decisions[2].without.vetoes.takes.empty());
  EXPECT_EQ(decisions[3].text, "salsa_01 2");
  EXPECT_TRUE(decisions[3].without.vetoes.pairs.empty());
  EXPECT_EQ(decisions[3].without.vetoes.takes, steering.vetoes.takes);
}

TEST(Steering, WhatIsMeantComesFirstAndPutsOtherMovesOut) {
  const auto library = test::two_take_library();  // pairs 0..3 salsa_01 turn, 4..7 salsa_02 open hold
  Steering steering = with_pin_toggled({}, 6);
  steering.meant = MeantMove{"turn", {}, -1, false};
  EXPECT_FALSE(is_not_meant(steering, 1, *library));
  EXPECT_TRUE(is_not_meant(steering, 5, *library));
  const auto decisions = decisions_in_force(steering, *library);
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_EQ(decisions[0].kind, Decision::Kind::Meant);
  EXPECT_EQ(decisions[0].text, "intended: turn");
  EXPECT_FALSE(decisions[0].without.meant);
  EXPECT_EQ(decisions[0].without.pinned, 6);
  steering.meant = MeantMove{{}, "salsa_02", -1, false};
  EXPECT_TRUE(is_not_meant(steering, 1, *library));
  EXPECT_EQ(meant_words(*steering.meant), "take salsa_02");
  EXPECT_FALSE(is_not_meant({}, 1, *library)) << "nothing is meant";
}

TEST(Steering, ManyVetoedPairsAreOneDecision) {
  Steering steering;
  steering.vetoes.pairs = {0, 1, 2, 3};
  const auto decisions = decisions_in_force(steering, *test::two_take_library());
  ASSERT_EQ(decisions.size(), 1U);
  EXPECT_EQ(decisions[0].text, "4 pairs");
  EXPECT_TRUE(decisions[0].without.empty());
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
}  // namespace abrazo::widgets::candidate_steering_test
