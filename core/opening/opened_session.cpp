#include "app/workbench/document/project_opening.hpp"

#include <algorithm>
#include <filesystem>

#include "app/workbench/base/user_settings.hpp"
#include "app/workbench/document/generated_material.hpp"

namespace abrazo::app {
namespace {

namespace fs = std::filesystem;
using Use = DataReference::Use;

/// What is written there by Autosave belongs to another file, which it names. Anywhere else a file is what it
/// is: one from a stranger must not choose what "Save" writes to.
bool is_in_autosave_folder(const std::string& file) {
  std::error_code failure;
  const fs::path folder = fs::path(UserSettings().folder().toStdString()) / "autosave";
  return fs::equivalent(fs::absolute(file, failure).parent_path(), folder, failure);
}

void warn_of(const OpenedProject& opened, std::vector<std::string>& warnings) {
  const auto& damage = opened.reading.damage;
  warnings.insert(warnings.end(), damage.begin(), damage.end());
  for (std::size_t i = 0; i < opened.found.size(); ++i) {
    const DataReference& data = opened.project().data[i];
    const std::string name = fs::path(data.absolute_path).filename().string();
    if (opened.found[i].state == FoundData::State::Changed)
      warnings.push_back(name + " has other content than when the session was saved");
    if (opened.found[i].state == FoundData::State::Missing)
      warnings.push_back(name + " is not there: " + without(data.use));
  }
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

Result<std::shared_ptr<const OpenedProject>> open_project(const std::string& file, const Places& places) {
  auto reading = read_project(file);
  if (!reading) return reading.error();
  auto opened = std::make_shared<OpenedProject>();
  opened->file = file;
  opened->reading = std::move(*reading);
  auto& view = opened->reading.project.view;
  if (const auto of = view.find(autosaved_key); of != view.end() && is_in_autosave_folder(file)) {
    opened->autosave = file;
    opened->file = of->second;
  }
  view.erase(autosaved_key);
  std::size_t index = 0;
  for (const DataReference& data : opened->project().data) {
    const auto place = places.find(index++);
    if (place == places.end()) {
      opened->found.push_back(find_data(data, opened->file));
    } else {
      DataReference moved = data;
      moved.relative_path.clear();
      moved.absolute_path = place->second;
      opened->found.push_back(find_data(moved, {}));
    }
  }
  return std::shared_ptr<const OpenedProject>(std::move(opened));
}

std::string without(Use use) {
  switch (use) {
    case Use::Library:
    case Use::Manifest:
      return "the generated dance answers in its place; annotations of takes are kept, but not shown";
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

Result<Material> material_of(const OpenedProject& opened, const Progress& progress) {
  std::vector<std::string> files;
  for (const Use use : {Use::Library, Use::Manifest}) {
    const std::string place = opened.place_of(use);
    if (!place.empty() && files.empty()) files.push_back(place);
  }
  const bool has_library = !files.empty();
  const std::string motion = opened.place_of(Use::Motion);
  const auto is_missing = [&](std::size_t i) {
    const Use use = opened.project().data[i].use;
    return use == Use::Skeleton || use == Use::JointMap;
  };
  if (!motion.empty() && std::ranges::none_of(opened.missing(), is_missing)) {
    files.push_back(motion);
    for (const Use use : {Use::Skeleton, Use::JointMap})
      if (const std::string place = opened.place_of(use); !place.empty()) files.push_back(place);
  }
  auto material = files.empty() ? make_demo(progress) : load_material(files, {}, progress);
  if (!material) return material.error();
  if (has_library && !opened.project().input.empty()) {
    const auto& takes = material->library->takes();
    const auto take = std::ranges::find(takes, opened.project().input, &LibraryTake::name);
    if (take != takes.end()) material = danced_with(*material, static_cast<int>(take - takes.begin()));
  }
  warn_of(opened, material->warnings);
  return material;
}

}  // namespace abrazo::app
