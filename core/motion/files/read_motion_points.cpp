#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/base/text.hpp"
#include "core/motion/acclaim/asf_amc.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/motion/files/format_recognition.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/marker_gaps.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/numpy/numpy_reader.hpp"
#include "core/motion/scenes/scene_process.hpp"
#include "core/motion/scenes/vrm_bones.hpp"
#include "core/motion/tables/c3d_reader.hpp"
#include "core/motion/tables/point_csv.hpp"
#include "core/motion/tables/trc_reader.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

/// "60_01_b.amc" may go with 60_01_b.asf, 60_01.asf or 60.asf; else with the only .asf of its folder.
Result<fs::path> skeleton_beside(const fs::path& motion) {
  std::vector<fs::path> skeletons;
  std::error_code ignored;
  const fs::path folder = motion.has_parent_path() ? motion.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (lower_case(entry.path().extension().string()) == ".asf")
      skeletons.push_back(motion.parent_path() / entry.path().filename());
  for (std::string name = motion.stem().string(); !name.empty();) {
    for (const fs::path& skeleton : skeletons)
      if (skeleton.stem() == name) return skeleton;
    const auto cut = name.rfind('_');
    name.resize(cut == std::string::npos ? 0 : cut);
  }
  if (skeletons.size() == 1) return skeletons.front();
  const std::string found = skeletons.empty() ? "there is no .asf beside it"
                                              : "none of the " + std::to_string(skeletons.size()) +
                                                    " .asf files beside it has its name";
  return Error{"an .amc needs its skeleton and " + found + "; name the .asf", motion.string(),
               Hint::NameSkeleton};
}

Result<std::vector<NamedMotion>> read_acclaim(const fs::path& file, const std::string& skeleton,
                                              std::string_view amc) {
  Result<fs::path> chosen = skeleton.empty() ? skeleton_beside(file) : Result<fs::path>(fs::path(skeleton));
  if (!chosen) return chosen.error();
  const Result<std::string> asf = read_whole_file(*chosen);
  if (!asf) return asf.error();
  Result<NamedMotion> motion = read_asf_amc(*asf, chosen->string(), amc, file.string());
  if (!motion) return motion.error();
  return std::vector<NamedMotion>{std::move(*motion)};
}

/// What a reader is given.
struct MotionFile {
  fs::path path;
  std::string skeleton;
  std::string_view bytes;
  const ImportOptions& options;
  const Progress& progress;
  std::string where() const { return path.string(); }
};

Result<std::vector<NamedMotion>> read_parameters_or_positions(const MotionFile& file) {
  if (file.options.body_model.empty()) return read_numpy(file.bytes, file.options.joint_order, file.where());
  const Result<std::string> body = read_whole_file(file.options.body_model);
  if (!body) return body.error();
  return read_numpy(file.bytes, file.options.joint_order, file.where(), {*body, file.options.body_model});
}

/// A VRM is a character: without animation it has its rest pose.
Result<std::vector<NamedMotion>> read_gltf(const MotionFile& file) {
  auto rest = rest_pose_of_vrm(file.bytes, file.where());
  if (!rest) return rest.error();
  if (*rest) return std::vector<NamedMotion>{std::move(**rest)};
  auto motions =
      read_scene_apart(file.bytes, MotionFormat::Gltf, file.where(), file.options.animation, file.progress);
  if (motions) name_by_vrm(file.bytes, *motions);
  return motions;
}

