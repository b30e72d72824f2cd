#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/edit/project_edit.hpp"
#include "core/session/file/project.hpp"

namespace abrazo {

/// A project while it is worked on: the value, and the rules by which it changes. Knows no solver and no
/// window; who changes it passes on which parts are other than before.
class LiveProject {
 public:
  using Parts = std::vector<ProjectPart>;

  LiveProject() { project_.settings = preset_.settings; }

  const Project& project() const { return project_; }
  const PresetChoice& preset() const { return preset_; }
  const std::vector<OwnPreset>& own_presets() const { return own_presets_; }
  /// Of the session ("") or of a take; empty where nothing was marked.
  const Markers& markers(const std::string& subject) const;

  /// These settings with one of them as a person typed it. An Error names the setting and what it takes.
  Result<ChosenSettings> with_setting(const std::string& key, const std::string& text) const;
  /// @param own  among a person's own presets. An Error when there is none of that name
  Result<ChosenSettings> with_preset(const std::string& name, bool own) const;
  /// Settings from wherever, with the preset that they are; the one chosen last while they are none's.
  ChosenSettings with_settings(const Settings& settings) const;

  /// The step that leads to a value from what there is; nothing when there is nothing to undo about it.
  std::optional<ProjectEdit> edit(ProjectValue after, std::string what) const;
  /// Decisions mean the pairs of the library, and markers the times of the session, that they were made in.
  bool is_valid(const ProjectEdit& edit) const;

  /// Without a step of undo.
  Parts put(const ProjectValue& value);
  Parts put(RoleControl by);
  /// A person's own presets, of which the chosen one may be gone or other.
  Parts put(std::vector<OwnPreset> own);
  Parts put(AnnotationBook annotations);
  /// Other videos than a person opened: steps of undo that lead to those before have no use any more.
  Parts replace_videos(VideoStates videos);
  const VideoStates& videos() const { return videos_; }
  /// In the order of the videos; ProjectVideo::data of project() is an index into it.
  std::vector<DataReference> video_files() const;

  /// A session begins: markers and annotations of the one before are gone, and with another library the
  /// decisions on its pairs; settings and who decides about the role stay.
  Parts begin_session(bool same_library);
  /// The session goes on with another library.
  Parts replace_library(const MotionLibrary& before, const MotionLibrary& after);
  /// What was saved, in the session that has begun, except annotations and videos: who reads their files puts
  /// them.
  Parts open(const Project& saved);

 private:
  int epoch_of(const ProjectValue& value) const;

  Project project_;
  PresetChoice preset_;
  std::vector<OwnPreset> own_presets_;
  VideoStates videos_;
  int libraries_ = 0, sessions_ = 0, replaced_videos_ = 0;  ///< so many came and went
};

}  // namespace abrazo
