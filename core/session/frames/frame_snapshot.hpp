#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/session/frames/noted_pairs.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

class MotionLibrary;
struct Decisions;
struct SynthesizerState;

/// Times of one frame from a packet to the partner's answer; session clock, -1 = did not happen.
struct FrameTimes {
  double arrived_s = -1;    ///< first packet of the pose, by the kernel's stamp where there is one
  double assembled_s = -1;  ///< the pose was complete
  double taken_s = -1;      ///< the solver took it (after the jitter buffer)
  double solved_s = -1;
  double sent_s = -1;  ///< the last packet of the partner was passed to the network
};

/// One solved frame, frozen: everything computed, and the settings. Filled by the solver thread, then
/// read-only.
struct FrameSnapshot {
  std::uint64_t index = 0;        ///< counts solved frames of the session from 0
  double time_s = 0;              ///< session clock
  std::int64_t input_frame = -1;  ///< frame of the input clip; -1 if the input is not a clip
  Pose user = Pose::Zero();       ///< the input as received, world space [m]
  FrameResult result;
  Settings settings;
  double elapsed_s = -1;  ///< as passed to the step; negative if there was no step
  /// The synthesizer's state before this step: in the first frame, after every command and at regular
  /// intervals; else null. Frames can be solved again from here on.
  std::shared_ptr<const SynthesizerState> before;
  std::shared_ptr<const Decisions> decisions;  ///< in force during the step; null if there are none
  /// The library of the step, to which the candidates refer; null if unknown or not at hand.
  std::shared_ptr<const MotionLibrary> library;
  /// If the library is not at hand: which recorded frames its numbers mean. Else null.
  std::shared_ptr<const NotedPairs> noted_pairs;
  /// The library of the step, if in_library did not find the selected pair in the one that is open. Else
  /// null.
  std::shared_ptr<const AbsentLibrary> absent;
  /// The name of its input in a recording: URI or clip; null if only the recorder knows it.
  std::shared_ptr<const std::string> input;
  FrameTimes times;
  double input_rate_hz = 0;  ///< measured
  /// The requested selection was still learning the library, so Eq. 7 selected. Not recorded.
  bool is_learning = false;
  std::uint64_t dropped_inputs = 0;  ///< poses replaced by a newer one before they were solved
};

using FrameSnapshotPtr = std::shared_ptr<const FrameSnapshot>;

}  // namespace abrazo
