#include <array>
#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/motion/acclaim/asf_amc.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/motion/files/format_recognition.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/marker_gaps.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/numpy/numpy_reader.hpp"
#include "core/motion/scenes/assimp_scene.hpp"
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
  return Error{"an .amc needs its skeleton and " + found + "; name the .asf (--skeleton FILE)",
               motion.string()};
}

Result<std::vector<NamedMotion>> read_acclaim(const fs::path& file, const std::string& skeleton,
                                              std::string_view amc) {
  Result<fs::path> chosen = skeleton.empty() ? skeleton_beside(file) : Result<fs::path>(fs::path(skeleton));
  if (!chosen) return chosen.error();
  const Result<std::string> asf = read_whole_file(*chosen);
  if (!asf) return asf.error();
  Result<NamedMotion> motion = read_asf_amc(*asf, chosen->string(), amc, file.string());
  if (!motion) return motion.error();
  if (skeleton.empty())
    motion->warnings.push_back(
        {"skeleton", 0,
         "no skeleton was named; " + chosen->filename().string() + " beside the motion was taken"});
  return std::vector<NamedMotion>{std::move(*motion)};
}

/// What a reader is given.
struct MotionFile {
  fs::path path;
  std::string skeleton;
  std::string_view bytes;
  const std::optional<JointOrder>& order;
  const std::string& animation;
  std::string where() const { return path.string(); }
};

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
    [](const MotionFile& file) {
      return read_scene(file.bytes, MotionFormat::Gltf, file.where(), file.animation);
    },
    [](const MotionFile& file) {
      return read_scene(file.bytes, MotionFormat::Fbx, file.where(), file.animation);
    },
    [](const MotionFile& file) {
      return read_scene(file.bytes, MotionFormat::Collada, file.where(), file.animation);
    },
    [](const MotionFile& file) { return read_numpy(file.bytes, file.order, file.where()); },
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
    // Other .json files may contain "asset" too; only a file named like a scene, or with an unknown name, is
    // one.
    if (named != MotionFormat::Amc || *found != MotionFormat::PointCsv) return *found;
  }
  if (const std::string foreign = foreign_kind(file.bytes, file.where()); !foreign.empty())
    return Error{foreign, file.where()};
  if (named) return *named;
  return Error{"is not a motion file that can be read; expected one of " + known_formats(), file.where()};
}

}  // namespace

Result<std::vector<NamedMotion>> read_motion_points(const std::string& name, const std::string& skeleton,
                                                    const std::optional<JointOrder>& order,
                                                    const std::string& animation) {
  const Result<std::string> content = read_whole_file(name);
  if (!content) return content.error();
  const MotionFile file{name, skeleton, *content, order, animation};
  const Result<MotionFormat> format = format_of(file);
  if (!format) return format.error();
  if (!animation.empty() && !may_hold_animations(*format))
    return Error{"a " + std::string(name_of(*format)) +
                     " file holds one motion without a name; leave out the animation " + in_quotes(animation),
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
