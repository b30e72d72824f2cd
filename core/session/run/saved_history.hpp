#pragma once

#include <cstdint>
#include <string>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/session/file/recording_facts.hpp"
#include "core/session/frames/frame_range.hpp"

namespace abrazo {

/// Frames of a running session that may not be in its file yet.
struct HistoryToSave {
  FrameRange frames;     ///< with the times and indices of the file
  RecordingFacts facts;  ///< for frames that do not name their input or library
};

/// Adds the frames that a session file lacks, before, between or after those it has; creates the file. If
/// this fails or is cancelled, the file has a part of them, and another call adds the rest. Frames that
/// cannot be read are left out.
/// @return the number of frames left out
/// An Error if the file cannot be written, or another process records into it
Result<std::uint64_t> add_history(const std::string& path, HistoryToSave history, const Progress& progress);

}  // namespace abrazo
