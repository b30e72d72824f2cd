#pragma once

#include <string>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo::widgets {

/// Number of steps kept in the frame, from the selected pair to the result: morph steps, then projections.
int step_count(const FrameSnapshot& frame);

/// The frame after `step` steps, with the residuals of that step; 0 is the selected pair. Omits values
/// measured only at the result (locks, collisions). The frame itself for the last step and beyond, and for a
/// frame without steps.
FrameSnapshotPtr at_step(const FrameSnapshotPtr& frame, int step);

/// "3 / 5 + 2", in the projections "5 + 1 / 5 + 2".
std::string step_text(const FrameSnapshot& frame, int step);

}  // namespace abrazo::widgets
