#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo::app {

/// Frames of a session or trace for drawing; only a few are in memory at a time.
struct FrameSource {
  double first_s = 0, last_s = 0;
  std::shared_ptr<const MotionLibrary> library;  ///< null if unavailable
  std::vector<std::string> warnings;
  /// The frame shown at a time; the first before its time.
  std::function<Result<FrameSnapshotPtr>(double time_s)> at;
};

/// By the file's extension. @param library a session's library, if it moved; may be empty
Result<FrameSource> open_frames(const std::string& file, const std::string& library,
                                const Progress& progress);

}  // namespace abrazo::app
