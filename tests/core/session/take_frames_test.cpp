#include "core/session/frames/take_frames.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/annotation/annotated_library.hpp"
#include "core/mesh/laplacian.hpp"
#include "core/session/frames/frame_history.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::take_frames_test {
namespace {

using Library = std::shared_ptr<const MotionLibrary>;

std::shared_ptr<const TakeFrames> frames_of(const Library& library, int take = 0) {
  auto frames = TakeFrames::create(library, library->takes()[static_cast<std::size_t>(take)].name);
  EXPECT_TRUE(frames) << frames.error().text();
  return *frames;
}

/// Performer B leads in frames [from, to) of the first take.
Library with_b_leading(const Library& library, int from, int to) {
  const LibraryTake& take = library->takes().front();
  TakeAnnotation said{{}, take.labels};
  said.roles = {
      {0, from, ActivePerformer::A}, {from, to, ActivePerformer::B}, {to, take.frames, ActivePerformer::A}};
  auto next = with_annotations(*library, {{take.name, said}});
  EXPECT_TRUE(next) << next.error().text();
  return std::make_shared<const MotionLibrary>(std::move(*next));
}

TEST(TakeFrames, HasTheRecordedBodiesWhereTheyWereRecorded) {
  const Library library = test::small_library();
  const auto frames = frames_of(library);
  const std::string& name = library->takes().front().name;
  const int pair = library->find_pair(name, 7, false);
  const FrameSnapshotPtr frame = frames->at(7 / frames->fps());
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->input_frame, 7);
  const Pose a = to_world(library->pose(pair).topRows<joint_count>(), library->root(pair));
  const Pose b = to_world(library->pose(pair).bottomRows<joint_count>(), library->root(pair));
  EXPECT_EQ(frame->result.active(), a);
  EXPECT_EQ(frame->result.passive(), b);
  EXPECT_EQ(frame->user, a);
  EXPECT_EQ(frame->result.status, StepStatus::Ok);
  EXPECT_EQ(frame->result.message, "");
  ASSERT_EQ(frame->result.candidates.size(), 1u);
  EXPECT_EQ(frame->result.candidates.front().pair, pair);
  EXPECT_EQ(frame->result.edges.size(), library->edges(pair).size());
  EXPECT_EQ(frame->result.edges.size(), frame->result.edge_residuals_m.size());
}

TEST(TakeFrames, ShowsTheLastFrameNotAfterATimeAlsoAtTheExactTimesOfFrames) {
  const auto frames = frames_of(test::small_library());
  for (int f = 0; f < 30; ++f) EXPECT_EQ(frames->at(f / frames->fps())->input_frame, f) << f;
  EXPECT_EQ(frames->at(7.9 / frames->fps())->input_frame, 7);
  EXPECT_FALSE(frames->at(-0.1));
  EXPECT_EQ(frames->at(1000)->index, frames->span().last_index);
}

TEST(TakeFrames, GivesTheSameObjectAgainSoThatNobodyDrawsItTwice) {
  const auto frames = frames_of(test::small_library());
  EXPECT_EQ(frames->at(0.1), frames->at(0.1));
  EXPECT_EQ(frames->frame(6), frames->at(6 / frames->fps()));
}

TEST(TakeFrames, BodiesStayWithTheirPerformersWhereTheOtherOneLeads) {
  const Library before = test::small_library(), after = with_b_leading(before, 5, 15);
  const auto plain = frames_of(before), exchanged = frames_of(after);
  ASSERT_EQ(plain->span().frames, exchanged->span().frames);
  std::set<bool> user_roles;
  for (std::uint64_t i = 0; i < plain->span().frames; ++i) {
    const FrameSnapshotPtr was = plain->frame(i), is = exchanged->frame(i);
    // Poses that change places are normalised anew.
    EXPECT_LT((was->result.result - is->result.result).cwiseAbs().maxCoeff(), 1e-9) << i;
    EXPECT_EQ(std::set(was->result.edges.begin(), was->result.edges.end()),
              std::set(is->result.edges.begin(), is->result.edges.end()))
        << i;
    user_roles.insert(is->settings.user_role == UserRole::Active);
  }
  EXPECT_EQ(user_roles.size(), 2u) << "who leads is told by the role";
}

