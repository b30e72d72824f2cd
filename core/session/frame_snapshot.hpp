#pragma once

#include <cstdint>
#include <memory>

#include "core/synthesis/frame_result.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

struct SynthesizerState;

/// One solved frame, frozen: all that was computed and under which settings. Filled by the solver thread,
/// then only read.
struct FrameSnapshot {
  std::uint64_t index = 0;        ///< counts solved frames of the session from 0
  double time_s = 0;              ///< session clock
  std::int64_t input_frame = -1;  ///< frame of the clip that was the input; -1 when the input has none
  Pose user = Pose::Zero();       ///< the input as it came, world [m]
  FrameResult result;
  Settings settings;
  double elapsed_s = -1;  ///< as the step was given it; negative when none was taken
  /// What the synthesizer kept before this step: in the first frame, after every command and each so many
  /// frames; else null. From there on the frames can be solved again.
  std::shared_ptr<const SynthesizerState> before;
  double input_rate_hz = 0;          ///< measured
  std::uint64_t dropped_inputs = 0;  ///< poses that a newer one replaced before they were solved
};

using FrameSnapshotPtr = std::shared_ptr<const FrameSnapshot>;

}  // namespace abrazo
