#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/base/result.hpp"
#include "core/session/decisions.hpp"
#include "core/session/markers.hpp"
#include "core/synthesis/settings.hpp"
#include "core/video/camera_model.hpp"
#include "core/video/video_sync.hpp"

namespace abrazo {

/// A file that a project stands on; its content stays where it is.
struct DataReference {
  enum class Use { Library, Manifest, Motion, Skeleton, Video, Intrinsics, JointMap };
  Use use = Use::Library;
  std::string relative_path;  ///< to the session file's folder, with '/'; empty where there is no such path
  std::string absolute_path;  ///< when it was saved last
  std::uint64_t bytes = 0;
  std::string
      hash;  ///< 16 hexadecimal digits of the content (whole up to 64 MiB; else size, begin, middle, end)

  bool operator==(const DataReference&) const = default;
};

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
  Markers markers;
  Settings settings;
  Decisions decisions;
  std::string
      input;  ///< take of the library, or motion file, that plays the user; empty = as the library says
  std::string presets;  ///< JSON of a person's own presets
  std::map<std::string, std::string>
      view;  ///< layout of panels, camera, lanes, ...: text or base64, by owner's name

  bool operator==(const Project&) const = default;
};

/// Puts the project into a session file, whole or not at all; what was recorded in it stays. The file is made
/// when there is none. Not while it is being recorded by another: the error says so.
Status save_project(const std::string& path, const Project& project);
/// Of a file of any version up to this one; a file of an older version gives what it has.
Result<Project> load_project(const std::string& path);

/// A reference to a file as it is now.
Result<DataReference> reference_to(const std::string& file, DataReference::Use use,
                                   const std::string& session_path);

/// Where the file is: beside the session by the relative path, else at the absolute one. Found with other
/// content counts as found, and says so.
struct FoundData {
  enum class State { Found, Changed, Missing };
  State state = State::Missing;
  std::string path;  ///< empty when missing
};
FoundData find_data(const DataReference& reference, const std::string& session_path);

/// After one missing file was pointed out: the others that lie as they did relative to it.
/// @return by index into `data`, the paths at which they exist
std::map<std::size_t, std::string> relocated(const std::vector<DataReference>& data, std::size_t pointed_out,
                                             const std::string& path);

}  // namespace abrazo
