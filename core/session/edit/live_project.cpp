#include "core/session/edit/live_project.hpp"

#include <algorithm>
#include <utility>

#include "core/session/frames/decision_edits.hpp"

namespace abrazo {

namespace {

/// A preset is how the partner answers, a body is whose: those that were chosen stay, unless a person's own
/// preset has another.
Settings with_bodies_of(const Settings& present, Settings of_preset) {
  for (BodyChoice Settings::*body : {&Settings::active_body, &Settings::passive_body})
    if (of_preset.*body == BodyChoice{}) of_preset.*body = present.*body;
  return of_preset;
}

}  // namespace

bool ProjectEdit::absorb(const ProjectEdit& next) {
  if (gesture == 0 || next.gesture != gesture || next.key != key || next.after.index() != after.index())
    return false;
  after = next.after;
  what = next.what;
  return true;
}

bool ProjectEdit::is_nothing() const {
  const auto* to = std::get_if<ChosenSettings>(&after);
  return to ? to->settings == std::get<ChosenSettings>(before).settings : before == after;
}

const Markers& LiveProject::markers(const std::string& subject) const {
  static const Markers none;
  if (subject.empty()) return project_.markers;
  const auto found = project_.take_markers.find(subject);
  return found == project_.take_markers.end() ? none : found->second;
}

ChosenSettings LiveProject::with_settings(const Settings& settings) const {
  return {settings, choice_for(settings, preset_, own_presets_)};
}

Result<ChosenSettings> LiveProject::with_setting(const std::string& key, const std::string& text) const {
  Settings next = project_.settings;
  if (const Status set = set_setting(next, key, text); !set) return set.error();
  return with_settings(next);
}

Result<ChosenSettings> LiveProject::with_preset(const std::string& name, bool own) const {
  if (!own) {
    const auto chosen = abrazo::preset(name);
    if (!chosen) return chosen.error();
    return ChosenSettings{with_bodies_of(project_.settings, *chosen), {name, false, *chosen}};
  }
  const auto found = std::ranges::find(own_presets_, name, &OwnPreset::name);
  if (found == own_presets_.end()) return Error{"There is no own preset \u201c" + name + "\u201d", ""};
  return ChosenSettings{with_bodies_of(project_.settings, found->settings), {name, true, found->settings}};
}

int LiveProject::epoch_of(const ProjectValue& value) const {
  return std::holds_alternative<Decisions>(value)            ? libraries_
         : std::holds_alternative<SubjectMarkers>(value)     ? sessions_
         : std::holds_alternative<SubjectAnnotations>(value) ? annotations_.number()
         : std::holds_alternative<VideoStates>(value)        ? replaced_videos_
                                                             : 0;
}

std::optional<ProjectEdit> LiveProject::edit(ProjectValue after, std::string what) const {
  ProjectEdit edit;
  edit.epoch = epoch_of(after);
  edit.what = std::move(what);
  if (std::holds_alternative<ChosenSettings>(after)) {
    edit.before = ChosenSettings{project_.settings, preset_};
  } else if (auto* decisions = std::get_if<Decisions>(&after)) {
    decisions->role_control = project_.decisions.role_control;
    edit.before = project_.decisions;
  } else if (const auto* marked = std::get_if<SubjectMarkers>(&after)) {
    edit.before = SubjectMarkers{marked->subject, markers(marked->subject)};
  } else if (const auto* said = std::get_if<SubjectAnnotations>(&after)) {
    edit.before = SubjectAnnotations{said->subject, annotations_.of(said->subject)};
  } else {
    edit.before = videos_;
  }
  edit.after = std::move(after);
  return edit.is_nothing() ? std::nullopt : std::optional(std::move(edit));
}

bool LiveProject::is_valid(const ProjectEdit& edit) const {
  return edit.epoch == epoch_of(edit.after);
}

LiveProject::Parts LiveProject::put(const ProjectValue& value) {
  if (const auto* chosen = std::get_if<ChosenSettings>(&value)) {
    project_.settings = chosen->settings;
    preset_ = chosen->preset;
    return {ProjectPart::Settings};
  }
  if (const auto* decisions = std::get_if<Decisions>(&value)) {
    const RoleControl by = project_.decisions.role_control;
    project_.decisions = *decisions;
    project_.decisions.role_control = by;
    return {ProjectPart::Decisions};
  }
  if (const auto* videos = std::get_if<VideoStates>(&value)) {
    videos_ = *videos;
    project_.videos.clear();
    for (const VideoState& video : videos_) {
      project_.videos.push_back(project_video(video));
      project_.videos.back().data = static_cast<int>(project_.videos.size()) - 1;
    }
    return {ProjectPart::Videos};
  }
  if (const auto* said = std::get_if<SubjectAnnotations>(&value)) {
    annotations_.put(said->subject, said->annotations);
    return annotated();
  }
  const auto& [subject, markers] = std::get<SubjectMarkers>(value);
  if (subject.empty())
    project_.markers = markers;
  else if (markers.empty())
    project_.take_markers.erase(subject);
  else
    project_.take_markers[subject] = markers;
  return {ProjectPart::Markers};
}

LiveProject::Parts LiveProject::put(RoleControl by) {
  project_.decisions.role_control = by;
  return {ProjectPart::RoleControl};
}

LiveProject::Parts LiveProject::put(std::vector<OwnPreset> own) {
  own_presets_ = std::move(own);
  if (preset_.own) {
    const auto chosen = std::ranges::find(own_presets_, preset_.name, &OwnPreset::name);
    chosen == own_presets_.end() ? void(preset_ = {}) : void(preset_.settings = chosen->settings);
  }
  preset_ = choice_for(project_.settings, preset_, own_presets_);
  return {ProjectPart::Settings};
}

void LiveProject::begin_annotations(const std::string& subject, const MotionLibrary& library) {
  annotations_.begin(subject, library);
}

LiveProject::Parts LiveProject::open_annotations(AnnotationBook book, const MotionLibrary& library,
                                                 bool is_saved) {
  annotations_.open(std::move(book), library, is_saved);
  return annotated();
}

LiveProject::Parts LiveProject::annotated() {
  project_.annotations = annotations_.changed();
  return {ProjectPart::Annotations};
}

LiveProject::Parts LiveProject::replace_videos(VideoStates videos) {
  ++replaced_videos_;
  return put(ProjectValue(std::move(videos)));
}

std::vector<DataReference> LiveProject::video_files() const {
  std::vector<DataReference> files;
  for (const VideoState& video : videos_)
    files.push_back(unread_reference(DataReference::Use::Video, video.file));
  return files;
}

LiveProject::Parts LiveProject::begin_session(const MotionLibrary& library, bool same_library) {
  ++sessions_;
  project_.markers = {};
  project_.take_markers.clear();
  annotations_.start(library);
  annotated();
  Parts changed{ProjectPart::Markers, ProjectPart::Annotations};
  if (same_library) return changed;
  ++libraries_;
  put(Decisions{});
  changed.push_back(ProjectPart::Decisions);
  return changed;
}

LiveProject::Parts LiveProject::replace_library(const MotionLibrary& before, const MotionLibrary& after) {
  ++libraries_;
  return put(carried_over(project_.decisions, before, after));
}

LiveProject::Parts LiveProject::open(const Project& saved) {
  put(with_settings(saved.settings));
  Decisions decisions = saved.decisions;
  decisions.meant.reset();  // it was meant then
  put(decisions);
  project_.markers = saved.markers;
  project_.take_markers = saved.take_markers;
  return {ProjectPart::Settings, ProjectPart::Decisions, ProjectPart::Markers};
}

}  // namespace abrazo
