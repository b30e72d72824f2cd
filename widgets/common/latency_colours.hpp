#pragma once

#include "widgets/common/latency_sample.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

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