/// The reader of each format, in the order of MotionFormat.
using Read = Result<std::vector<NamedMotion>> (*)(const MotionFile& file);
constexpr std::array<Read, 10> readers = {
    [](const MotionFile& file) { return read_bvh(file.bytes, file.where()); },
    [](const MotionFile& file) { return read_acclaim(file.path, file.skeleton, file.bytes); },
    [](const MotionFile& file) -> Result<std::vector<NamedMotion>> {
      return Error{"is a skeleton without motion; name the .amc and give this file as its skeleton",
                   file.where()};
    },
    [](const MotionFile& file) { return read_c3d(file.bytes, file.where()); },
    [](const MotionFile& file) { return read_trc(file.bytes, file.where()); },
    [](const MotionFile& file) { return read_point_csv(file.bytes, file.where()); },
    [](const MotionFile& file) { return read_gltf(file); },
    [](const MotionFile& file) {
      return read_scene_apart(file.bytes, MotionFormat::Fbx, file.where(), file.options.animation,
                              file.progress);
    },
    [](const MotionFile& file) {
      return read_scene_apart(file.bytes, MotionFormat::Collada, file.where(), file.options.animation,
                              file.progress);
    },
    [](const MotionFile& file) { return read_parameters_or_positions(file); },
};

bool may_hold_animations(MotionFormat format) {
  return format == MotionFormat::Gltf || format == MotionFormat::Fbx || format == MotionFormat::Collada;
}

std::string known_formats() {
  std::string names;
  for (const MotionFormatInfo& info : motion_formats())
    if (info.format != MotionFormat::Asf) names += (names.empty() ? "" : ", ") + std::string(info.name);
  return names;
}

/// The content decides; the name where the content does not tell.
Result<MotionFormat> format_of(const MotionFile& file) {
  const auto named = format_of_name(file.where());
  if (file.bytes.empty()) return Error{"is empty; copy or export it again", file.where()};
  if (const auto found = format_of_content(file.bytes)) {
    // A .json may hold "asset" as well; only what is named like a scene or nothing known is one.
    if (named != MotionFormat::Amc || *found != MotionFormat::PointCsv) return *found;
  }
  if (const std::string foreign = foreign_kind(file.bytes, file.where()); !foreign.empty())
    return Error{foreign, file.where()};
  if (named) return *named;
  return Error{"is not a motion file that can be read; expected one of " + known_formats(), file.where()};
}

/// A sparse .npy takes no room on the disk and all of it in memory.
std::uintmax_t most_bytes_of(const std::string& file) {
  if (std::error_code failure; !fs::is_regular_file(file, failure)) return limits::whole_file_bytes;
  std::array<char, 6> head{};
  std::ifstream(file, std::ios::binary).read(head.data(), head.size());
  return std::string_view(head.data(), head.size()) == "\x93NUMPY" ? limits::npy_file_bytes
                                                                   : limits::whole_file_bytes;
}

}  // namespace

Result<std::vector<NamedMotion>> read_motion_points(const std::string& name, const std::string& skeleton,
                                                    const ImportOptions& options, const Progress& progress) {
  const Result<std::string> content = read_whole_file(name, most_bytes_of(name));
  if (!content) return content.error();
  const MotionFile file{name, skeleton, *content, options, progress};
  const Result<MotionFormat> format = format_of(file);
  if (!format) return format.error();
  if (!options.body_model.empty() && *format != MotionFormat::Numpy)
    return Error{
        "a " + std::string(name_of(*format)) + " file has its own skeleton; leave out the body model",
        file.where()};
  if (!options.animation.empty() && !may_hold_animations(*format))
    return Error{"a " + std::string(name_of(*format)) +
                     " file holds one motion without a name; leave out the animation " +
                     in_quotes(options.animation),
                 file.where()};
  Result<std::vector<NamedMotion>> motions = readers[static_cast<std::size_t>(*format)](file);
  if (!motions) return motions.error();
  // A lone performer is called like the file; several keep their names.
  if (motions->size() == 1) motions->front().name = file.path.stem().string();
  const auto named = format_of_name(name);
  for (NamedMotion& motion : *motions) {
    fill_gaps(motion);
    if (named != *format)
      motion.warnings.push_back({"format", 0,
                                 "is named " + file.path.filename().string() + " and holds " +
                                     std::string(name_of(*format)) + "; it was read as that"});
  }
  return motions;
}

}  // namespace abrazo
