#pragma once

#include <cstddef>
#include <span>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// How long one stage took over many frames [ms]; nearest rank. All 0 without a frame that had the stage.
struct StageLatency {
  std::size_t frames = 0;
  double p50_ms = 0, p95_ms = 0, p99_ms = 0, max_ms = 0;
};

/// Where the time between a packet and the partner's answer went.
struct LatencyBreakdown {
  StageLatency arrival_interval;  ///< from one packet's arrival to the next one's
  StageLatency assembly;          ///< first packet of a pose to the whole pose
  StageLatency wait;              ///< whole pose to the solver: jitter buffer, the step before
  StageLatency solve;             ///< the step, with its commands
  StageLatency send;              ///< result to the last packet handed to the network
  StageLatency packet_to_packet;  ///< arrival to sent
  StageLatency packet_to_result;  ///< arrival to solved, also where nothing is sent
};

/// Over frames in order. A stage that did not happen in a frame (a clip has no arrival) does not count.
LatencyBreakdown latency_of(std::span<const FrameSnapshotPtr> frames);
LatencyBreakdown latency_of(std::span<const FrameTimes> frames);

}  // namespace abrazo
