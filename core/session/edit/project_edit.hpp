#pragma once

#include <string>
#include <variant>

#include "core/session/edit/video_state.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/session/frames/markers.hpp"
#include "core/synthesis/preset_choice.hpp"

namespace abrazo {

/// What of a project changes as one value, and is announced when it did.
enum class ProjectPart { Settings, Decisions, RoleControl, Markers, Annotations, Videos };

/// The settings, and the preset that they came from.
struct ChosenSettings {
  Settings settings;
  PresetChoice preset;

  bool operator==(const ChosenSettings&) const = default;
};

/// Of the session (""), or of a take by its name.
struct SubjectMarkers {
  std::string subject;
  Markers markers;

  bool operator==(const SubjectMarkers&) const = default;
};

/// A part that a step of undo changes, whole. Who decides about the role is not among the decisions of a
/// step.
using ProjectValue = std::variant<ChosenSettings, Decisions, SubjectMarkers, VideoStates>;

/// One step of undo: a part as it was, and as a person wants it.
struct ProjectEdit {
  ProjectValue before, after;
  std::string what;  ///< "alpha to 0.7": for the menu
  std::string key;   ///< what is dragged
  int gesture = 0;   ///< edits of one key with the same number are one step; 0 = a step of its own
  int epoch = 0;     ///< see LiveProject::is_valid

  /// Takes a later move of the same gesture into this step. @return false when it is not of it
  bool absorb(const ProjectEdit& next);
  /// It ends where it began, as a slider that was dragged and brought back.
  bool is_nothing() const;
};

}  // namespace abrazo
