#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/synthesis/frame_result.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

class MotionLibrary;
struct Decisions;
struct SynthesizerState;

/// Where the time between a packet and the partner's answer went; session clock, -1 where it did not happen.
struct FrameTimes {
  double arrived_s = -1;    ///< first packet of the pose, by the kernel's stamp where there is one
  double assembled_s = -1;  ///< the pose was whole
  double taken_s = -1;      ///< the solver took it (behind the jitter buffer)
  double solved_s = -1;
  double sent_s = -1;  ///< the last packet of the partner was handed to the network
};

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
  std::shared_ptr<const Decisions> decisions;  ///< under which it was solved; null where none were made
  /// That it was solved with, whose pairs the candidates are; null where it is no longer known.
  std::shared_ptr<const MotionLibrary> library;
  /// The name of its input in a recording: URI or clip; null where only who records knows it.
  std::shared_ptr<const std::string> input;
  FrameTimes times;
  double input_rate_hz = 0;  ///< measured
  /// The selection that was asked for still learns the library; Eq. 7 selected. Not recorded.
  bool is_learning = false;
  std::uint64_t dropped_inputs = 0;  ///< poses that a newer one replaced before they were solved
};

using FrameSnapshotPtr = std::shared_ptr<const FrameSnapshot>;

}  // namespace abrazo
