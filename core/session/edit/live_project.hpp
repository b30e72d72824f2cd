#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/session/edit/live_annotations.hpp"
#include "core/session/edit/project_edit.hpp"
#include "core/session/file/project.hpp"

namespace abrazo {

/// A project being edited: the value and the rules by which it changes. Independent of solver and window.
/// Every change returns the parts that differ; the caller announces them.
class LiveProject {
 public:
  using Parts = std::vector<ProjectPart>;

  LiveProject() { project_.settings = preset_.settings; }

  const Project& project() const { return project_; }
  const PresetChoice& preset() const { return preset_; }
  const std::vector<OwnPreset>& own_presets() const { return own_presets_; }
  /// Markers of the session ("") or of a take; empty if there are none.
  const Markers& markers(const std::string& subject) const;
  /// Of all subjects, also those that nobody changed: the project has only those that changed.
  const LiveAnnotations& annotations() const { return annotations_; }

  /// The present settings with one of them set from typed text. The Error names the setting and its valid
  /// values.
  Result<ChosenSettings> with_setting(const std::string& key, const std::string& text) const;
  /// @param own whether to look among the user's own presets. An Error if there is none of that name
  Result<ChosenSettings> with_preset(const std::string& name, bool own) const;
  /// Settings from any origin, with the preset that they equal; if they equal none, the one chosen last.
  ChosenSettings with_settings(const Settings& settings) const;

  /// The undo step from the present value to `after`; none if there is nothing to undo.
  std::optional<ProjectEdit> edit(ProjectValue after, std::string what) const;
  /// Whether an undo step still applies: decisions refer to pairs of the library, markers to times of the
  /// session and annotations to the book in which they were made.
  bool is_valid(const ProjectEdit& edit) const;

  /// Sets a value without an undo step.
  Parts put(const ProjectValue& value);
  Parts put(RoleControl by);
  /// Replaces the user's own presets; the chosen one may be missing or changed afterwards.
  Parts put(std::vector<OwnPreset> own);
  /// Replaces all videos, not as an edit: undo steps back to the previous ones become invalid.
  Parts replace_videos(VideoStates videos);
  const VideoStates& videos() const { return videos_; }
  /// In the order of the videos; ProjectVideo::data of project() is an index into it.
  std::vector<DataReference> video_files() const;

  /// Before a subject is shown.
  void begin_annotations(const std::string& subject, const MotionLibrary& library);
  /// Replaces all annotations by those of a project. @param is_saved  see LiveAnnotations::open
  Parts open_annotations(AnnotationBook book, const MotionLibrary& library, bool is_saved = true);
  /// These annotations are in a session file now: those of takes stay in the next session.
  void note_saved(const AnnotationBook& book) { annotations_.note_saved(book); }

  /// Begins a session. Drops markers and annotations of the previous one and, if the library differs, the
  /// decisions about its pairs. Settings and role control stay, and so do saved annotations of takes that
  /// this library has, too. @param library  that of the files, see LiveAnnotations
  Parts begin_session(const MotionLibrary& library, bool same_library);
  /// The session continues with another library.
  Parts replace_library(const MotionLibrary& before, const MotionLibrary& after);
  /// Takes over a saved project in the new session, except annotations and videos, which have functions of
  /// their own.
  Parts open(const Project& saved);

 private:
  int epoch_of(const ProjectValue& value) const;
  Parts annotated();

  Project project_;
  LiveAnnotations annotations_;
  PresetChoice preset_;
  std::vector<OwnPreset> own_presets_;
  VideoStates videos_;
  int libraries_ = 0, sessions_ = 0, replaced_videos_ = 0;  ///< counters for `epoch`
};

}  // namespace abrazo
