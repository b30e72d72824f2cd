#include "core/evaluation/tables/move_table.hpp"

#include <gtest/gtest.h>

#include "core/library/build/motion_library_builder.hpp"
#include "evaluation_takes.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::move_table_test {
namespace {

using namespace test;

/// One take of 100 frames with the labels given, and its library.
struct Labelled {
  PairedTake take;
  std::shared_ptr<const MotionLibrary> library;
};

Labelled labelled(std::vector<LabelInterval> labels, std::vector<RoleInterval> roles = {},
                  bool both_roles = false) {
  Labelled made;
  made.take = swinging_take("take", 100, 1);
  made.take.labels = std::move(labels);
  if (!roles.empty()) made.take.roles = std::move(roles);
  auto library = build_library("labelled", {made.take},
                               {.excluded_takes = {}, .rate_hz = {}, .both_roles = both_roles}, {});
  made.library = std::make_shared<const MotionLibrary>(std::move(*library));
  return made;
}

const std::vector<LabelInterval> turn_then_walk = {
    {.start = 0, .end = 40, .label = "turn", .detail = "", .confidence = ""},
    {.start = 40, .end = 80, .label = "walk", .detail = "could be (alt=turn); low", .confidence = ""},
    {.start = 80, .end = 100, .label = "other", .detail = "", .confidence = ""}};

/// Answers every frame with the pair of frame `source(frame)`.
template <typename Source>
SynthesisedTake with_sources(const Labelled& data, const Source& source) {
  std::vector<int> pairs;
  for (int frame = 0; frame < 100; ++frame)
    pairs.push_back(data.library->find_pair("take", source(frame), false));
  return answered(data.take, pairs);
}

TEST(MoveTable, OwnPairsMakeEveryMoveSuccessful) {
  const Labelled data = labelled(turn_then_walk);
  const std::vector<SynthesisedTake> takes = {with_sources(data, [](int frame) { return frame; })};
  const MoveTable table = count_moves(takes, *data.library, false);
  EXPECT_EQ(table.all.total, 2);
  EXPECT_EQ(table.all.successful, 2);
  EXPECT_EQ(table.step_accuracy, 1);
}

TEST(MoveTable, TheMajorityOfItsStepsDecides) {
  const Labelled data = labelled(turn_then_walk);
  // 21 of the turn's 40 steps from the walk: not a turn. All of the walk from the walk.
  const std::vector<SynthesisedTake> takes = {
      with_sources(data, [](int frame) { return frame < 21 ? 50 : frame; })};
  const MoveTable table = count_moves(takes, *data.library, false);
  EXPECT_EQ(table.per_label.at("turn").successful, 0);
  EXPECT_EQ(table.per_label.at("walk").successful, 1);
  EXPECT_EQ(table.per_take.at("take").total, 2);
  EXPECT_DOUBLE_EQ(table.step_accuracy, (19.0 + 40.0) / 80.0);
  const std::vector<std::string> labels = {"turn", "walk"};
  EXPECT_EQ(table.labels, labels);
  const std::vector<std::vector<int>> moves = {{0, 1}, {0, 1}}, steps = {{19, 21}, {0, 40}};
  EXPECT_EQ(table.confusion, moves);
  EXPECT_EQ(table.steps, steps);
}

TEST(MoveTable, ALabelAnotherAnnotatorMightGiveCountsAsLenientSuccess) {
  const Labelled data = labelled(turn_then_walk);
  const std::vector<SynthesisedTake> takes = {with_sources(data, [](int) { return 0; })};
  const MoveTable table = count_moves(takes, *data.library, false);
  EXPECT_EQ(table.all.successful, 1);
  EXPECT_EQ(table.all.lenient, 2);
}

TEST(MoveTable, StandingAndFootworkAreNoMovesButCanBeWhatAMoveBecame) {
  const Labelled data = labelled(turn_then_walk);
  const std::vector<SynthesisedTake> takes = {with_sources(data, [](int) { return 90; })};
  const MoveTable table = count_moves(takes, *data.library, false);
  EXPECT_EQ(table.all.total, 2);
  EXPECT_EQ(table.all.successful, 0);
  const std::vector<std::string> labels = {"turn", "walk", "other"};
  EXPECT_EQ(table.labels, labels);
  EXPECT_EQ(table.confusion[0][2], 1);
  EXPECT_TRUE(is_move("kick_block"));
  EXPECT_FALSE(is_move("guard"));
  EXPECT_FALSE(is_move(""));
}

TEST(MoveTable, ByChanceIsTheShareOfTheLibrarysMostFrequentMove) {
  std::vector<LabelInterval> labels = turn_then_walk;
  labels[0].end = labels[1].start = 60;  // 60 frames of turn, 20 of walk
  const Labelled data = labelled(labels);
  const std::vector<SynthesisedTake> takes = {with_sources(data, [](int frame) { return frame; })};
  EXPECT_DOUBLE_EQ(count_moves(takes, *data.library, false).by_chance, 0.5);
}

TEST(MoveTable, WhoAttacksBelongsToTheMoveWhereEitherMay) {
  const std::vector<LabelInterval> labels = {
      {.start = 0, .end = 50, .label = "punch_block", .detail = "", .confidence = ""},
      {.start = 50, .end = 100, .label = "punch_block", .detail = "", .confidence = ""}};
  const Labelled data = labelled(labels, {{0, 50, ActivePerformer::A}, {50, 100, ActivePerformer::B}}, true);
  ASSERT_EQ(data.library->pair_count(), 200);
  // Frames 0..49 (A, the user, attacks) answered by frames in which B attacks: wrong role. Then B attacks,
  // answered by the frames in which A attacked, but with the roles swapped: B's part is the user's there, so
  // the partner attacks. Right.
  std::vector<int> pairs;
  for (int frame = 0; frame < 50; ++frame)
    pairs.push_back(data.library->find_pair("take", 50 + frame, false));
  for (int frame = 0; frame < 50; ++frame) pairs.push_back(data.library->find_pair("take", frame, true));
  const std::vector<SynthesisedTake> takes = {answered(data.take, pairs)};
  const MoveTable table = count_moves(takes, *data.library, true);
  EXPECT_EQ(table.per_label.at("punch_block (user)").successful, 0);
  EXPECT_EQ(table.per_label.at("punch_block (partner)").successful, 1);
  // Where roles do not matter both are punches that are blocked.
  EXPECT_EQ(count_moves(takes, *data.library, false).all.successful, 2);
}

TEST(MoveTable, AMoveOfWhichNoStepWasSolvedIsAMiss) {
  const Labelled data = labelled(turn_then_walk);
  SynthesisedTake take = with_sources(data, [](int frame) { return frame; });
  take.frames.resize(40);  // every step of the walk failed
  const std::vector<SynthesisedTake> takes = {take};
  const MoveTable table = count_moves(takes, *data.library, false);
  EXPECT_EQ(table.all.total, 2);
  EXPECT_EQ(table.all.successful, 1);
  EXPECT_EQ(table.all.lenient, 1);
  EXPECT_EQ(table.per_label.at("walk").total, 1);
}

TEST(MoveTable, OfNothingIsEmpty) {
  const Labelled data = labelled(turn_then_walk);
  EXPECT_EQ(count_moves({}, *data.library, false).all.total, 0);
}

}  // namespace
}  // namespace abrazo::move_table_test