TEST(TakeFrames, RangesAreWholeOrEvenlyThinned) {
  const auto frames = frames_of(test::small_library());
  const double fps = frames->fps();
  const auto whole = frames->range(3 / fps, 9 / fps, FrameHistory::all_frames);
  ASSERT_EQ(whole.size(), 7u);
  EXPECT_EQ(whole.front()->input_frame, 3);
  EXPECT_EQ(whole.back()->input_frame, 9);
  EXPECT_EQ(frames->between(0, 19, 10).size(), 10u);
  const std::uint64_t last = frames->span().last_index;
  const auto rest = frames->between(last - 2, last + 5, FrameHistory::all_frames);
  ASSERT_EQ(rest.size(), 3u) << "no farther than there are frames";
  EXPECT_EQ(rest.back()->index, last);
  EXPECT_TRUE(frames->range(-5, -1, 10).empty());
  EXPECT_TRUE(frames->between(1'000'000, 2'000'000, 10).empty());
}

TEST(TakeFrames, AHistoryLooksAtThemLikeAtAnyOther) {
  const auto frames = frames_of(test::small_library());
  FrameHistory history;
  history.set_store(frames);
  EXPECT_EQ(history.span().stored, frames->span().frames);
  EXPECT_EQ(history.at(0.1), frames->at(0.1));
  EXPECT_EQ(history.stepped(0.1, 1)->index, frames->at(0.1)->index + 1);
  EXPECT_FALSE(frames->state_before(10));
}

TEST(TakeFrames, SaysThatThereIsNoSuchTake) {
  const auto none = TakeFrames::create(test::small_library(), "nobody");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("has no take 'nobody'"), std::string::npos);
}

TEST(TakeFrames, WeighsEdgesAsTheSolverDoes) {
  const auto frame = frames_of(test::small_library())->at(0.1);
  Laplacian laplacian;
  laplacian.build(frame->result.edges, frame->result.selected_pair, EdgeWeights::Inverse);
  const auto weights = inverse_edge_weights(frame->result.edges, frame->result.selected_pair);
  ASSERT_EQ(weights.size(), frame->result.edges.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const MeshEdge edge = frame->result.edges[i];
    EXPECT_NEAR(weights[i], 0.5 * (laplacian.weight(edge[0], edge[1]) + laplacian.weight(edge[1], edge[0])),
                1e-12);
  }
}

TEST(FrameInLibrary, NumbersCandidatesAsTheOtherLibraryDoes) {
  const Library before = test::small_library(), after = with_b_leading(before, 5, 15);
  const std::string& second = before->takes().back().name;
  const int pair = before->find_pair(second, 3, false);
  ASSERT_NE(after->find_pair(second, 3, false), -1);
  auto frame = std::make_shared<FrameSnapshot>();
  frame->library = before;
  frame->result.candidates = {{pair, 0.5, false, {}}};
  frame->result.selected = 0;
  const FrameSnapshotPtr now = in_library(frame, after);
  ASSERT_EQ(now->result.candidates.size(), 1u);
  EXPECT_EQ(now->result.candidates[0].pair, after->find_pair(second, 3, false));
  EXPECT_EQ(now->result.candidates[0].feature_distance, 0.5);
  EXPECT_EQ(now->result.selected, 0);
  EXPECT_EQ(now->library, after) << "whose numbers these are";
  EXPECT_EQ(in_library(frame, before), frame) << "nothing to do";
  EXPECT_EQ(selected_pair(*frame, after), after->find_pair(second, 3, false));
  EXPECT_EQ(selected_pair(*frame, before), pair);
}

TEST(FrameInLibrary, NumbersManyPairsAsItDoesOne) {
  const Library before = test::small_library(), after = with_b_leading(before, 5, 15);
  PairNumbers numbers(*before, *after);
  for (int pair = -1; pair <= before->pair_count(); ++pair)
    EXPECT_EQ(numbers(pair), same_pair(*before, pair, *after)) << pair;
  ASSERT_EQ(numbers.takes().size(), before->takes().size());
  EXPECT_EQ(numbers.takes().back(), static_cast<int>(before->takes().size()) - 1);
}

TEST(FrameInLibrary, WhereTheRolesChangedItIsTheFrameWithTheOtherOneActive) {
  const Library before = test::small_library(), after = with_b_leading(before, 5, 15);
  const std::string& first = before->takes().front().name;
  const int pair = before->find_pair(first, 7, false);
  EXPECT_EQ(same_pair(*before, pair, *after), after->find_pair(first, 7, true));
  EXPECT_EQ(same_pair(*before, -1, *after), -1);
}

}  // namespace
}  // namespace abrazo::take_frames_test
