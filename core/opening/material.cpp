#include "core/opening/material.hpp"

#include <algorithm>
#include <filesystem>

#include "core/base/text.hpp"
#include "core/library/store/normalization.hpp"
#include "core/opening/import_rules.hpp"
#include "core/opening/opened_session.hpp"

namespace abrazo {
namespace {

namespace fs = std::filesystem;
using Use = DataReference::Use;

std::string extension_of(const std::string& file) {
  return lower_case(fs::path(file).extension().string());
}

Use use_of_library(const std::string& file) {
  return extension_of(file) == ".json" ? Use::Manifest : Use::Library;
}

Use use_of_input(const std::string& file) {
  const std::string extension = extension_of(file);
  return extension == ".asf" ? Use::Skeleton : extension == ".json" ? Use::JointMap : Use::Motion;
}

/// As it was: the library of the project, and a take of it that plays the user, are only not there now.
void describe_missing_library(const Project& opened, Project& project) {
  project.library = opened.library;
  project.input = opened.input;
  project.manifest = opened.manifest;
  std::ranges::copy_if(opened.data, std::back_inserter(project.data),
                       [](const DataReference& data) { return is_of_library(data.use); });
}

void describe_library(const Material& material, Project& project) {
  project.library = material.library->name();
  if (!material.library_file.empty()) {
    project.data.push_back(unread_reference(use_of_library(material.library_file), material.library_file));
  } else if (material.manifest) {
    project.manifest = whole_manifest_json(*material.manifest);
    for (const std::string& file : files_of(*material.manifest))
      project.data.push_back(unread_reference(Use::Take, file));
  }
}

}  // namespace

Markers RecordedSession::markers() const {
  Markers markers;
  for (const SessionMarker& marker : contents.markers) markers.add(marker.time_s, marker.name);
  return markers;
}

std::vector<std::string> Material::input_files() const {
  std::vector<std::string> files;
  for (const std::string& file : {reading.file, reading.skeleton})
    if (!file.empty()) files.push_back(file);
  if (!reading.joint_map.empty() && !is_builtin_joint_map(reading.joint_map))
    files.push_back(reading.joint_map);
  return files;
}

bool Material::has_unsaved_library() const {
  return library && library_file.empty() && !is_generated && !stands_in;
}

Clip clip_of_take(const MotionLibrary& library, int take) {
  Clip clip;
  const LibraryTake& about = library.takes()[static_cast<std::size_t>(take)];
  clip.name = about.name;
  clip.fps = about.fps / std::max(1, about.frame_stride);
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    if (static_cast<int>(source.take) != take || source.swapped) continue;
    clip.poses.push_back(to_world(library.pose(pair).topRows<joint_count>(), library.root(pair)));
  }
  return clip;
}

Material for_next_session(const Material& open) {
  Material material = open;
  material.library = open.library_of_files();
  material.unannotated.reset();
  material.warnings.clear();
  material.recorded.reset();
  material.project.reset();
  material.stands_in = false;
  material.is_doubtful = false;
  material.is_input_asked = false;
  return material;
}

Material danced_with(const Material& open, int take) {
  Material material = open;
  material.recorded.reset();
  material.project.reset();
  material.stands_in = false;
  material.reading = {};
  material.is_doubtful = false;
  material.input = clip_of_take(*open.library, take);
  material.excluded_takes.clear();
  if (open.library->takes().size() > 1)
    material.excluded_takes = {open.library->takes()[static_cast<std::size_t>(take)].name};
  else
    material.warnings.emplace_back(
        "the library has one take, which plays the user and answers too: the answers are "
        "its own frames; add a take to see more");
  return material;
}

Material fresh_session(const Material& open) {
  Material next = for_next_session(open);
  return next.input.poses.empty() ? danced_with(next, static_cast<int>(next.library->takes().size()) - 1)
                                  : next;
}

Material asked_dance(const Material& open, int take) {
  Material material = danced_with(for_next_session(open), take);
  material.is_input_asked = true;
  return material;
}

Material built_material(std::shared_ptr<const MotionLibrary> library, Manifest manifest, std::string file,
                        std::vector<std::string> warnings) {
  Material material;
  material.library = std::move(library);
  material.library_file = std::move(file);
  material.manifest = std::make_shared<const Manifest>(std::move(manifest));
  material.warnings = std::move(warnings);
  return danced_with(material, static_cast<int>(material.library->takes().size()) - 1);
}

void describe(const Material& material, Project& project) {
  const bool is_missing = material.stands_in && material.project;
  is_missing ? describe_missing_library(material.project->project(), project)
             : describe_library(material, project);
  for (const std::string& file : material.input_files())
    project.data.push_back(unread_reference(use_of_input(file), file));
  if (const std::string how = reading_json(material.reading); how != reading_json({}))
    project.view[view_of_reading] = how;
  // Of a recorded session the input is in the recording.
  if (material.reading.file.empty() && !material.is_only_recorded() && !is_missing)
    project.input = material.input.name;
}

Project with_library_file(Project project, const std::string& file) {
  // Videos name their data by index: what follows the library's moves up.
  std::vector<DataReference> data = {unread_reference(use_of_library(file), file)};
  std::vector<int> place(project.data.size(), -1);
  for (std::size_t i = 0; i < project.data.size(); ++i) {
    if (is_of_library(project.data[i].use)) continue;
    place[i] = static_cast<int>(data.size());
    data.push_back(std::move(project.data[i]));
  }
  for (ProjectVideo& video : project.videos)
    if (video.data >= 0) video.data = place[static_cast<std::size_t>(video.data)];
  project.data = std::move(data);
  project.manifest.clear();
  return project;
}

std::string library_file_beside(const std::string& session_file, const std::string& library_name) {
  std::string name = library_name.empty() ? "library" : library_name;
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == '\\' || static_cast<unsigned char>(c) < ' '; }, '_');
  const fs::path folder = fs::absolute(session_file).parent_path();
  std::error_code ignored;
  fs::path file = folder / (name + ".h5");
  for (int next = 2; fs::exists(file, ignored); ++next)
    file = folder / (name + " (" + std::to_string(next) + ").h5");
  return file.string();
}

std::vector<std::pair<std::string, std::size_t>> annotated_elsewhere(const AnnotationBook& book,
                                                                     const MotionLibrary& library) {
  std::vector<std::pair<std::string, std::size_t>> elsewhere;
  for (const auto& [subject, annotations] : book) {
    if (subject.empty() || library.find_take(subject) >= 0) continue;
    std::size_t count = 0;
    for (const AnnotationTier& tier : annotations.tiers()) count += tier.annotations.size();
    if (count > 0) elsewhere.emplace_back(subject, count);
  }
  return elsewhere;
}

}  // namespace abrazo
