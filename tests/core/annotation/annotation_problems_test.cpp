#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/annotation/annotations.hpp"

namespace abrazo::annotation_problems_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> problems(const std::vector<Tier>& tiers, double fps = 60,
                                  Annotations::Range range = {0, 10}) {
  const auto annotations = annotations_of(tiers);
  if (!annotations) ADD_FAILURE() << annotations.error().text();
  std::vector<std::string> texts;
  for (const AnnotationProblem& problem : problems_of(*annotations, range, fps))
    texts.push_back(problem.text);
  return texts;
}

Tier moves(std::vector<TierInterval> intervals, std::vector<VocabularyEntry> vocabulary = {}) {
  return {"moves", std::move(intervals), std::move(vocabulary), TierKind::Move};
}

TEST(AnnotationProblems, ThereAreNoneInTiersThatTileTheRange) {
  EXPECT_THAT(problems({moves({{0, 4, "basic"}, {4, 10, "turn"}}, {{"basic"}, {"turn"}}),
                        {"role", {{0, 10, "a"}}, {{"a"}, {"b"}}, TierKind::Role}}),
              IsEmpty());
}

TEST(AnnotationProblems, GapsSayTheirTimesAndFrames) {
  EXPECT_THAT(problems({moves({{0, 3.2, "a"}, {4.15, 9, "b"}})}),
              ElementsAre("moves: nothing between 3.20 s and 4.15 s (frames 192-249)",
                          "moves: nothing between 9.00 s and 10.00 s (frames 540-600)"));
}

TEST(AnnotationProblems, NotesMayHaveGapsAndBeEmpty) {
  EXPECT_THAT(problems({{"note", {{2, 3, "x"}}}, {"empty", {}}}), IsEmpty());
}

TEST(AnnotationProblems, AnEmptyTierIsOneProblem) {
  EXPECT_THAT(problems({moves({})}), ElementsAre("moves: nothing is annotated"));
}

TEST(AnnotationProblems, ValuesThatTheVocabularyDoesNotHaveAreNamed) {
  EXPECT_THAT(
      problems({moves({{0, 5, "basic"}, {5, 9, "trun"}, {9, 10, ""}}, {{"basic"}, {"turn"}}),
                {"role", {{0, 10, "leader"}}, {}, TierKind::Role}}),
      ElementsAre("moves: 'trun' (5.000-9.000 s) is not in the vocabulary; add it, or say another value",
                  "moves: '' (9.000-10.000 s) says nothing; give it a value",
                  "role: 'leader' (0.000-10.000 s) is not a role; use a or b, the performers of the take"));
}

TEST(AnnotationProblems, WhatIsShorterThanAFrameOrOffTheFramesIsNamed) {
  EXPECT_THAT(problems({moves({{0, 5, "a"}, {5, 5.01, "b"}, {5.01, 10, "c"}})}),
              ElementsAre("moves: 'b' (5.000-5.010 s) is shorter than a frame (0.0167 s)",
                          "moves: 'b' (5.000-5.010 s) does not begin and end on frames (300.00, 300.60)",
                          "moves: 'c' (5.010-10.000 s) does not begin and end on frames (300.60, 600.00)"));
  EXPECT_THAT(problems({moves({{0, 5.01, "a"}, {5.01, 10, "c"}})}, 0), IsEmpty()) << "without frames";
}

TEST(AnnotationProblems, WholeMillisecondsAreOnTheFramesThatTheyMean) {
  // 1/60 s = 16.667 ms, 2/240 s = 8.333 ms.
  EXPECT_THAT(problems({moves({{0, 0.017, "a"}, {0.017, 10, "b"}})}), IsEmpty());
  EXPECT_THAT(problems({moves({{0, 0.008, "a"}, {0.008, 10, "b"}})}, 240), IsEmpty());
}

TEST(AnnotationProblems, WhatIsBeyondTheRangeIsNamed) {
  EXPECT_THAT(problems({moves({{0, 12, "a"}})}),
              ElementsAre("moves: 'a' (0.000-12.000 s) is not within 0.000-10.000 s"));
}

TEST(AnnotationProblems, PointAtTheAnnotation) {
  const auto annotations = annotations_of(std::vector<Tier>{moves({{0, 3, "a"}, {4, 12, "b"}})});
  const auto found = problems_of(*annotations, {0, 10}, 60);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, AnnotationProblem::Kind::Gap);
  EXPECT_EQ(found[0].annotation, 0);
  EXPECT_EQ(found[0].start_s, 3);
  EXPECT_EQ(found[1].kind, AnnotationProblem::Kind::OutOfRange);
  EXPECT_EQ(annotations->find(found[1].annotation)->value, "b");
}

TEST(Snapping, GoesToTheNearestTargetWithinReach) {
  const SnapTargets targets{10, 2.04, {2.07, 5}};
  EXPECT_EQ(snapped(2.05, targets, 0.05), 2.04);
  EXPECT_EQ(snapped(2.06, targets, 0.05), 2.07);
  EXPECT_EQ(snapped(4.97, targets, 0.05), 5);
}

TEST(Snapping, GoesToFramesOnlyWhereNothingElseIsNear) {
  const SnapTargets targets{10, 2.04, {}};
  EXPECT_EQ(snapped(2.01, targets, 0.05), 2.04);
  EXPECT_EQ(snapped(3.04, targets, 0.05), 3.0);
  EXPECT_EQ(snapped(3.04, targets, 0.01), 3.04) << "out of reach";
  EXPECT_EQ(snapped(3.04, {}, 1), 3.04) << "no targets";
}

}  // namespace
}  // namespace abrazo::annotation_problems_test
