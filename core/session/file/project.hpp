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
#include "core/synthesis/settings.hpp"
#include "core/video/camera_model.hpp"
#include "core/video/video_sync.hpp"

namespace abrazo {

/// A reference video with how it goes with its subject.
struct ProjectVideo {
  int data = -1;        ///< index into Project::data
  std::string subject;  ///< name of a take, or "" for the session
  VideoSync sync;
  std::optional<CameraModel> camera;
  std::vector<PickedPoint> picked;  ///< that the camera was solved from

  bool operator==(const ProjectVideo&) const = default;
};

/// What a person works on, beside what was recorded: one value that is kept in the session file.
struct Project {
  std::vector<DataReference> data;
  AnnotationBook annotations;
  std::vector<ProjectVideo> videos;
  Markers markers;                              ///< of the session
  std::map<std::string, Markers> take_markers;  ///< by the take's name; none is empty
  Settings settings;
  Decisions decisions;
  std::string
      input;  ///< take of the library, or motion file, that plays the user; empty = as the library says
  std::string library;  ///< its name; empty where that was not noted
  std::string
      manifest;  ///< JSON that builds the library, which is no file; its files are among `data` as Take
  std::string presets;  ///< JSON of a person's own presets
  std::map<std::string, std::string>
      view;  ///< layout of panels, camera, lanes, ...: text or base64, by owner's name

  bool operator==(const Project&) const = default;
};

/// Whether a person has to be asked before it is lost: all but where panels and camera stand, what is meant
/// at the moment, and which files it is made of; videos are compared by what was decided about them.
bool is_same_work(const Project& a, const Project& b);

/// Puts the project into a session file, whole or not at all; what was recorded in it stays. The file is made
/// when there is none, and one of an older version is migrated. Not while it is being recorded by another:
/// the error says so; its own recorder takes it, see Recorder::save_project.
Status save_project(const std::string& path, const Project& project);

/// What could be read of a file, and what not.
struct ProjectReading {
  Project project;
  bool is_saved = false;            ///< a person saved it; otherwise it is what the recording knows
  int version = 0;                  ///< of the file
  std::string saved_at;             ///< UTC, "2024-05-17T14:03:22Z"; empty when it never was
  std::uint64_t damaged = 0;        ///< rows that could not be read, and were left out
  std::vector<std::string> damage;  ///< of what kind, one sentence each
};
/// Of a file of any version up to this one; a file of an older version gives what it has, and is not changed.
Result<ProjectReading> read_project(const std::string& path);
/// The same without what could not be read.
Result<Project> load_project(const std::string& path);

/// Brings a file to this program's version, whole or not at all. @return the version it had
Result<int> migrate_session(const std::string& path);

}  // namespace abrazo
