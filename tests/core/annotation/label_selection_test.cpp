#include "core/annotation/label_selection.hpp"

#include <gtest/gtest.h>

namespace abrazo::label_selection_test {
namespace {

class LabelSelectionTest : public testing::Test {
 protected:
  LabelSelectionTest() {
    role = *shown.add_tier("role", TierKind::Role, {});
    moves = *shown.add_tier("moves", TierKind::Move, {});
    turn = *shown.draw(moves, 1, 2, "turn", Conflict::Replace, {0, 10});
    labels.begin(shown);
  }

  Annotations shown;
  int role = 0, moves = 0, turn = 0;
  LabelSelection labels;
};

TEST_F(LabelSelectionTest, BeginsWithTheMovesActiveAndNothingSelected) {
  EXPECT_EQ(labels.tier(), moves);
  EXPECT_EQ(labels.selected(), 0);
  labels.select(shown, turn);
  labels.begin(shown);
  EXPECT_EQ(labels.selected(), 0);
}

TEST_F(LabelSelectionTest, WithoutTiersNothingIsActive) {
  labels.begin({});
  EXPECT_EQ(labels.tier(), 0);
}

TEST_F(LabelSelectionTest, ASelectedLabelMakesItsTierActive) {
  EXPECT_TRUE(labels.choose_tier(shown, role));
  EXPECT_FALSE(labels.choose_tier(shown, role)) << "it is already";
  EXPECT_FALSE(labels.choose_tier(shown, 99));
  EXPECT_TRUE(labels.select(shown, turn));
  EXPECT_EQ(labels.tier(), moves);
  EXPECT_FALSE(labels.select(shown, turn));
  EXPECT_FALSE(labels.select(shown, 99));
  EXPECT_TRUE(labels.choose_tier(shown, role));
  EXPECT_EQ(labels.selected(), 0) << "it is of another tier";
}

TEST_F(LabelSelectionTest, WhatIsChosenIsThereAfterEveryEdit) {
  labels.select(shown, turn);
  ASSERT_TRUE(shown.remove(turn));
  labels.settle(shown);
  EXPECT_EQ(labels.selected(), 0);
  EXPECT_EQ(labels.tier(), moves);
  ASSERT_TRUE(shown.remove_tier(moves));
  labels.settle(shown);
  EXPECT_EQ(labels.tier(), role);
}

}  // namespace
}  // namespace abrazo::label_selection_test
