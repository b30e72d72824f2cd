#pragma once

#include <string>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo::widgets {

/// Steps on the way from the selected pair to the result that the frame keeps: morph steps, then projections.
int step_count(const FrameSnapshot& frame);

/// The frame as it was after `step` of them, with its own residuals; 0 is the selected pair before the first.
/// What was only measured at the result (locks, collisions) is left out. The frame itself for the last step
/// and beyond, and for a frame without steps.
FrameSnapshotPtr at_step(const FrameSnapshotPtr& frame, int step);

/// "3 / 5 + 2", in the projections "5 + 1 / 5 + 2".
std::string step_text(const FrameSnapshot& frame, int step);

}  // namespace abrazo::widgets
