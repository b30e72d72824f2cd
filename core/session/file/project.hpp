#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/base/result.hpp"
#include "core/session/file/data_reference.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/session/frames/markers.hpp"
#include "core/synthesis/settings/settings.hpp"
#include "core/video/camera_model.hpp"
#include "core/video/video_sync.hpp"

namespace abrazo {

/// A reference video and its synchronisation with its subject.
struct ProjectVideo {
  int data = -1;        ///< index into Project::data
  std::string subject;  ///< name of a take, or "" for the session
  VideoSync sync;
  std::optional<CameraModel> camera;
  std::vector<PickedPoint> picked;  ///< points from which the camera was solved

  bool operator==(const ProjectVideo&) const = default;
};

/// Everything that a person edits, as opposed to what was recorded: one value, kept in the session file.
struct Project {
  std::vector<DataReference> data;
  AnnotationBook annotations;
  std::vector<ProjectVideo> videos;
  Markers markers;                              ///< of the session
  std::map<std::string, Markers> take_markers;  ///< by take name; no empty entries
  Settings settings;
  Decisions decisions;
  std::string
      input;  ///< take of the library or motion file that plays the user; empty = the library's default
  std::string library;   ///< its name; empty if unknown
  std::string manifest;  ///< JSON to build a library that is not a file; its files are in `data` as Take
  std::string presets;   ///< JSON of the user's own presets
  std::map<std::string, std::string>
      view;  ///< layout of panels, camera, lanes, ...: text or base64, by the owner's name

  bool operator==(const Project&) const = default;
};

/// Compares what must not be lost without asking: everything except the view, the intended move and the file
/// references. Videos are compared by their edited state.
bool is_same_work(const Project& a, const Project& b);

/// Writes the project into a session file, all or nothing; recorded data stays. Creates a missing
/// file. An Error if another process records into it. While this process records, use Recorder::save_project.
Status save_project(const std::string& path, const Project& project);

/// A project as read from a file, and what could not be read.
struct ProjectReading {
  Project project;
  bool is_saved = false;            ///< saved by a person; otherwise derived from the recording
  std::string saved_at;             ///< UTC, "2024-05-17T14:03:22Z"; empty if never saved
  std::uint64_t damaged = 0;        ///< unreadable rows, left out
  std::vector<std::string> damage;  ///< one sentence per kind
};
Result<ProjectReading> read_project(const std::string& path);
/// The project of read_project, without the report of damage.
Result<Project> load_project(const std::string& path);

}  // namespace abrazo
