#include "app/workbench/stream/latency_log.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace abrazo::app::latency_log_test {
namespace {

using widgets::LatencyStage;

/// Frames at 100 Hz, each solved 1 ms after it came, frame i so many tenths of a millisecond longer.
FrameSnapshotPtr frame(std::uint64_t index) {
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

TEST_F(LatencyLogTest, IsBounded) {
  for (std::uint64_t i = 0; i < LatencyLog::most_samples + 100; ++i) log.append(*frame(i));
  EXPECT_EQ(log.range(history, 1.01, 1e9).size(), LatencyLog::most_samples - 1);
}

}  // namespace
}  // namespace abrazo::app::latency_log_test
