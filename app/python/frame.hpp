#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/python/binding.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/synthesis/frame_result.hpp"

namespace abrazo::python {

/// One solved frame: arrays are views of the result, which therefore outlives the synthesizer.
struct Frame {
  std::shared_ptr<const FrameResult> result;
  std::shared_ptr<const MotionLibrary> library;  ///< whose pairs the candidates are; null when not at hand
};

/// A frame out of a session file.
struct RecordedFrame : Frame {
  explicit RecordedFrame(FrameSnapshotPtr recorded);
  FrameSnapshotPtr snapshot;
};

/// Where a pair of a library was recorded.
struct Source {
  int pair = -1;
  std::string take;
  int frame = 0;
  bool swapped = false;
  std::string label;  ///< empty when it has none
};
Source source_of(const MotionLibrary& library, int pair);

}  // namespace abrazo::python
