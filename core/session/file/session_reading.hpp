#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// All that a session file has, read over one connection, which the frames keep. For whoever opens a session
/// to look at it or to go on; SessionFile is for going through it.
struct SessionReading {
  SessionContents contents;
  std::vector<std::string> recovery;  ///< as SessionFile::recovery
  bool is_being_recorded = false;     ///< by another process or recorder
  ProjectReading project;
  std::shared_ptr<RecordedFrames> frames;  ///< without a library; null only in a value that was not read
};
Result<SessionReading> read_session(const std::string& path);

}  // namespace abrazo
