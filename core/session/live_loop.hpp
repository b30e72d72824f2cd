#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/session/command_queue.hpp"
#include "core/session/frame_history.hpp"
#include "core/session/frame_snapshot.hpp"
#include "core/session/latest_slot.hpp"
#include "core/stream/pose_source.hpp"
#include "core/synthesis/partner_synthesizer.hpp"

namespace abrazo {

/// One turn of the live loop without a thread: commands, newest pose, step, snapshot. Owned by the solver
/// thread; driven by tests with a clock of their own. The queue, history and slot outlive it.
class LiveLoop {
 public:
  LiveLoop(std::unique_ptr<PartnerSynthesizer> synthesizer, std::unique_ptr<PoseSource> source,
           CommandQueue& commands, FrameHistory& history, LatestSlot<FrameSnapshot>& latest);

  /// @param now_s  session clock
  /// @return session time until which there is nothing to do
  double turn(double now_s);

  /// A failed snapshot with this text; the partner holds its last pose.
  void publish_failure(const std::string& why, double now_s);

 private:
  void apply(const Command& command, double now_s);
  std::shared_ptr<const SynthesizerState> state_if_due();
  void publish(std::shared_ptr<FrameSnapshot> snapshot);

  std::unique_ptr<PartnerSynthesizer> synthesizer_;
  std::unique_ptr<PoseSource> source_;
  CommandQueue& commands_;
  FrameHistory& history_;
  LatestSlot<FrameSnapshot>& latest_;
  std::uint64_t next_index_ = 0;
  std::uint64_t state_due_ = 0;  ///< index of the next frame that keeps the synthesizer's state
  double previous_time_s_ = -1;
  double smoothed_interval_s_ = 0;
};

}  // namespace abrazo
