#include "core/opening/joint_maps.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/opening/file_kinds.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

/// All markers of the model are among the points, and they are enough.
bool fits_whole(const MarkerModel& model, const std::vector<std::string>& points) {
  std::size_t places = 0;
  for (const auto& sides : model.names)
    for (const auto& names : sides) places += names.empty() ? 0 : 1;
  const MarkerFit fit = fit_of(model, points);
  return fit.missing.empty() && fit.found == places;
}

}  // namespace

UnmappedMotion motion_without_joints(const std::vector<std::string>& files, const Progress& progress) {
  const std::vector<FileToOpen> known = recognised(files);
  if (std::ranges::count(known, FileKind::JointMap, &FileToOpen::kind) > 0) return nullptr;
  const auto skeleton = std::ranges::find(known, FileKind::Skeleton, &FileToOpen::kind);
  for (const FileToOpen& file : known) {
    if (file.kind != FileKind::Motion) continue;
    auto motions =
        read_motion_points(file.path, skeleton == known.end() ? std::string() : skeleton->path, {}, progress);
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
    if (is_marker_model(*text)) {
      const auto model = parse_marker_model(*text, file.string());
      if (model && fits_whole(*model, motion.points)) return file.string();
      continue;
    }
    const auto map = parse_joint_map(*text, file.string());
    if (map && bind_joints(*map, motion.points).missing.empty()) return file.string();
  }
  return {};
}

UnmappedMotion motion_to_map(const std::vector<std::string>& files, const std::string& folder) {
  UnmappedMotion motion = motion_without_joints(files);
  return motion && remembered_map(*motion, folder).empty() ? motion : nullptr;
}

namespace {

Result<std::string> keep_map(const std::string& called, const std::string& text, const std::string& folder) {
  std::error_code trouble;
  fs::create_directories(folder, trouble);
  if (trouble)
    return Error{"cannot be made (" + trouble.message() + "); the joint map is not remembered", folder};
  std::string name;
  for (const char c : called)
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ? c : '_';
  if (name.empty()) name = "map";
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

}  // namespace

Result<std::string> remember_map(const JointMap& map, const std::string& folder) {
  return keep_map(map.name, joint_map_json(map), folder);
}

Result<std::string> remember_map(const MarkerModel& model, const std::string& folder) {
  return keep_map(model.name, marker_model_json(model), folder);
}

}  // namespace abrazo
