#include "app/workbench/document/unmapped_motion.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/joint_map.hpp"

namespace abrazo::app {

namespace fs = std::filesystem;

UnmappedMotion motion_without_joints(const std::vector<std::string>& files) {
  if (std::any_of(files.begin(), files.end(), is_joint_map_file)) return nullptr;
  std::string skeleton;
  for (const std::string& file : files)
    if (lower_case(file).ends_with(".asf")) skeleton = file;
  for (const std::string& file : files) {
    if (!is_motion_file(file)) continue;
    auto motions = read_motion_points(file, skeleton);
    if (!motions) continue;
    for (NamedMotion& motion : *motions)
      if (!joints_are_known(motion)) return std::make_shared<const NamedMotion>(std::move(motion));
  }
  return nullptr;
}

std::string remembered_map(const NamedMotion& motion, const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (lower_case(entry.path().extension().string()) == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const auto text = read_whole_file(file);
    if (!text) continue;
    const auto map = parse_joint_map(*text, file.string());
    if (map && bind_joints(*map, motion.points).missing.empty()) return file.string();
  }
  return {};
}

UnmappedMotion motion_to_map(const std::vector<std::string>& files, const std::string& folder) {
  UnmappedMotion motion = motion_without_joints(files);
  return motion && remembered_map(*motion, folder).empty() ? motion : nullptr;
}

Result<std::string> remember_map(const JointMap& map, const std::string& folder) {
  std::error_code trouble;
  fs::create_directories(folder, trouble);
  if (trouble)
    return Error{"cannot be made (" + trouble.message() + "); the joint map is not remembered", folder};
  std::string name;
  for (const char c : map.name)
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ? c : '_';
  if (name.empty()) name = "map";
  const std::string text = joint_map_json(map);
  for (int n = 1;; ++n) {
    const fs::path file =
        fs::path(folder) / (name.substr(0, 80) + (n > 1 ? "_" + std::to_string(n) : "") + ".json");
    if (fs::exists(file)) {
      if (const auto known = read_whole_file(file); known && *known == text) return file.string();
      continue;
    }
    if (const Status written = write_whole_file(file, text); !written) return written.error();
    return file.string();
  }
}

Result<Material> load_with_remembered_maps(const std::vector<std::string>& files, const Material& open,
                                           const std::string& folder, const Progress& progress) {
  Result<Material> material = load_material(files, open, progress);
  if (material) return material;
  const UnmappedMotion motion = motion_without_joints(files);
  const std::string map = motion ? remembered_map(*motion, folder) : std::string();
  if (map.empty()) return material;
  std::vector<std::string> with_map = files;
  with_map.push_back(map);
  return load_material(with_map, open, progress);
}

}  // namespace abrazo::app
