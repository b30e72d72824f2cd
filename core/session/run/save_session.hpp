#pragma once

#include <memory>
#include <string>

#include "core/base/progress.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/session_edit.hpp"

namespace abrazo {

class MotionLibrary;
class Recorder;

/// What is saved of an open session, and where.
struct SessionToSave {
  Project project;   ///< as it is now; its references have a path and a use, the rest is read
  Project saved;     ///< as it was saved last: what is known of files that no longer exist
  std::string file;  ///< that the session is kept in; empty = in none yet
  std::string to;    ///< `file`, or another: then a copy of all that was recorded, with the project
  TakeEdits takes;   ///< that `file` does not have yet; for a copy
  std::shared_ptr<Recorder> recorder;  ///< writing into `file`; null = none
  std::shared_ptr<const MotionLibrary> library;
  std::string library_file;  ///< where to write the library as well; empty = nowhere
};

/// Each file whole or not at all; a new file with a library that was written for nothing is removed.
/// @return the project with complete references, as it is in the file
Result<Project> save_session(const SessionToSave& what, const Progress& progress);

}  // namespace abrazo
