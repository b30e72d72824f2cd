#pragma once

#include "core/base/positions.hpp"

namespace abrazo {

/// Posture of a pose against the recorded one of another size.
struct PostureChange {
  double pelvis = 1;     ///< height of the root over the recorded one in proportion
  double knee_deg = 0;   ///< angle of the knees, mean of both, minus the recorded: negative = more bent
  double trunk_deg = 0;  ///< angle of root to neck against the vertical, minus the recorded
};

/// @param size  of the body against the recorded one
PostureChange posture_change(const Pose& pose, const Pose& recorded, double size);

}  // namespace abrazo
