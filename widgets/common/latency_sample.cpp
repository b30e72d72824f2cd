#include "widgets/common/latency_sample.hpp"

namespace abrazo::widgets {
namespace {

double between_ms(double from_s, double to_s) {
  return from_s < 0 || to_s < 0 ? LatencySample::none : 1000 * (to_s - from_s);
}

}  // namespace

const LatencyStageInfo& info_of(LatencyStage stage) {
  static constexpr std::array<LatencyStageInfo, latency_stage_count> infos = {
      {{"Assembly", "from the first packet of a pose to its last"},
       {"Wait",
        "from the whole pose until the solver takes it: the jitter buffer's delay, and the previous step"},
       {"Solve", "retargeting, selection, mesh and the solver's steps"},
       {"Send", "from the partner's pose until its last packet is handed to the network"},
       {"Render", "drawing the scene, if this frame was drawn"}}};
  return infos[static_cast<std::size_t>(stage)];
}

LatencySample latency_sample(const FrameSnapshot& frame, const FrameSnapshot* before) {
  const FrameTimes& times = frame.times;
  LatencySample sample;
  sample.time_s = frame.time_s;
  sample.is_sent = times.sent_s >= 0;
  if (before) sample.interval = between_ms(before->times.arrived_s, times.arrived_s);
  const auto set = [&sample](LatencyStage stage, double ms) {
    sample.stages[static_cast<std::size_t>(stage)] = ms;
  };
  set(LatencyStage::Assembly, between_ms(times.arrived_s, times.assembled_s));
  set(LatencyStage::Wait, between_ms(times.assembled_s, times.taken_s));
  set(LatencyStage::Solve, between_ms(times.taken_s, times.solved_s));
  set(LatencyStage::Send, between_ms(times.solved_s, times.sent_s));
  sample.end_to_end = between_ms(times.arrived_s, sample.is_sent ? times.sent_s : times.solved_s);
  return sample;
}

}  // namespace abrazo::widgets
