#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// Result of a calibration in the T-pose for one second.
struct StreamCalibration {
  Body body;                        ///< median lengths
  double floor_y_m = 0;             ///< height of the floor under the feet, relative to the present floor
  std::vector<std::string> doubts;  ///< deviations from a T-pose, with what to change; empty = good
};

/// @param poses world [m], of a person standing still with arms stretched sideways; not empty
StreamCalibration calibration_of(std::span<const Pose> poses);

}  // namespace abrazo
