#include "core/opening/opened_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "core/motion/joints/performers.hpp"

namespace abrazo {
namespace {

namespace fs = std::filesystem;
using Use = DataReference::Use;

bool lies_in(const std::string& file, const std::string& folder) {
  std::error_code failure;
  return !folder.empty() && fs::equivalent(fs::absolute(file, failure).parent_path(), folder, failure);
}

FoundData found_now(const DataReference& data, const std::string& session, const std::string* place) {
  if (!place) return find_data(data, session);
  DataReference moved = data;
  moved.relative_path.clear();
  moved.absolute_path = *place;
  return find_data(moved, {});
}

std::vector<FoundData> found_now(const OpenedProject& project, const Places& places) {
  std::vector<FoundData> found;
  for (std::size_t i = 0; i < project.project().data.size(); ++i) {
    const auto place = places.find(i);
    found.push_back(
        found_now(project.project().data[i], project.file, place == places.end() ? nullptr : &place->second));
  }
  return found;
}

/// Calls `visit` on every path of a manifest; joint maps and orders may be built-in ones, which are no files.
void each_file(Manifest& manifest, const std::function<void(fs::path&)>& visit) {
  for (Manifest::Take& take : manifest.takes) {
    for (Manifest::Performer* performer : {&take.a, &take.b}) {
      visit(performer->motion);
      visit(performer->skeleton);
      for (std::string* named : {&performer->joint_map, &performer->joints}) {
        fs::path file = *named;
        if (!file.has_parent_path()) continue;
        visit(file);
        *named = file.string();
      }
    }
    visit(take.labels);
    visit(take.roles_file);
  }
}

std::vector<std::string> without_folders(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(fs::path(file).filename().string());
  return names;
}

std::string whole(const fs::path& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal().string();
}

}  // namespace

std::string OpenedProject::place_of(Use use) const {
  for (std::size_t i = 0; i < found.size(); ++i)
    if (project().data[i].use == use && !found[i].path.empty()) return found[i].path;
  return {};
}

std::vector<std::size_t> OpenedProject::missing() const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].state == FoundData::State::Missing) indices.push_back(i);
  return indices;
}

std::vector<std::string> OpenedProject::video_places() const {
  std::vector<std::string> places;
  for (const ProjectVideo& video : project().videos) {
    const auto index = static_cast<std::size_t>(std::max(0, video.data));
    const bool has_file = video.data >= 0 && index < found.size();
    places.push_back(!has_file                   ? std::string()
                     : found[index].path.empty() ? project().data[index].absolute_path
                                                 : found[index].path);
  }
  return places;
}

OpenedProject located(const std::string& file, ProjectReading reading, const Places& places,
                      const std::string& autosaves) {
  OpenedProject opened;
  opened.file = file;
  opened.reading = std::move(reading);
  auto& view = opened.reading.project.view;
  if (const auto of = view.find(autosaved_key); of != view.end() && lies_in(file, autosaves)) {
    opened.autosave = file;
    opened.file = of->second;
  }
  view.erase(autosaved_key);
  opened.found = found_now(opened, places);
  return opened;
}

std::vector<std::string> OpenedSession::damage() const {
  std::vector<std::string> sentences = recording.recovery;
  for (const std::string& sentence : project->reading.damage)
    if (std::ranges::find(sentences, sentence) == sentences.end()) sentences.push_back(sentence);
  return sentences;
}

Result<OpenedSession> open_session(const std::string& file, const std::string& autosaves) {
  auto read = read_session(file);
  if (!read) return read.error();
  OpenedSession session;
  session.project = std::make_shared<const OpenedProject>(located(file, read->project, {}, autosaves));
  session.recording = std::move(*read);
  if (session.project->autosave.empty()) return session;
  const std::string& own = session.project->file;
  session.recording = {};
  std::error_code ignored;
  if (own.empty() || !fs::exists(own, ignored)) return session;
  auto recording = read_session(own);
  if (!recording) return recording.error();
  session.recording = std::move(*recording);
  return session;
}

OpenedSession with_places(OpenedSession session, const Places& places) {
  OpenedProject project = *session.project;
  project.found = found_now(project, places);
  project.is_relocated = std::ranges::any_of(places, [](const auto& place) { return !place.second.empty(); });
  session.project = std::make_shared<const OpenedProject>(std::move(project));
  return session;
}

std::string without(Use use) {
  switch (use) {
    case Use::Library:
    case Use::Manifest:
      return "the generated dance answers in its place; annotations of takes are kept, but not shown";
    case Use::Take:
      return "the library cannot be built again: the generated dance answers in its place; annotations of "
             "takes are kept, but not shown";
    case Use::Motion:
      return "a take of the library plays the user";
    case Use::Skeleton:
    case Use::JointMap:
      return "the motion that needs it is left out; a take of the library plays the user";
    case Use::Video:
      return "its picture is not shown; sync points and camera are kept";
    case Use::Intrinsics:
      return "the camera is as it was solved";
  }
  return {};
}

std::vector<std::string> files_of(const Manifest& manifest) {
  std::vector<std::string> files;
  Manifest copy = manifest;
  each_file(copy, [&](const fs::path& path) {
    if (path.empty() || std::ranges::find(files, whole(path)) != files.end()) return;
    files.push_back(whole(path));
  });
  return files;
}

std::string whole_manifest_json(const Manifest& manifest) {
  return manifest_json(manifest, "/");
}

Result<Manifest> kept_manifest(const OpenedProject& opened) {
  const Project& project = opened.project();
  if (project.manifest.empty()) return Error{"keeps no manifest of its library", opened.file};
  auto manifest =
      parse_manifest(project.manifest, "/manifest of " + fs::path(opened.file).filename().string());
  if (!manifest) return manifest;
  std::vector<std::string> missing;
  each_file(*manifest, [&](fs::path& path) {
    if (path.empty()) return;
    const std::string file = whole(path);
    for (std::size_t i = 0; i < project.data.size(); ++i) {
      if (project.data[i].use != Use::Take || project.data[i].absolute_path != file) continue;
      if (!opened.found[i].path.empty())
        path = opened.found[i].path;
      else if (std::ranges::find(missing, file) == missing.end())
        missing.push_back(file);
    }
  });
  if (missing.empty()) return manifest;
  return Error{fmt::format("its library \"{}\" cannot be built again: {} {} not there", manifest->name,
                           some_of(without_folders(missing), 2), missing.size() == 1 ? "is" : "are"),
               opened.file};
}

bool is_of_library(Use use) {
  return use == Use::Library || use == Use::Manifest || use == Use::Take;
}

}  // namespace abrazo
