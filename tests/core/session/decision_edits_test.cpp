#include "core/session/frames/decision_edits.hpp"

#include <gtest/gtest.h>

#include "tests/support/libraries.hpp"

namespace abrazo::decision_edits_test {
namespace {

TEST(DecisionEdits, APinTakesThePlaceOfTheOneBeforeAndLiftsThePairsOwnVeto) {
  const auto library = test::two_take_library();
  Decisions decided = with_veto_toggled({}, Reach::Pair, 3, *library);
  EXPECT_FALSE(is_neutral(decided));
  decided = with_pin_toggled(decided, 1);
  EXPECT_EQ(decided.pinned, 1);
  decided = with_pin_toggled(decided, 3);
  EXPECT_EQ(decided.pinned, 3);
  EXPECT_TRUE(decided.vetoes.empty());
  EXPECT_TRUE(is_neutral(with_pin_toggled(decided, 3))) << "the second time lets it go";
}

TEST(DecisionEdits, AVetoCoversThePairItsTakeOrItsLabel) {
  const auto library = test::two_take_library();  // pairs 0..3 salsa_01 turn, 4..7 salsa_02 open hold
  const Decisions pair = with_veto_toggled({}, Reach::Pair, 1, *library);
  EXPECT_TRUE(is_vetoed(pair, 1, *library));
  EXPECT_FALSE(is_vetoed(pair, 2, *library));
  const Decisions take = with_veto_toggled({}, Reach::Take, 5, *library);
  EXPECT_EQ(take.vetoes.takes, std::set<std::string>{"salsa_02"});
  EXPECT_TRUE(is_vetoed(take, 7, *library));
  EXPECT_FALSE(is_vetoed(take, 0, *library));
  const Decisions label = with_veto_toggled({}, Reach::Label, 0, *library);
  EXPECT_EQ(label.vetoes.labels, std::set<std::string>{"turn"});
  EXPECT_TRUE(is_vetoed(label, 3, *library));
  EXPECT_TRUE(is_neutral(with_veto_toggled(label, Reach::Label, 2, *library))) << "the second time lifts it";
}

TEST(DecisionEdits, AVetoThatCoversThePinnedPairLetsItGo) {
  const auto library = test::two_take_library();
  const Decisions pinned = with_pin_toggled({}, 5);
  for (const Reach reach : {Reach::Pair, Reach::Take, Reach::Label})
    EXPECT_FALSE(with_veto_toggled(pinned, reach, 5, *library).pinned);
  EXPECT_EQ(with_veto_toggled(pinned, Reach::Take, 0, *library).pinned, 5);
}

TEST(DecisionEdits, EachDecisionInForceCanBeLiftedByItself) {
  const auto library = test::two_take_library();
  Decisions decided = with_pin_toggled({}, 6);
  decided = with_veto_toggled(decided, Reach::Pair, 2, *library);
  decided = with_veto_toggled(decided, Reach::Label, 0, *library);
  decided = with_veto_toggled(decided, Reach::Take, 0, *library);
  const auto decisions = decisions_in_force(decided, *library);
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
  EXPECT_EQ(decisions[3].without.vetoes.takes, decided.vetoes.takes);
}

TEST(DecisionEdits, WhatIsMeantComesFirstAndPutsOtherMovesOut) {
  const auto library = test::two_take_library();  // pairs 0..3 salsa_01 turn, 4..7 salsa_02 open hold
  Decisions decided = with_pin_toggled({}, 6);
  decided.meant = IntendedMove{"turn", {}, -1, false};
  EXPECT_FALSE(is_not_intended(decided, 1, *library));
  EXPECT_TRUE(is_not_intended(decided, 5, *library));
  const auto decisions = decisions_in_force(decided, *library);
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_EQ(decisions[0].kind, Decision::Kind::Meant);
  EXPECT_EQ(decisions[0].text, "intended: turn");
  EXPECT_FALSE(decisions[0].without.meant);
  EXPECT_EQ(decisions[0].without.pinned, 6);
  decided.meant = IntendedMove{{}, "salsa_02", -1, false};
  EXPECT_TRUE(is_not_intended(decided, 1, *library));
  EXPECT_EQ(meant_words(*decided.meant), "take salsa_02");
  EXPECT_FALSE(is_not_intended({}, 1, *library)) << "nothing is meant";
}

TEST(DecisionEdits, ManyVetoedPairsAreOneDecision) {
  Decisions decided;
  decided.vetoes.pairs = {0, 1, 2, 3};
  const auto decisions = decisions_in_force(decided, *test::two_take_library());
  ASSERT_EQ(decisions.size(), 1U);
  EXPECT_EQ(decisions[0].text, "4 pairs");
  EXPECT_TRUE(is_neutral(decisions[0].without));
}

TEST(DecisionEdits, AVetoOfATakeByNameLetsAPinInItGo) {
  const auto library = test::two_take_library();
  const Decisions pinned = with_pin_toggled({}, 5);
  EXPECT_FALSE(with_take_toggled(pinned, "salsa_02", *library).pinned);
  const Decisions other = with_take_toggled(pinned, "salsa_01", *library);
  EXPECT_EQ(other.pinned, 5);
  EXPECT_EQ(other.vetoes.takes, std::set<std::string>{"salsa_01"});
  EXPECT_TRUE(with_take_toggled(other, "salsa_01", *library).vetoes.empty()) << "the second time lifts it";
}

TEST(DecisionEdits, WhatAnotherLibraryDoesNotHaveFallsAway) {
  const auto from = test::two_take_library();
  const auto to = test::small_library();  // other takes, the same labels
  Decisions decided = with_pin_toggled({}, 5);
  decided.vetoes.pairs = {1};
  decided.vetoes.takes = {"salsa_01", to->takes().front().name};
  decided.vetoes.labels = {"turn", "dip"};
  decided.meant = IntendedMove{"dip", {}, -1, false};
  decided.role_control = RoleControl::Leader;
  const Decisions carried = carried_over(decided, *from, *to);
  EXPECT_FALSE(carried.pinned);
  EXPECT_TRUE(carried.vetoes.pairs.empty());
  EXPECT_EQ(carried.vetoes.takes, std::set<std::string>{to->takes().front().name});
  EXPECT_EQ(carried.vetoes.labels, std::set<std::string>{"turn"});
  EXPECT_FALSE(carried.meant);
  decided.meant = IntendedMove{"turn", {}, -1, false};
  EXPECT_TRUE(carried_over(decided, *from, *to).meant);
  EXPECT_EQ(carried.role_control, RoleControl::Leader);
  for (const int pinned : {0, 5}) {
    EXPECT_FALSE(is_neutral(with_pin_toggled({}, pinned)));
    EXPECT_EQ(carried_over(with_pin_toggled({}, pinned), *from, *from).pinned, pinned);
  }
}

}  // namespace
}  // namespace abrazo::decision_edits_test
