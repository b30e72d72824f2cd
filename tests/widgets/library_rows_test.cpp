#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/long_recording.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/library/preview_scale.hpp"
#include "widgets/library/take_coverage.hpp"
#include "widgets/library/take_rows.hpp"

namespace abrazo::widgets::library_rows_test {
namespace {

using test::two_take_library;
using testing::Each;
using testing::ElementsAre;

LibraryTake take_with(std::vector<RoleInterval> roles, std::vector<LabelInterval> labels) {
  LibraryTake take;
  take.name = "t";
  take.fps = 50;
  take.frames = 100;
  take.roles = std::move(roles);
  take.labels = std::move(labels);
  return take;
}

/// The row of a take that no pair needs to show.
TakeRow row_of(const LibraryTake& take) {
  LibraryColumns columns = two_take_library()->columns();
  const LibraryTake before = columns.takes[0];
  columns.takes[0] = take;
  columns.takes[0].body_a = before.body_a;
  columns.takes[0].body_b = before.body_b;
  return take_rows(MotionLibrary(columns))[0];
}

TEST(TakeRows, TellLengthMovesAndRolesAsPartsOfTheTake) {
  const TakeRow row = row_of(take_with({{20, 60, ActivePerformer::B}}, {{10, 30, "turn", "", ""}}));
  EXPECT_EQ(row.frames, 100);
  EXPECT_DOUBLE_EQ(row.seconds, 2);
  ASSERT_EQ(row.moves.size(), 1U);
  EXPECT_DOUBLE_EQ(row.moves[0].from, 0.1);
  EXPECT_DOUBLE_EQ(row.moves[0].to, 0.3);
  ASSERT_EQ(row.roles.size(), 3U) << "also what nobody annotated";
  EXPECT_DOUBLE_EQ(row.roles[1].from, 0.2);
  EXPECT_EQ(row.roles[1].active, ActivePerformer::B);
  EXPECT_EQ(row.roles[2].active, ActivePerformer::Unknown);
  EXPECT_DOUBLE_EQ(row.roles[2].to, 1);
}

TEST(TakeRows, SayWhoLeads) {
  using enum ActivePerformer;
  EXPECT_EQ(row_of(take_with({{0, 100, A}}, {})).leader, "A leads");
  EXPECT_EQ(row_of(take_with({{0, 2000, B}}, {})).leader, "B leads") << "an interval may go on after the end";
  EXPECT_EQ(row_of(take_with({}, {})).leader, "either leads");
  EXPECT_EQ(row_of(take_with({{0, 60, A}}, {})).leader, "A leads 60 %");
  EXPECT_EQ(row_of(take_with({{0, 60, A}, {60, 100, B}}, {})).leader, "A leads 60 %, B 40 %");
}

TEST(TakeRows, AreFoundByNameAndByMove) {
  TakeRow row;
  row.name = "Salsa_06";
  row.labels = {"cross_body_lead", "turn"};
  EXPECT_TRUE(matches(row, ""));
  EXPECT_TRUE(matches(row, "salsa 06"));
  EXPECT_TRUE(matches(row, "CROSS body"));
  EXPECT_TRUE(matches(row, "06 turn"));
  EXPECT_FALSE(matches(row, "06 walk"));
}

TEST(PairsOfTakes, FindThePairOfTheNearestKeptFrame) {
  const auto library = two_take_library();
  const PairsOfTakes pairs(*library);
  for (int pair = 0; pair < library->pair_count(); ++pair) {
    const PairSource& source = library->source(pair);
    if (source.swapped) continue;
    EXPECT_EQ(pairs.pair_at(static_cast<int>(source.take), static_cast<int>(source.frame)), pair);
  }
  EXPECT_EQ(pairs.pair_at(0, -5), pairs.pair_at(0, 0));
  EXPECT_EQ(pairs.pair_at(0, 100'000), pairs.pair_at(0, library->takes()[0].frames - 1));
  EXPECT_EQ(pairs.pair_at(7, 0), -1);
  EXPECT_EQ(PairsOfTakes().pair_at(0, 0), -1);
}

/// A frame whose winner is this pair, with the nearest at some distance.
FrameSnapshot frame_with(std::uint64_t index, int pair, double distance) {
  FrameSnapshot frame;
  frame.index = index;
  Candidate winner, nearest;
  winner.pair = pair, winner.feature_distance = distance + 1;
  nearest.pair = 0, nearest.feature_distance = distance;
  frame.result.candidates = {nearest, winner};
  frame.result.selected = 1;
  return frame;
}

TEST(TakeCoverage, CountsWhatWasSelectedWhereInATake) {
  const auto library = two_take_library();
  TakeCoverage coverage;
  coverage.begin(library);
  const int first = 0, last = library->takes()[0].frames - 1;
  const PairsOfTakes pairs(*library);
  coverage.append(frame_with(0, pairs.pair_at(0, first), 0.1));
  coverage.append(frame_with(1, pairs.pair_at(0, last), 0.1));
  coverage.append(frame_with(2, pairs.pair_at(0, last), 0.1));
  EXPECT_EQ(coverage.times_selected(0), 3);
  EXPECT_EQ(coverage.times_selected(1), 0);
  EXPECT_DOUBLE_EQ(coverage.share_selected(0), 2.0 / (last + 1));
  EXPECT_THAT(coverage.heat(0, 2), ElementsAre(1, 2));
  EXPECT_THAT(coverage.heat(1, 5), Each(0));
  coverage.begin(library);
  EXPECT_EQ(coverage.times_selected(0), 0) << "a new session";
}

TEST(TakeCoverage, IsTheShareOfFramesWithANearPair) {
  TakeCoverage coverage;
  coverage.begin(two_take_library());
  EXPECT_FALSE(coverage.share_within(1)) << "no frame yet";
  for (int i = 0; i < 4; ++i) coverage.append(frame_with(static_cast<std::uint64_t>(i), 0, 0.1 * i));
  EXPECT_DOUBLE_EQ(*coverage.share_within(0.15), 0.5) << "of the nearest candidate, not of the winner";
  EXPECT_EQ(coverage.user_frames(), 4);
  coverage.append(frame_with(4, 0, 1e9));
  EXPECT_DOUBLE_EQ(*coverage.share_within(3.9), 0.8) << "a distance beyond all is counted too";
  EXPECT_DOUBLE_EQ(*coverage.share_within(0.1), 0.2) << "closer, not as close";
}

TEST(TakeCoverage, ReadsEachFrameOfAHistoryOnce) {
  TakeCoverage coverage;
  coverage.begin(two_take_library());
  FrameHistory history;
  for (const int index : {0, 1, 2})
    history.append(std::make_shared<FrameSnapshot>(frame_with(static_cast<std::uint64_t>(index), 0, 0.1)));
  EXPECT_TRUE(coverage.append_new(history));
  EXPECT_FALSE(coverage.append_new(history));
  history.append(std::make_shared<FrameSnapshot>(frame_with(3, 0, 0.1)));
  EXPECT_TRUE(coverage.append_new(history));
  EXPECT_EQ(coverage.user_frames(), 4);
}

/// One in ten of its frames is read.
TEST(TakeCoverage, OfALongRecordingIsOfAllItsFrames) {
  const auto library = two_take_library();
  const PairsOfTakes pairs(*library);
  FrameHistory history;
  history.set_store(std::make_shared<test::LongRecording>(40'192, [&](std::uint64_t index) {
    return std::make_shared<FrameSnapshot>(frame_with(index, pairs.pair_at(index < 10'048 ? 0 : 1, 0), 0.1));
  }));
  TakeCoverage coverage;
  coverage.begin(library);
  EXPECT_FALSE(coverage.is_estimated());
  while (coverage.append_new(history)) {
  }
  EXPECT_EQ(coverage.user_frames(), 40'192);
  EXPECT_EQ(coverage.frames_each(), 10);
  EXPECT_TRUE(coverage.is_estimated());
  EXPECT_NEAR(coverage.times_selected(0), 10'048, 10);
  EXPECT_EQ(coverage.times_selected(0) + coverage.times_selected(1), 40'192);
}

TEST(TakeCoverage, CountsNoFrameForAHoleInTheNumbers) {
  TakeCoverage coverage;
  coverage.begin(two_take_library());
  FrameHistory history;
  for (const std::uint64_t index : {0, 1, 500})
    history.append(std::make_shared<FrameSnapshot>(frame_with(index, 0, 0.1)));
  coverage.append_new(history);
  EXPECT_EQ(coverage.user_frames(), 3) << "between two takes nothing was recorded";
}

PreviewedClip standing_at(double x, double z, int frames, int start = 0) {
  Pose pose = Pose::Zero();
  pose.col(0).setConstant(x);
  pose.col(2).setConstant(z);
  pose(0, 1) = 1.8;
  auto clip = std::make_shared<Clip>();
  clip->poses.assign(static_cast<std::size_t>(frames), pose);
  return {clip, start};
}

TEST(PreviewScale, HoldsBothAndLooksAcrossTheLineBetweenThem) {
  EXPECT_EQ(preview_scale(standing_at(0, 0, 9), standing_at(0, 3, 9)).side_axis, 2);
  EXPECT_EQ(preview_scale(standing_at(0, 0, 9), standing_at(3, 0, 9)).side_axis, 0);
  EXPECT_DOUBLE_EQ(preview_scale(standing_at(0, 0, 9), standing_at(0, 3, 9)).extent_m, 3);
  EXPECT_DOUBLE_EQ(preview_scale(standing_at(0, 0, 9), {}).extent_m, 2) << "room for a standing person";
  EXPECT_DOUBLE_EQ(middle_of(standing_at(0, 0, 9), standing_at(0, 3, 9), 0).z(), 1.5);
}

TEST(PreviewScale, CountsFramesFromTheFirstOneUsed) {
  EXPECT_EQ(common_frames(standing_at(0, 0, 9, 4), standing_at(0, 1, 9)), 5);
  EXPECT_EQ(common_frames(standing_at(0, 0, 9, 4), {}), 5);
  EXPECT_EQ(standing_at(0, 0, 9, 12).frames(), 0);
  EXPECT_EQ(standing_at(0, 0, 9, 12).pose(0), nullptr);
}

}  // namespace
}  // namespace abrazo::widgets::library_rows_test
