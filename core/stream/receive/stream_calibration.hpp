#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// What comes of a performer standing in the T-pose for a second.
struct StreamCalibration {
  Body body;                        ///< median measures
  double floor_y_m = 0;             ///< height of the floor that the feet stand on, against the floor so far
  std::vector<std::string> doubts;  ///< what does not look like a T-pose, and what to change; empty = fine
};

/// @param poses  world [m], of a person who stands still with straight arms held out sideways; not empty
StreamCalibration calibration_of(std::span<const Pose> poses);

}  // namespace abrazo
