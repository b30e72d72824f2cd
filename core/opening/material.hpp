#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/files/motion_reading.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo {

struct OpenedProject;

/// A session that was opened from its file. Its times and indices are those of the file.
struct RecordedSession {
  std::string file;
  std::shared_ptr<const FrameStore> frames;
  SessionContents contents;

  double last_s() const { return contents.last_s; }
  Markers markers() const;
};

/// What a live session runs on: a library, and a clip that stands in for the user. After a recorded session
/// the clip goes on, or has a name and a rate but no poses.
struct Material {
  std::shared_ptr<const MotionLibrary> library;
  std::string library_file;  ///< library or manifest; empty when it is no file
  /// That the library was built from, when it is no file; null when it was not, or has changed since.
  std::shared_ptr<const Manifest> manifest;
  bool is_generated = false;  ///< the library can be generated again, by its name
  bool stands_in = false;     ///< the library is in the place of the project's, which was not found
  Clip input;
  /// How the input was read; without a file when it is a take of the library.
  MotionReading reading;
  /// The input's file leaves open how it is to be read (ImportReport::asks, or several performers), and
  /// nobody said.
  bool is_doubtful = false;
  std::vector<std::string> excluded_takes;  ///< the input's own take, where it comes from the library
  std::vector<std::string> warnings;
  std::shared_ptr<const RecordedSession> recorded;  ///< null: nothing was recorded before
  std::shared_ptr<const OpenedProject> project;     ///< null: what is open was not opened from a session file

  /// Nobody plays the user until a stream is connected.
  bool is_only_recorded() const { return recorded && input.poses.empty(); }
  /// Motion, skeleton and joint map that the input was read from; none when it is a take of the library.
  std::vector<std::string> input_files() const;
  /// The library is neither a file nor generated: closing the session loses it, but for its manifest.
  bool has_unsaved_library() const;
};

/// The active performer of a take as the library has it, world.
Clip clip_of_take(const MotionLibrary& library, int take);

/// What is open with a take of its library as the user, who is then not answered from that take.
Material danced_with(const Material& open, int take);

/// A library that was just built: its last take plays the user.
/// @param file  library or manifest that was written; empty: none was
Material built_material(std::shared_ptr<const MotionLibrary> library, Manifest manifest, std::string file,
                        std::vector<std::string> warnings);

/// What a session file says of the material, so that it opens again: `data`, `library`, `manifest`, `input`.
/// References have a path and a use only; those of a library that another stands in for are as they were.
void describe(const Material& material, Project& project);

/// A project whose library is now in a file.
Project with_library_file(Project project, const std::string& file);

/// A file name of its own for a library, in the folder of its session: "NAME.h5", "NAME (2).h5", ...
std::string library_file_beside(const std::string& session_file, const std::string& library_name);

/// Of the takes in a library that is not there, what was said of them stays in the project.
/// @return names of annotated takes that the library does not have, with the number of annotations
std::vector<std::pair<std::string, std::size_t>> annotated_elsewhere(const AnnotationBook& book,
                                                                     const MotionLibrary& library);

}  // namespace abrazo
