#include "core/annotation/annotation_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/library/build/motion_library_builder.hpp"
#include "tests/core/annotation/label_tiers.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::annotation_state_test {
namespace {

using test::label_texts;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Direction = AnnotationState::Direction;

MotionLibrary library_of(const std::string& name, const std::vector<std::string>& takes) {
  std::vector<PairedTake> recorded;
  for (const std::string& take : takes) {
    recorded.push_back(test::swinging_take(take, 30, 1));
    recorded.back().roles = {{0, 30, ActivePerformer::A}};
    recorded.back().labels = {{0, 12, "basic", "", ""}, {12, 30, "turn", "", ""}};
  }
  return *build_library(name, std::move(recorded), {}, {});
}

const MotionLibrary& library() {
  static const MotionLibrary two_takes = library_of("salsa", {"one", "two"});
  return two_takes;
}

const AnnotationTier& tier(const Annotations& annotations, TierKind kind = TierKind::Move) {
  return *annotations.first_of(kind);
}

class AnnotationStateTest : public testing::Test {
 protected:
  AnnotationStateTest() { state.start(library()); }

  /// Draws a move in a subject, as a step that is done. @return the step
  AnnotationStep draw(const std::string& subject, double from_s, double to_s, const char* value) {
    Annotations next = state.annotations_of(subject);
    EXPECT_TRUE(next.draw(tier(next).id, from_s, to_s, value, Conflict::Replace, {0, 10}));
    const auto step = state.step(subject, next, "draw");
    EXPECT_TRUE(step);
    EXPECT_TRUE(state.apply(*step, Direction::Do));
    return *step;
  }
  std::vector<std::string> moves(const std::string& subject) const {
    const Annotations& annotations = state.annotations_of(subject);
    return annotations.empty() ? std::vector<std::string>() : label_texts(annotations, tier(annotations).id);
  }

