#include "core/session/frames/latency.hpp"

#include <utility>
#include <vector>

#include "core/base/statistics.hpp"

namespace abrazo {

namespace {

/// The times of one stage, as they are gathered.
class StageTimes {
 public:
  void add(double from_s, double to_s) {
    constexpr double ms_per_s = 1e3;
    if (from_s >= 0 && to_s >= from_s) times_ms_.push_back(ms_per_s * (to_s - from_s));
  }
  StageLatency latency() const {
    return {times_ms_.size(), percentile(times_ms_, 0.5), percentile(times_ms_, 0.95),
            percentile(times_ms_, 0.99), percentile(times_ms_, 1)};
  }

 private:
  std::vector<double> times_ms_;
};

}  // namespace

LatencyBreakdown latency_of(std::span<const FrameTimes> frames) {
  StageTimes interval, assembly, wait, solve, send, to_packet, to_result;
  double previous_arrival_s = -1;
  for (const FrameTimes& at : frames) {
    interval.add(previous_arrival_s, at.arrived_s);
    previous_arrival_s = at.arrived_s;
    assembly.add(at.arrived_s, at.assembled_s);
    wait.add(at.assembled_s, at.taken_s);
    solve.add(at.taken_s, at.solved_s);
    send.add(at.solved_s, at.sent_s);
    to_packet.add(at.arrived_s, at.sent_s);
    to_result.add(at.arrived_s, at.solved_s);
  }
  return {interval.latency(), assembly.latency(),  wait.latency(),     solve.latency(),
          send.latency(),     to_packet.latency(), to_result.latency()};
}

LatencyBreakdown latency_of(std::span<const FrameSnapshotPtr> frames) {
  std::vector<FrameTimes> times;
  times.reserve(frames.size());
  for (const FrameSnapshotPtr& frame : frames) times.push_back(frame->times);
  return latency_of(times);
}

}  // namespace abrazo
