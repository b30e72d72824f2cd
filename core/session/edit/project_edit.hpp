#pragma once

#include <string>
#include <variant>

#include "core/annotation/annotations.hpp"
#include "core/session/edit/video_state.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/session/frames/markers.hpp"
#include "core/synthesis/settings/preset_choice.hpp"

namespace abrazo {

/// A part of a project that changes as one value and is announced as such.
enum class ProjectPart { Settings, Decisions, RoleControl, Markers, Annotations, Videos };

/// Settings with the preset that they came from.
struct ChosenSettings {
  Settings settings;
  PresetChoice preset;

  bool operator==(const ChosenSettings&) const = default;
};

/// Markers of the session (""), or of a take by its name.
struct SubjectMarkers {
  std::string subject;
  Markers markers;

  bool operator==(const SubjectMarkers&) const = default;
};

/// Annotations of the session (""), or of a take by its name.
struct SubjectAnnotations {
  std::string subject;
  Annotations annotations;

  bool operator==(const SubjectAnnotations&) const = default;
};

/// A whole part that an undo step changes. An undo step leaves the role control of the decisions as it is.
using ProjectValue = std::variant<ChosenSettings, Decisions, SubjectMarkers, SubjectAnnotations, VideoStates>;

/// One undo step: a part before and after the edit.
struct ProjectEdit {
  ProjectValue before, after;
  std::string what;  ///< menu text: "alpha to 0.7"
  std::string key;   ///< what is dragged, e.g. one slider
  int gesture = 0;   ///< edits of one key with the same number merge into one step; 0 = separate step
  int epoch = 0;     ///< see LiveProject::is_valid

  /// Merges a later edit of the same gesture into this step. @return false if it belongs to another gesture
  bool absorb(const ProjectEdit& next);
  /// True if the value ends where it began: a slider that was dragged and brought back.
  bool is_nothing() const;
};

}  // namespace abrazo
