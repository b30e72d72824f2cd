#include "core/annotation/label_edits.hpp"

#include <gmock/gmock.h>

#include <random>

#include "tests/core/annotation/label_tiers.hpp"

namespace abrazo::label_edits_test {
namespace {

using test::after;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class LabelEdits : public testing::Test, protected test::LabelTiers {
 protected:
  std::vector<std::string> moves(const Result<LabelEdit>& edit) const { return after(edit, move); }
  std::vector<std::string> roles(const Result<LabelEdit>& edit) const { return after(edit, role); }
};

TEST_F(LabelEdits, AreOfTheSelectedLabelElseOfTheOneAtTheCursor) {
  EXPECT_EQ(chosen_label(annotations, place)->id, second);
  place.selected = third;
  EXPECT_EQ(chosen_label(annotations, place)->id, third);
  place.selected = 0;
  place.cursor_s = 5.5;
  EXPECT_THAT(chosen_label(annotations, place).error().text(), HasSubstr("click one in its lane"));
}

TEST_F(LabelEdits, ANewLabelIsBetweenInAndOutElseASecondLongOrToTheNext) {
  place.cursor_s = 8;
  EXPECT_EQ(*span_at(annotations, place), (Annotations::Range{8, 9}));
  place.cursor_s = 5.5;
  EXPECT_EQ(*span_at(annotations, place), (Annotations::Range{5.5, 6}));
  place.cursor_s = 9.5;
  EXPECT_EQ(*span_at(annotations, place), (Annotations::Range{9.5, 10})) << "the subject ends there";
  place.in_out = {2, 3.5};
  EXPECT_EQ(*span_at(annotations, place), (Annotations::Range{2, 3.5}));
  place.tier = 0;
  EXPECT_THAT(span_at(annotations, place).error().text(), HasSubstr("no tier yet"));
}

TEST_F(LabelEdits, ADrawnLabelIsNamedAndSelected) {
  const auto edit = draw_label(annotations, place, move, {7.5, 8.5}, "cross_body");
  EXPECT_THAT(moves(edit), ElementsAre("1-2 one", "3-5 two", "6-7 one", "7.5-8.5 cross_body"));
  EXPECT_EQ(edit->what, "draw cross body");
  EXPECT_EQ(edit->next.find(*edit->selected)->value, "cross_body");
}

TEST_F(LabelEdits, OnlyANoteMaySayNothingAndARoleIsAOrB) {
  EXPECT_THAT(moves(draw_label(annotations, place, move, {8, 9}, "")),
              ElementsAre("Choose or type its value"));
  EXPECT_THAT(roles(draw_label(annotations, place, role, {8, 9}, "leader")),
              ElementsAre(HasSubstr("A role is a or b")));
  EXPECT_TRUE(draw_label(annotations, place, note, {8, 9}, ""));
  EXPECT_THAT(moves(draw_label(annotations, place, 99, {8, 9}, "one")),
              ElementsAre("The tier no longer exists"));
}

TEST_F(LabelEdits, AnotherValueKeepsDetailAndConfidence) {
  ASSERT_TRUE(annotations.say(second, {.value = "two", .detail = "to the left", .confidence = "high"}));
  const auto edit = say_label(annotations, second, "one");
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->next.find(second)->detail, "to the left");
  EXPECT_EQ(edit->next.find(second)->confidence, "high");
  EXPECT_EQ(edit->what, "label one");
  EXPECT_EQ(say_label(annotations, 99, "one").error().text(), "The label no longer exists");
}

TEST_F(LabelEdits, AKeyAtAStandingCursorSaysItToTheNextLabelAndCutsWhatIsThere) {
  place.cursor_s = 4.04;
  place.conflict = Conflict::Refuse;
  EXPECT_THAT(moves(say_at_cursor(annotations, place, move, "one")),
              ElementsAre("1-2 one", "3-4 two", "4-6 one", "6-7 one"))
      << "from the frame at the cursor";
  place.cursor_s = 8;
  EXPECT_THAT(moves(say_at_cursor(annotations, place, move, "two")),
              ElementsAre("1-2 one", "3-5 two", "6-7 one", "8-10 two"));
}

TEST_F(LabelEdits, AKeyBetweenInAndOutSaysItThereAndMindsConflicts) {
  place.in_out = {4, 6};
  EXPECT_THAT(moves(say_at_cursor(annotations, place, move, "one")),
              ElementsAre("1-2 one", "3-4 two", "4-6 one", "6-7 one"));
  place.conflict = Conflict::Refuse;
  EXPECT_FALSE(say_at_cursor(annotations, place, move, "one"));
}

TEST_F(LabelEdits, AKeyGivesTheSelectedLabelOfItsTierItsValue) {
  place.selected = second;
  EXPECT_THAT(moves(say_at_cursor(annotations, place, move, "one")),
              ElementsAre("1-2 one", "3-5 one", "6-7 one"));
  EXPECT_THAT(roles(say_at_cursor(annotations, place, role, "b")), ElementsAre("4-10 b"))
      << "the selected label is of another tier";
}

TEST_F(LabelEdits, OnlyTheSelectedLabelIsRemoved) {
  EXPECT_FALSE(remove_label(annotations, place)) << "the cursor is in one, but none is selected";
  place.selected = second;
  const auto edit = remove_label(annotations, place);
  EXPECT_THAT(moves(edit), ElementsAre("1-2 one", "6-7 one"));
  EXPECT_EQ(edit->what, "delete two");
}

TEST_F(LabelEdits, TheNearerEdgeOfTheSelectedLabelGoesToTheCursor) {
  place.selected = second;
  place.cursor_s = 3.5;
  EXPECT_THAT(moves(extend_label(annotations, place)), ElementsAre("1-2 one", "3.5-5 two", "6-7 one"));
  place.cursor_s = 5.5;
  EXPECT_THAT(moves(extend_label(annotations, place)), ElementsAre("1-2 one", "3-5.5 two", "6-7 one"));
}

TEST_F(LabelEdits, WithoutASelectionTheLabelBeforeTheCursorIsExtended) {
  place.cursor_s = 5.5;
  EXPECT_THAT(moves(extend_label(annotations, place)), ElementsAre("1-2 one", "3-5.5 two", "6-7 one"));
  place.cursor_s = 0.5;
  EXPECT_FALSE(extend_label(annotations, place));
}

/// A cursor, in and out that a click or a playing clip left between frames.
TEST_F(LabelEdits, NoEdgeIsMadeBetweenFrames) {
  const auto made_by = [this](int kind) -> Result<LabelEdit> {
    switch (kind) {
      case 0: {
        const auto span = span_at(annotations, place);
        return span ? draw_label(annotations, place, move, *span, "one") : Result<LabelEdit>(span.error());
      }
      case 1:
        return label_span(annotations, place, move, {place.cursor_s, place.cursor_s + 0.03}, "two");
      case 2:
        return say_at_cursor(annotations, place, move, "one");
      case 3:
        return extend_label(annotations, place);
      case 4:
        return split_label(annotations, place);
      default:
        return change_role(annotations, place);
    }
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(0, 10);
  int made = 0;
  for (int i = 0; i < 600; ++i) {
    place.cursor_s = anywhere(random);
    place.selected = i % 3 ? 0 : second;
    place.in_out.reset();
    if (i % 5 == 0) place.in_out = {place.cursor_s, place.cursor_s + 0.2 + 0.1 * anywhere(random)};
    const auto edit = made_by(i % 6);
    if (!edit) continue;
    ++made;
    for (const AnnotationProblem& problem : problems_of(edit->next, place.range, place.fps))
      EXPECT_TRUE(problem.kind != AnnotationProblem::Kind::OffFrame &&
                  problem.kind != AnnotationProblem::Kind::TooShort)
          << i << ": " << problem.text;
  }
  EXPECT_GT(made, 400);
}

TEST_F(LabelEdits, SplitAtTheCursorSelectsTheLaterPart) {
  const auto edit = split_label(annotations, place);
  EXPECT_THAT(moves(edit), ElementsAre("1-2 one", "3-4 two", "4-5 two", "6-7 one"));
  EXPECT_EQ(edit->next.find(*edit->selected)->start_s, 4);
}

TEST_F(LabelEdits, MergeFillsTheGapToTheNext) {
  EXPECT_THAT(moves(merge_label(annotations, place)), ElementsAre("1-2 one", "3-7 two"));
  place.selected = third;
  EXPECT_THAT(moves(merge_label(annotations, place)), ElementsAre(HasSubstr("the last of its tier")));
}

TEST_F(LabelEdits, NudgesMoveOneEdgeOrBothAndLeaveSomeLength) {
  EXPECT_THAT(moves(nudge_label(annotations, place, LabelEdge::Both, 0.1)),
              ElementsAre("1-2 one", "3.1-5.1 two", "6-7 one"));
  EXPECT_THAT(moves(nudge_label(annotations, place, LabelEdge::Start, -0.1)),
              ElementsAre("1-2 one", "2.9-5 two", "6-7 one"));
  const auto end = nudge_label(annotations, place, LabelEdge::End, 0.1);
  EXPECT_THAT(moves(end), ElementsAre("1-2 one", "3-5.1 two", "6-7 one"));
  EXPECT_EQ(end->selected, second) << "so that the next nudge is of the same label";
  EXPECT_THAT(moves(nudge_label(annotations, place, LabelEdge::End, -2)),
              ElementsAre(HasSubstr("at least a frame long")));
}

TEST_F(LabelEdits, ACopyIsTheSameIntervalInAnotherTier) {
  const auto edit = copy_label(annotations, place, note);
  EXPECT_THAT(after(edit, note), ElementsAre("3-5 two"));
  EXPECT_FALSE(copy_label(annotations, place, move)) << "it is there already";
}

TEST_F(LabelEdits, TheFirstChangeOfRoleSaysThatALedSoFar) {
  EXPECT_THAT(roles(change_role(annotations, place)), ElementsAre("0-4 a", "4-10 b"));
  place.cursor_s = 0;
  EXPECT_THAT(roles(change_role(annotations, place)), ElementsAre("0-10 a"));
}

TEST_F(LabelEdits, AChangeOfRoleLastsToTheEndOfTheIntervalItIsIn) {
  ASSERT_TRUE(annotations.draw(role, 0, 6, "a", Conflict::Refuse, place.range));
  EXPECT_THAT(roles(change_role(annotations, place)), ElementsAre("0-4 a", "4-6 b"));
  place.cursor_s = 8;
  EXPECT_THAT(roles(change_role(annotations, place)), ElementsAre("0-6 a", "8-10 b"))
      << "who led before does not any more";
}

TEST_F(LabelEdits, ChangesOfRoleNeedATierOfRoles) {
  ASSERT_TRUE(annotations.remove_tier(role));
  EXPECT_THAT(change_role(annotations, place).error().text(), HasSubstr("no tier that says who leads"));
}

TEST_F(LabelEdits, LabelsAreSteppedFromTheSelectedOneElseFromTheCursor) {
  EXPECT_EQ(label_beside(annotations, place, 1)->id, third);
  EXPECT_EQ(label_beside(annotations, place, -1)->id, second) << "the one that began before the cursor";
  place.selected = second;
  EXPECT_EQ(label_beside(annotations, place, -1)->id, first);
  place.selected = third;
  EXPECT_EQ(label_beside(annotations, place, 1).error().text(), "That is the last label of its tier");
  place.selected = first;
  EXPECT_EQ(label_beside(annotations, place, -1).error().text(), "That is the first label of its tier");
  place.tier = note;
  EXPECT_EQ(label_beside(annotations, place, 1).error().text(), "The active tier has no labels");
}

TEST_F(LabelEdits, TiersAreSteppedToTheLastOne) {
  EXPECT_EQ(tier_beside(annotations, move, 1), role);
  EXPECT_EQ(tier_beside(annotations, move, -1), move);
  EXPECT_EQ(tier_beside(annotations, note, 1), note);
  EXPECT_EQ(tier_beside(annotations, 99, 1), 99);
}

TEST_F(LabelEdits, TheNearestEdgeIsOfTheActiveTier) {
  EXPECT_EQ(edge_beside(annotations, place, true), 5);
  EXPECT_EQ(edge_beside(annotations, place, false), 3);
  place.cursor_s = 5;
  EXPECT_EQ(edge_beside(annotations, place, true), 6) << "not the one that the cursor is at";
  place.tier = note;
  EXPECT_EQ(edge_beside(annotations, place, true), std::nullopt);
}

TEST_F(LabelEdits, ANewTierIsActive) {
  const auto edit = new_tier(annotations, "seen");
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->next.tier(*edit->tier)->name, "seen");
  EXPECT_EQ(edit->next.tier(*edit->tier)->kind, TierKind::Note);
  EXPECT_FALSE(new_tier(annotations, "move")) << "there is one of this name";
  EXPECT_EQ(rename_tier(annotations, note, "seen")->next.tier(note)->name, "seen");
  EXPECT_FALSE(delete_tier(annotations, move)->next.tier(move));
}

}  // namespace
}  // namespace abrazo::label_edits_test
