#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/python/binding.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo::python {

/// One solved frame: arrays are views of the result, which may outlive the synthesizer.
struct Frame {
  std::shared_ptr<const FrameResult> result;
  std::shared_ptr<const MotionLibrary> library;  ///< library of the candidates; null if unknown
};

/// A frame from a session file.
struct RecordedFrame : Frame {
  explicit RecordedFrame(FrameSnapshotPtr recorded);
  FrameSnapshotPtr snapshot;
};

/// The recorded frame of a library pair.
struct Source {
  int pair = -1;
  std::string take;
  int frame = 0;
  bool swapped = false;
  std::string label;  ///< empty = none
};
Source source_of(const MotionLibrary& library, int pair);

}  // namespace abrazo::python
