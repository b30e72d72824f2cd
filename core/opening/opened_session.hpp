#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/library/takes/manifest.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/session_reading.hpp"

namespace abrazo {

/// Where files of a project are now, by index into Project::data; an empty path: open without it.
using Places = std::map<std::size_t, std::string>;

/// The project of a session file, and where its data was found.
struct OpenedProject {
  std::string file;  ///< where it is saved; empty when it never was
  ProjectReading reading;
  std::vector<FoundData> found;  ///< by index into reading.project.data
  std::string autosave;          ///< it was restored from there; empty otherwise
  bool is_relocated = false;     ///< a person located missing files: the file names other places

  const Project& project() const { return reading.project; }
  /// The first of a use that was found; empty when there is none.
  std::string place_of(DataReference::Use use) const;
  std::vector<std::size_t> missing() const;
  /// Where the videos are, in the order of Project::videos: the recorded place if the file is missing, empty
  /// if the project has none.
  std::vector<std::string> video_places() const;
};

/// The key in Project::view under which an autosaved project names the session file that it belongs to.
inline constexpr const char* autosaved_key = "autosaved";

/// A project that was read, with its data looked for: where `places` says, else where it says itself.
/// @param autosaves  folder in which a project names the session file that it belongs to. Anywhere else a
/// file
///                   is what it is: one from a stranger must not choose what is written to. Empty: none
OpenedProject located(const std::string& file, ProjectReading reading, const Places& places = {},
                      const std::string& autosaves = {});

/// A session file as it was read, once: everything but what lies in other files.
struct OpenedSession {
  std::shared_ptr<const OpenedProject> project;
  SessionReading recording;  ///< of the file that an autosaved project belongs to; without frames: nothing
                             ///< was recorded

  bool has_frames() const { return recording.contents.frames > 0; }
  /// What is to be said of a file that was cut off or damaged, each sentence once.
  std::vector<std::string> damage() const;
};
Result<OpenedSession> open_session(const std::string& file, const std::string& autosaves = {});

/// The same with files where a person says they are; what is not named has to be where it was.
OpenedSession with_places(OpenedSession session, const Places& places);

/// What opening without a file of this use means for a person.
std::string without(DataReference::Use use);

// ---- the manifest of a library that was built and is not a file ----

/// Every file that a manifest names, each once, whole paths: data of the project, DataReference::Use::Take.
std::vector<std::string> files_of(const Manifest& manifest);
/// Its JSON with paths from the root, for Project::manifest.
std::string whole_manifest_json(const Manifest& manifest);
/// The manifest that a project keeps, with its files where they are now.
/// @return an Error that names two of the missing ones at most, with their number
Result<Manifest> kept_manifest(const OpenedProject& project);

/// Library, manifest or the files that it is built from.
bool is_of_library(DataReference::Use use);

}  // namespace abrazo
