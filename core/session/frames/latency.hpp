#pragma once

#include <cstddef>
#include <span>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// Durations of one stage over many frames [ms]; nearest-rank percentiles. All 0 if no frame had the stage.
struct StageLatency {
  std::size_t frames = 0;
  double p50_ms = 0, p95_ms = 0, p99_ms = 0, max_ms = 0;
};

/// Latency from a packet to the partner's answer, by stage.
struct LatencyBreakdown {
  StageLatency arrival_interval;  ///< between the arrivals of successive packets
  StageLatency assembly;          ///< first packet of a pose to complete pose
  StageLatency wait;              ///< complete pose to solver: jitter buffer, previous step
  StageLatency solve;             ///< the step, with its commands
  StageLatency send;              ///< result to the last packet passed to the network
  StageLatency packet_to_packet;  ///< arrival to sent
  StageLatency packet_to_result;  ///< arrival to solved, also where nothing is sent
};

/// @param frames in order. A stage that did not happen in a frame (a clip has no arrival) does not count.
LatencyBreakdown latency_of(std::span<const FrameSnapshotPtr> frames);
LatencyBreakdown latency_of(std::span<const FrameTimes> frames);

}  // namespace abrazo
