#pragma once

#include <memory>
#include <string>

#include "core/base/progress.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/session_edit.hpp"

namespace abrazo {

class MotionLibrary;
class Recorder;

/// What to save of an open session, and where.
struct SessionToSave {
  Project project;   ///< present state; its references need path and use, the rest is read from the files
  Project saved;     ///< as last saved: the source for references to files that no longer exist
  std::string file;  ///< file of the session; empty = none yet
  std::string to;    ///< `file`, or another: then everything recorded is copied, with the project
  TakeEdits takes;   ///< edits not yet in `file`; for a copy
  std::shared_ptr<Recorder> recorder;  ///< writing into `file`; null = none
  std::shared_ptr<const MotionLibrary> library;
  std::string library_file;  ///< also writes the library here; empty = no
};

/// Writes each file completely or not at all. If saving fails, a newly written library file is removed.
/// @return the project with complete references, as in the file
Result<Project> save_session(const SessionToSave& what, const Progress& progress);

}  // namespace abrazo
