#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/base/progress.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/session_edit.hpp"
#include "core/session/run/saved_history.hpp"

namespace abrazo {

class MotionLibrary;
class Recorder;

/// What to save of an open session, and where.
struct SessionToSave {
  Project project;   ///< present state; its references need path and use, the rest is read from the files
  Project saved;     ///< as last saved: the source for references to files that no longer exist
  std::string file;  ///< file of the session; empty = none yet
  std::string to;    ///< `file`, or another: then everything recorded is copied, with the project
  /// When `file` was saved last as far as this window knows; empty = never. None = unknown
  std::optional<std::string> saved_at;
  TakeEdits takes;                     ///< edits not yet in `file`; for a copy
  std::shared_ptr<Recorder> recorder;  ///< writing into `file`; null = none
  /// Frames that may not be in `file`. They are added, unless a recorder writes into `to`: its file then
  /// lacks those from before the recording until it is saved again. Empty = none
  std::optional<HistoryToSave> history;
  std::shared_ptr<const MotionLibrary> library;
  std::string library_file;  ///< also writes the library here; empty = no
};

struct SavedSession {
  Project project;                    ///< with complete references, as in the file
  std::string saved_at;               ///< of the file
  bool has_history = false;           ///< all frames of `history` are in the file, except those left out
  std::uint64_t frames_left_out = 0;  ///< of the history: they could not be read
};

/// When a session file was saved last, as in it; empty if never, or if it cannot be read.
std::string saved_at(const std::string& file);

/// Writes each file completely or not at all. An Error if another window has saved the session since. If
/// saving fails, a newly written library file is removed.
Result<SavedSession> save_session(const SessionToSave& what, const Progress& progress);

}  // namespace abrazo
