#pragma once

#include <memory>
#include <string>

#include "app/workbench/document/material.hpp"
#include "app/workbench/document/project_opening.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/frames/frame_store.hpp"
#include "core/session/frames/markers.hpp"

namespace abrazo::app {

/// A session that was opened from its file. Its times and indices are those of the file.
struct RecordedSession {
  std::string file;
  std::shared_ptr<const FrameStore> frames;
  SessionContents contents;

  double last_s() const { return contents.last_s; }
  Markers markers() const;
};

/// A session and the library it was solved with: the one given with it, else where its reference says, else
/// what is open or can be generated, if it is the same. What was recovered of a file that was cut off is
/// among the warnings.
/// A session in which nothing was recorded gives what its project says.
/// @param library  library file or manifest to take in its place; empty = none was given
/// @param places   where data of its project is now
Result<Material> load_session(const std::string& file, const std::string& library, const Material& open,
                              const Progress& progress, const Places& places = {});

}  // namespace abrazo::app
