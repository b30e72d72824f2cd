#include "core/session/file/frame_row.hpp"

#include <gtest/gtest.h>

namespace abrazo::frame_row_test {
namespace {

/// A frame with candidates of both kinds: such as there are when a pair is pinned, and such as there never
/// are.
FrameSnapshot frame_with_candidates() {
  FrameSnapshot frame;
  frame.result.query_world.setRandom();
  frame.result.result.setRandom();
  frame.result.status = StepStatus::Ok;
  frame.result.message.clear();
  for (int c = 0; c < 4; ++c) {
    Candidate candidate;
    candidate.pair = 100 + c;
    candidate.continuation = c % 2 == 1;
    candidate.feature_distance = 0.1 * c;
    candidate.cost = {1.0 / 3 + c, 0.5, 0.25, 2.0 + c};
    if (c >= 2)
      candidate.intent =
          IntentCost{0.1, 0.2 + c, 0.3, 0.4, 0.5, 0.1 + (0.2 + c) + 0.3 + 0.4 + 0.5 + 0.25, 0.25};
    frame.result.candidates.push_back(candidate);
  }
  frame.result.selected = 2;
  return frame;
}

TEST(FrameRow, ACandidateReadsBackWithTheTermsItHas) {
  const FrameSnapshot frame = frame_with_candidates();
  const auto read = frame_of(row_of(frame, 0, 0));
  ASSERT_TRUE(read) << read.error().text();
  const auto& candidates = (*read)->result.candidates;
  ASSERT_EQ(candidates.size(), 4U);
  for (std::size_t c = 0; c < 4; ++c) {
    const Candidate& written = frame.result.candidates[c];
    EXPECT_EQ(candidates[c].pair, written.pair);
    EXPECT_EQ(candidates[c].continuation, written.continuation);
    EXPECT_EQ(candidates[c].feature_distance, written.feature_distance);
    EXPECT_EQ(candidates[c].cost.pose, written.cost.pose);
    EXPECT_EQ(candidates[c].cost.total, written.cost.total);
    ASSERT_EQ(candidates[c].intent.has_value(), written.intent.has_value()) << c;
    if (!written.intent) continue;
    EXPECT_EQ(candidates[c].intent->partner, written.intent->partner);
    EXPECT_EQ(candidates[c].intent->leader, written.intent->leader);
    EXPECT_EQ(candidates[c].intent->move, written.intent->move);
    EXPECT_EQ(candidates[c].intent->meant, written.intent->meant);
    EXPECT_EQ(candidates[c].intent->change, written.intent->change);
    EXPECT_EQ(candidates[c].intent->temporal, written.intent->temporal);
    EXPECT_DOUBLE_EQ(candidates[c].intent->total, written.intent->total);
  }
}

TEST(FrameRow, CandidatesThatEndInTheMiddleOfOneAreRefused) {
  const FrameRow row = row_of(frame_with_candidates(), 0, 0);
  constexpr std::size_t plain = 48, with_terms = plain + 6 * sizeof(double);
  ASSERT_EQ(row.candidates.size(), 2 * plain + 2 * with_terms);
  for (std::size_t size = 0; size < row.candidates.size(); ++size) {
    FrameRow cut = row;
    cut.selected = -1;
    cut.candidates.resize(size);
    const bool is_whole = size == 0 || size == plain || size == 2 * plain || size == 2 * plain + with_terms;
    EXPECT_EQ(frame_of(cut).ok(), is_whole) << size << " bytes";
  }
  FrameRow longer = row;
  longer.candidates.push_back(0);
  EXPECT_FALSE(frame_of(longer));
}

TEST(FrameRow, CandidatesFromBeforeThereWereTermsAreReadAsTheyWere) {
  FrameSnapshot frame = frame_with_candidates();
  for (Candidate& candidate : frame.result.candidates) candidate.intent.reset();
  FrameRow row = row_of(frame, 0, 0);
  ASSERT_EQ(row.candidates.size(), 4U * 48);
  for (int c = 0; c < 4; ++c)
    EXPECT_EQ(row.candidates[static_cast<std::size_t>(48 * c + 4)], c % 2) << "the flag";
  const auto read = frame_of(row);
  ASSERT_TRUE(read);
  for (const Candidate& candidate : (*read)->result.candidates) EXPECT_FALSE(candidate.intent);
}

}  // namespace
}  // namespace abrazo::frame_row_test
