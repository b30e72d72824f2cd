#include "core/opening/open_files.hpp"

#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/opening/generated_set.hpp"
#include "core/opening/joint_maps.hpp"
#include "core/opening/library_search.hpp"
#include "core/opening/session_material.hpp"

namespace abrazo {
namespace {

/// The same with a joint map that was remembered for points like these.
Status read_input_with_remembered_map(SortedFiles files, const OpeningWish& wish, Material& material,
                                      const Progress& progress) {
  Status read = read_input(files, wish.said, material, progress);
  if (read || wish.joint_maps.empty() || !files.joint_map.empty()) return read;
  std::vector<std::string> motion = {files.motion};
  if (!files.skeleton.empty()) motion.push_back(files.skeleton);
  const UnmappedMotion unmapped = motion_without_joints(motion, progress);
  if (unmapped) files.joint_map = remembered_map(*unmapped, wish.joint_maps);
  return files.joint_map.empty() ? read : read_input(files, wish.said, material, progress);
}

Result<Material> open_as_session(const SortedFiles& files, const OpeningWish& wish,
                                 const Progress& progress) {
  report(progress, 0, "Opening " + std::filesystem::path(files.session).filename().string());
  const auto session = open_session(files.session, wish.autosaves);
  if (!session) return session.error();
  return material_of(*session, {files.library, wish.open}, progress);
}

/// The library of the wish with what was open for the user; of a new one a take plays the user.
Status add_library(const SortedFiles& files, const Progress& progress, Material& material) {
  auto opened = files.library.empty() ? generated_dance(progress) : open_library(files.library, progress);
  if (!opened) return opened.error();
  if (files.library.empty())
    opened->warnings.emplace_back(
        "no library is open: a generated dance answers; open a library (.h5) or a manifest");
  opened->input = std::move(material.input);
  opened->input_files = std::move(material.input_files);
  opened->warnings.insert(opened->warnings.begin(), material.warnings.begin(), material.warnings.end());
  material = std::move(*opened);
  return Done{};
}

}  // namespace

Result<Material> open_files(const OpeningWish& wish, const Progress& progress) {
  const auto files = sorted(wish.files);
  if (!files) return files.error();
  if (!files->session.empty()) return open_as_session(*files, wish, progress);
  Material material = wish.open;
  material.warnings.clear();
  material.recorded.reset();
  material.project.reset();
  material.stands_in = false;
  const bool has_motion = !files->motion.empty();
  if (has_motion)
    if (const Status read = read_input_with_remembered_map(*files, wish, material, progress); !read)
      return read.error();
  if (!files->library.empty() || !material.library)
    if (const Status added = add_library(*files, progress, material); !added) return added.error();
  if (has_motion) return material;
  return danced_with(material, static_cast<int>(material.library->takes().size()) - 1);
}

Status read_input(const SortedFiles& files, const ImportOptions& said, Material& material,
                  const Progress& progress) {
  const std::string name = std::filesystem::path(files.motion).filename().string();
  ImportOptions options = said;
  if (!files.joint_map.empty()) {
    const auto content = read_whole_file(files.joint_map);
    if (!content) return content.error();
    auto map = parse_joint_map(*content, files.joint_map);
    if (!map) return map.error();
    options.joint_map = std::move(map).value();
  }
  auto clips = load_motion(files.motion, files.skeleton, options, progress);
  if (!clips) return clips.error();
  ImportedClip& first = clips->front();
  if (clips->size() > 1)
    material.warnings.push_back(name + ": has " + std::to_string(clips->size()) + " performers; the first, " +
                                first.clip.name + ", plays the user");
  for (const ImportWarning& warning : first.report.warnings)
    material.warnings.push_back(name + ": " + warning.detail);
  material.input = std::move(first.clip);
  material.input_files = {files.motion};
  for (const std::string& file : {files.skeleton, files.joint_map})
    if (!file.empty()) material.input_files.push_back(file);
  material.excluded_takes.clear();
  return Done{};
}

}  // namespace abrazo
