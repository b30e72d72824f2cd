#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo {

/// Everything in a session file, read over one connection, which the frames keep. For opening a session to
/// view or continue it; SessionFile is for passes over its rows.
struct SessionReading {
  SessionContents contents;
  std::vector<std::string> recovery;  ///< as SessionFile::recovery
  bool is_being_recorded = false;     ///< by another process or recorder
  ProjectReading project;
  std::shared_ptr<RecordedFrames> frames;  ///< without a library; null only in a default value
};
Result<SessionReading> read_session(const std::string& path);

}  // namespace abrazo
