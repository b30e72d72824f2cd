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

/// Frames to be drawn, of a session or a trace; few of them in memory at a time.
struct FrameSource {
  double first_s = 0, last_s = 0;
  std::shared_ptr<const MotionLibrary> library;  ///< null where it is not at hand
  std::vector<std::string> warnings;
  /// The frame that is shown at a time; the first before it.
  std::function<Result<FrameSnapshotPtr>(double time_s)> at;
};

/// By the file's extension. @param library  a session's library where it is not where it was; may be empty
Result<FrameSource> open_frames(const std::string& file, const std::string& library,
                                const Progress& progress);

}  // namespace abrazo::app
