#pragma once

#include <memory>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// The pair of a library that shows the same recorded frame with the same character active as a pair of
/// another does; when it only has the frame with the other one active, that. -1 when it has neither.
int same_pair(const MotionLibrary& from, int pair, const MotionLibrary& to);

/// Whether the library has every pair that a frame and the solver's state before it name: a file may say of
/// its frames what it likes.
bool has_pairs_of(const MotionLibrary& library, const FrameSnapshot& frame);

/// The pair selected in a frame, numbered as in this library, or as it is where it is not known which library
/// it is of. -1 when nothing is selected, or the library does not have it.
int selected_pair(const FrameSnapshot& frame, const std::shared_ptr<const MotionLibrary>& library);

/// A frame whose candidates are numbered as in this library: the same object where they are already, or where
/// it is not known which library they are of (numbers that this one does not have become -1 there).
/// Candidates that the library does not have fall away; nothing is selected when the selected one does.
FrameSnapshotPtr in_library(const FrameSnapshotPtr& frame,
                            const std::shared_ptr<const MotionLibrary>& library);

}  // namespace abrazo
