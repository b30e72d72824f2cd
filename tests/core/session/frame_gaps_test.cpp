#include "core/session/frames/frame_gaps.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace abrazo::frame_gaps_test {
namespace {

FrameSnapshot frame(std::uint64_t index, double time_s, double rate_hz = 100) {
  FrameSnapshot frame;
  frame.index = index;
  frame.time_s = time_s;
  frame.input_rate_hz = rate_hz;
  return frame;
}

/// Which of the frames come after a gap.
std::vector<std::size_t> after_gaps(const std::vector<FrameSnapshot>& frames, std::uint64_t frames_each = 1) {
  FrameGaps gaps;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (gaps.next(frames[i], frames_each).is_gap()) found.push_back(i);
  return found;
}

TEST(FrameGaps, AreWhereNothingWasSolvedForAWhile) {
  EXPECT_EQ(after_gaps({frame(0, 7), frame(1, 7.01), frame(2, 7.2), frame(3, 9.2), frame(4, 9.21)}),
            std::vector<std::size_t>{3})
      << "neither before the first frame nor where some packets were lost";
}

TEST(FrameGaps, AreNotWhereFramesWereNotRead) {
  EXPECT_EQ(after_gaps({frame(0, 0), frame(90, 0.9), frame(180, 1.8), frame(270, 8.7), frame(360, 9.6)}, 90),
            std::vector<std::size_t>{3})
      << "six seconds more than 90 frames take";
}

/// The numbers of the frames between two takes are missing in a recording of the takes alone.
TEST(FrameGaps, AreWhereFramesWereNotRecorded) {
  const std::vector<FrameSnapshot> two_takes = {frame(0, 0), frame(1, 0.01), frame(700, 7), frame(701, 7.01)};
  EXPECT_EQ(after_gaps(two_takes), std::vector<std::size_t>{2});
  EXPECT_EQ(after_gaps(two_takes, 5), std::vector<std::size_t>{2});
}

TEST(FrameGaps, AreFoundByTheRateBeforeWhereThatOfAnInputIsNotMeasuredYet) {
  EXPECT_EQ(after_gaps({frame(0, 0), frame(50, 0.5), frame(100, 9, 0), frame(150, 9.5)}, 50),
            std::vector<std::size_t>{2});
}

TEST(FrameGaps, SayHowLongTheFramesTookThatWereNotRead) {
  FrameGaps gaps;
  EXPECT_TRUE(gaps.next(frame(0, 3), 10).since_s == 0);
  const FrameInterval next = gaps.next(frame(1, 3.01), 10);
  EXPECT_TRUE(next.is_adjacent);
  EXPECT_EQ(next.left_out_s, 0);
  const FrameInterval far = gaps.next(frame(11, 3.11), 10);
  EXPECT_FALSE(far.is_adjacent);
  EXPECT_NEAR(far.left_out_s, 0.1, 1e-9);
}

}  // namespace
}  // namespace abrazo::frame_gaps_test