  AnnotationState state;
};

TEST(BegunAnnotations, OfATakeAreTheLibrarysWithKeysAndATierForNotes) {
  const Annotations begun = begun_annotations(library(), "one");
  EXPECT_THAT(label_texts(begun, tier(begun).id), ElementsAre("0-0.2 basic", "0.2-0.5 turn"));
  EXPECT_EQ(tier(begun).entry("basic")->key, '1');
  EXPECT_EQ(tier(begun).entry("turn")->key, '2');
  EXPECT_EQ(tier(begun, TierKind::Role).entry("a")->key, 'a');
  ASSERT_TRUE(begun.tier_named("note"));
  EXPECT_EQ(begun.tier_named("note")->kind, TierKind::Note);
}

TEST(BegunAnnotations, OfTheSessionHaveTheTakesWordsAndSayNothing) {
  const Annotations begun = begun_annotations(library(), "");
  EXPECT_THAT(tier(begun).annotations, IsEmpty());
  EXPECT_TRUE(tier(begun).entry("turn"));
  EXPECT_EQ(tier(begun, TierKind::Role).entry("a")->description, "user leads");
}

TEST_F(AnnotationStateTest, BeginsWithTheSessionAndItsMovesActive) {
  EXPECT_EQ(state.subject(), "");
  EXPECT_FALSE(state.shows_take());
  EXPECT_EQ(state.tier(), tier(state.annotations()).id);
  EXPECT_THAT(state.changed(), IsEmpty());
}

TEST_F(AnnotationStateTest, AShownTakeIsNotAChangeUntilSomethingElseIsSaid) {
  state.show("one", library());
  EXPECT_EQ(state.subject(), "one");
  EXPECT_THAT(state.changed(), IsEmpty());
  draw("one", 0, 0.1, "turn");
  ASSERT_EQ(state.changed().size(), 1u);
  EXPECT_EQ(state.changed().begin()->first, "one");
}

TEST_F(AnnotationStateTest, AStepIsTakenBackAndDoneAgain) {
  const AnnotationStep step = draw("", 1, 2, "turn");
  EXPECT_THAT(moves(""), ElementsAre("1-2 turn"));
  EXPECT_TRUE(state.apply(step, Direction::Undo));
  EXPECT_THAT(moves(""), IsEmpty());
  EXPECT_TRUE(state.apply(step, Direction::Do));
  EXPECT_THAT(moves(""), ElementsAre("1-2 turn"));
  EXPECT_FALSE(state.step("", state.annotations(), "nothing")) << "what is so already is no step";
}

TEST_F(AnnotationStateTest, AStepReachesIntoASubjectThatIsNotShown) {
  state.show("one", library());
  const AnnotationStep step = draw("one", 0, 0.1, "turn");
  state.show("", library());
  EXPECT_TRUE(state.apply(step, Direction::Undo));
  EXPECT_THAT(moves("one"), ElementsAre("0-0.2 basic", "0.2-0.5 turn"));
  EXPECT_EQ(state.subject(), "");
}

TEST_F(AnnotationStateTest, StepsOfAnotherSessionOrProjectAreOfNoUse) {
  const AnnotationStep step = draw("", 1, 2, "turn");
  state.start(library());
  EXPECT_FALSE(state.apply(step, Direction::Do));
  EXPECT_THAT(moves(""), IsEmpty());
  const AnnotationStep other = draw("", 1, 2, "turn");
  state.set_book({}, &library());
  EXPECT_FALSE(state.apply(other, Direction::Undo));
}

TEST_F(AnnotationStateTest, TheNextSessionKeepsWhatWasSaidOfItsTakes) {
  draw("", 1, 2, "turn");
  for (const char* take : {"one", "two"}) {
    state.show(take, library());
    draw(take, 0, 0.1, "turn");
  }
  state.start(library_of("salsa", {"two", "three"}));
  EXPECT_EQ(state.subject(), "");
  EXPECT_THAT(moves(""), IsEmpty()) << "its times were another session's";
  EXPECT_THAT(moves("two"), ElementsAre("0-0.1 turn", "0.1-0.2 basic", "0.2-0.5 turn"));
  EXPECT_THAT(moves("one"), IsEmpty()) << "the library does not have it any more";
  state.start(library_of("fights", {"two"}));
  EXPECT_THAT(moves("two"), IsEmpty()) << "another library's take of the same name";
}

TEST_F(AnnotationStateTest, ABookTakesThePlaceOfAllAndIsAChange) {
  draw("", 1, 2, "turn");
  Annotations kept = begun_annotations(library(), "two");
  state.set_book({{"two", kept}}, &library());
  EXPECT_THAT(moves(""), IsEmpty());
  EXPECT_THAT(state.changed(), ElementsAre(std::pair<const std::string, Annotations>("two", kept)))
      << "so that it is saved again";
}

TEST_F(AnnotationStateTest, ABookCanBeSetBeforeThereIsASession) {
  AnnotationState empty;
  empty.set_book({{"two", begun_annotations(library(), "two")}}, nullptr);
  EXPECT_TRUE(empty.annotations().empty());
  EXPECT_EQ(empty.tier(), 0);
  EXPECT_EQ(empty.changed().size(), 1u);
}

TEST_F(AnnotationStateTest, ASelectedLabelMakesItsTierActive) {
  draw("", 1, 2, "turn");
  const int role = tier(state.annotations(), TierKind::Role).id,
            label = tier(state.annotations()).annotations[0].id;
  EXPECT_TRUE(state.choose_tier(role));
  EXPECT_FALSE(state.choose_tier(role)) << "it is already";
  EXPECT_FALSE(state.choose_tier(99));
  EXPECT_TRUE(state.select(label));
  EXPECT_EQ(state.tier(), tier(state.annotations()).id);
  EXPECT_FALSE(state.select(label));
  EXPECT_FALSE(state.select(99));
  EXPECT_TRUE(state.choose_tier(role));
  EXPECT_EQ(state.selected(), 0) << "it is of another tier";
}

TEST_F(AnnotationStateTest, WhatIsChosenIsThereAfterEveryStep) {
  const AnnotationStep step = draw("", 1, 2, "turn");
  state.select(tier(state.annotations()).annotations[0].id);
  state.apply(step, Direction::Undo);
  EXPECT_EQ(state.selected(), 0);
  Annotations without_moves = state.annotations();
  ASSERT_TRUE(without_moves.remove_tier(state.tier()));
  state.apply(*state.step("", without_moves, "delete tier"), Direction::Do);
  EXPECT_TRUE(state.annotations().tier(state.tier()));
}

}  // namespace
}  // namespace abrazo::annotation_state_test
