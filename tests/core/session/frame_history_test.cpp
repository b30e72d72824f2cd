#include "core/session/frames/frame_history.hpp"

#include <gtest/gtest.h>

namespace abrazo::frame_history_test {
namespace {

FrameSnapshotPtr frame_at(std::uint64_t index, double time_s) {
  auto frame = std::make_shared<FrameSnapshot>();
  frame->index = index;
  frame->time_s = time_s;
  return frame;
}

class TenFrames : public testing::Test {
 protected:
  TenFrames() {
    for (std::uint64_t i = 0; i < 10; ++i) history.append(frame_at(i, 0.1 * static_cast<double>(i)));
  }
  FrameHistory history;
};

TEST_F(TenFrames, TheFrameOfAnInstantIsTheLastNotAfterIt) {
  EXPECT_EQ(history.at(0.35)->index, 3U);
  EXPECT_EQ(history.at(0.3 + 1e-12)->index, 3U);
  EXPECT_EQ(history.at(99)->index, 9U);
  EXPECT_EQ(history.at(-1)->index, 0U);
}

TEST_F(TenFrames, SteppingStopsAtTheEnds) {
  EXPECT_EQ(history.stepped(0.35, 2)->index, 5U);
  EXPECT_EQ(history.stepped(0.35, -20)->index, 0U);
  EXPECT_EQ(history.stepped(0.35, 20)->index, 9U);
}

TEST_F(TenFrames, ARangeIncludesBothEnds) {
  const auto range = history.range(0.2 - 1e-9, 0.5 + 1e-9);
  ASSERT_EQ(range.size(), 4U);
  EXPECT_EQ(range.front()->index, 2U);
}

TEST_F(TenFrames, AReaderGetsWhatIsNew) {
  EXPECT_EQ(history.since(7).size(), 3U);
  EXPECT_TRUE(history.since(10).empty());
}

TEST(FrameHistory, AnEmptyHistoryHasNoFrame) {
  const FrameHistory history;
  EXPECT_EQ(history.at(0), nullptr);
  EXPECT_EQ(history.span().frames, 0U);
}

TEST(FrameHistory, TheOldestFramesGoFirstAndAreCounted) {
  const std::size_t one = size_of(*frame_at(0, 0));
  FrameHistory history(5 * one);
  for (std::uint64_t i = 0; i < 12; ++i) history.append(frame_at(i, static_cast<double>(i)));
  const FrameHistory::Span span = history.span();
  EXPECT_EQ(span.frames, 5U);
  EXPECT_EQ(span.evicted, 7U);
  EXPECT_EQ(span.first_s, 7);
  EXPECT_LE(span.bytes, 5 * one);
}

TEST(FrameHistory, MayKeepTheNewestOnly) {
  FrameHistory history;
  for (std::uint64_t i = 0; i < 5; ++i) history.append(frame_at(i, static_cast<double>(i)));
  history.keep_at_most(0);
  history.append(frame_at(5, 5));
  EXPECT_EQ(history.span().frames, 1U);
  EXPECT_EQ(history.at(5)->index, 5U);
}

}  // namespace
}  // namespace abrazo::frame_history_test
