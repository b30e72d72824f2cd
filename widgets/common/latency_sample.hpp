#pragma once

#include <array>
#include <limits>
#include <span>
#include <string_view>

#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// Stages from a packet to the partner's packet, in order; Render runs in parallel with Send.
enum class LatencyStage { Assembly, Wait, Solve, Send, Render };
inline constexpr int latency_stage_count = 5;

struct LatencyStageInfo {
  std::string_view name, meaning;
};
const LatencyStageInfo& info_of(LatencyStage stage);

/// Latency of one frame by stage [ms]; NaN = did not happen or was not measured.
struct LatencySample {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double time_s = 0;       ///< of the frame
  double interval = none;  ///< since the arrival of the previous frame
  std::array<double, latency_stage_count> stages{none, none, none, none, none};
  double end_to_end = none;  ///< first packet in to last packet out; to the partner's pose if nothing is sent
  double to_screen = none;   ///< first packet in to the visible picture
  bool is_sent = false;      ///< `end_to_end` includes sending

  double stage(LatencyStage which) const { return stages[static_cast<std::size_t>(which)]; }
};

/// A sample from the frame's times, without render and screen.
/// @param before the previous frame, for the interval; may be null
LatencySample latency_sample(const FrameSnapshot& frame, const FrameSnapshot* before);

/// One colour for each stage, the same in table and plot.
inline QColor latency_colour(LatencyStage stage, const Palette& palette) {
  switch (stage) {
    case LatencyStage::Assembly:
      return palette.user;
    case LatencyStage::Wait:
      return palette.energy_constraint;
    case LatencyStage::Solve:
      return palette.residual_bones;
    case LatencyStage::Send:
      return palette.good;
    case LatencyStage::Render:
      break;
  }
  return palette.residual_penetration;
}

}  // namespace abrazo::widgets
