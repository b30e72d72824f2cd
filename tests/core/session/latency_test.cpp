#include "core/session/frames/latency.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace abrazo::latency_test {
namespace {

FrameSnapshotPtr frame_at(const FrameTimes& times) {
  auto frame = std::make_shared<FrameSnapshot>();
  frame->times = times;
  return frame;
}

TEST(Latency, EachStageIsBetweenItsTwoTimes) {
  const std::vector<FrameSnapshotPtr> frames = {frame_at({1.0, 1.001, 1.003, 1.007, 1.0075}),
                                                frame_at({1.010, 1.011, 1.013, 1.017, 1.0175})};
  const LatencyBreakdown latency = latency_of(frames);
  EXPECT_EQ(latency.arrival_interval.frames, 1U);
  EXPECT_NEAR(latency.arrival_interval.p50_ms, 10, 1e-9);
  EXPECT_NEAR(latency.assembly.p95_ms, 1, 1e-9);
  EXPECT_NEAR(latency.wait.p50_ms, 2, 1e-9);
  EXPECT_NEAR(latency.solve.p99_ms, 4, 1e-9);
  EXPECT_NEAR(latency.send.p50_ms, 0.5, 1e-9);
  EXPECT_NEAR(latency.packet_to_packet.p50_ms, 7.5, 1e-9);
  EXPECT_NEAR(latency.packet_to_result.p50_ms, 7, 1e-9);
  EXPECT_EQ(latency.packet_to_packet.frames, 2U);
}

TEST(Latency, PercentilesAreOfTheFrames) {
  std::vector<FrameSnapshotPtr> frames;
  for (int i = 1; i <= 101; ++i) frames.push_back(frame_at({0, 0, 0, 0.001 * i, -1}));
  const StageLatency solve = latency_of(frames).solve;
  EXPECT_NEAR(solve.p50_ms, 51, 1e-9);
  EXPECT_NEAR(solve.p95_ms, 96, 1e-9);
  EXPECT_NEAR(solve.p99_ms, 100, 1e-9);
  EXPECT_NEAR(solve.max_ms, 101, 1e-9);
}

TEST(Latency, WhatDidNotHappenDoesNotCount) {
  const std::vector<FrameSnapshotPtr> frames = {frame_at({}), frame_at({-1, -1, 2.0, 2.002, -1})};
  const LatencyBreakdown latency = latency_of(frames);
  EXPECT_EQ(latency.packet_to_packet.frames, 0U);
  EXPECT_EQ(latency.arrival_interval.frames, 0U);
  EXPECT_EQ(latency.solve.frames, 1U);
  EXPECT_EQ(latency.send.p99_ms, 0);
}

}  // namespace
}  // namespace abrazo::latency_test
