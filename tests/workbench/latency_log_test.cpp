#include "app/workbench/stream/latency_log.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/long_recording.hpp"

namespace abrazo::app::latency_log_test {
namespace {

using widgets::LatencyStage;

/// Frames at 100 Hz, each solved 1 ms after it came, frame i so many tenths of a millisecond longer.
std::shared_ptr<FrameSnapshot> frame(std::uint64_t index) {
  auto made = std::make_shared<FrameSnapshot>();
  made->index = index;
  made->time_s = 0.01 * static_cast<double>(index);
  const double came = made->time_s, solved = came + 0.001 + 0.0001 * static_cast<double>(index);
  made->times = {came, came, came, solved, -1};
  return made;
}

class LatencyLogTest : public testing::Test {
 protected:
  LatencyLogTest() {
    for (std::uint64_t i = 0; i < 10; ++i) history.append(frame(i));
  }
  FrameHistory history;
  LatencyLog log;
};

TEST_F(LatencyLogTest, FollowsTheHistoryAndKnowsTheIntervals) {
  log.follow(history);
  const auto samples = log.range(history, 0, 1);
  ASSERT_EQ(samples.size(), 10U);
  EXPECT_TRUE(std::isnan(samples[0].interval));
  EXPECT_NEAR(samples[5].interval, 10, 1e-9);
  EXPECT_NEAR(samples[5].end_to_end, 1.5, 1e-9);
  history.append(frame(10));
  log.follow(history);
  EXPECT_EQ(log.range(history, 0, 1).size(), 11U) << "each frame once";
}

TEST_F(LatencyLogTest, KeepsTheFirstPictureOfAFrame) {
  log.follow(history);
  log.drawn(4, 12, 30);
  log.drawn(4, 99, 99);
  log.drawn(77, 1, 1);  // not kept: passed over
  const auto sample = log.of(history, *frame(4));
  EXPECT_EQ(sample.stage(LatencyStage::Render), 12);
  EXPECT_EQ(sample.to_screen, 30);
}

TEST_F(LatencyLogTest, ReadsOlderFramesFromTheHistory) {
  log.append(*frame(8));
  log.append(*frame(9));
  const auto samples = log.range(history, 0.02, 0.05);
  ASSERT_EQ(samples.size(), 4U);
  EXPECT_NEAR(samples[1].interval, 10, 1e-9);
  EXPECT_NEAR(log.of(history, *frame(3)).interval, 10, 1e-9);
  EXPECT_TRUE(std::isnan(log.of(history, *frame(0)).interval));
}

/// It is followed by one frame in ten; the time between those is no interval of the input.
TEST(LatencyOfALongRecording, IsThatOfEveryFrame) {
  FrameHistory history;
  history.set_store(std::make_shared<test::LongRecording>(40'000, frame));
  LatencyLog log;
  for (int turns = 0; turns < 40; ++turns) log.follow(history);
  for (const double to_s : {100.0, 100.5, 300.0}) {
    const auto samples = log.range(history, to_s - 5, to_s);
    ASSERT_NEAR(static_cast<double>(samples.size()), 500, 1) << to_s;
    for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_NEAR(samples[i].interval, 10, 1e-6) << i;
  }
  EXPECT_NEAR(log.of(history, *frame(1000)).interval, 10, 1e-6);
}

TEST(LatencyOfALongRecording, HasThePicturesOfItsFrames) {
  FrameHistory history;
  history.set_store(std::make_shared<test::LongRecording>(40'000, frame));
  LatencyLog log;
  log.follow(history);  // the first frame is among those that are read
  log.drawn(0, 12, 30);
  EXPECT_EQ(log.range(history, 0, 1).front().stage(LatencyStage::Render), 12);
}

TEST_F(LatencyLogTest, IsBounded) {
  for (std::uint64_t i = 0; i < LatencyLog::most_samples + 100; ++i) log.append(*frame(i));
  EXPECT_EQ(log.range(history, 1.01, 1e9).size(), LatencyLog::most_samples - 1);
}

}  // namespace
}  // namespace abrazo::app::latency_log_test
