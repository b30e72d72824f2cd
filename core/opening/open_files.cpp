#include "app/workbench/document/material.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "app/workbench/document/generated_material.hpp"
#include "app/workbench/document/recorded_session.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/store/normalization.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/motion/files/format_recognition.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/tables/point_csv.hpp"

namespace abrazo::app {
namespace {

enum class Kind { Library, Manifest, Motion, Skeleton, JointMap, Session, Unknown };

/// What the files are for, at most one of each.
struct Sorted {
  std::string library, manifest, motion, skeleton, joint_map, session;
};

/// A manifest lists "takes", a joint map "joints"; both are JSON.
Kind kind_of_json(const std::string& file) {
  const auto content = read_whole_file(file);
  const bool names_joints = content && content->find("\"joints\"") != std::string::npos &&
                            content->find("\"takes\"") == std::string::npos;
  return names_joints ? Kind::JointMap : Kind::Manifest;
}

/// The first lines of a file; empty when it cannot be read, such as a pipe without a writer.
std::string head_of(const std::string& file) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure)) return {};
  std::string head(65536, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return head;
}

/// What an unknown file is, as far as that is known, and what to do.
Error unknown_file(const std::string& file) {
  const std::string foreign = foreign_kind(head_of(file), file);
  if (!foreign.empty()) return Error{foreign, file};
  return Error{"not a kind of file Abrazo opens; use a motion (" + motion_file_patterns(false) +
                   "), a library (.h5), a manifest (.json) or a session (.abrazo)",
               file};
}

/// As far as the name says; a .json counts as a manifest.
Kind kind_of_name(const std::string& file) {
  const std::string extension = lower_case(std::filesystem::path(file).extension().string());
  if (extension == ".h5" || extension == ".hdf5") return Kind::Library;
  if (extension == ".json") return Kind::Manifest;
  if (extension == ".asf") return Kind::Skeleton;
  if (const auto format = format_of_name(file))
    return *format != MotionFormat::PointCsv || holds_positions(head_of(file)) ? Kind::Motion : Kind::Unknown;
  if (extension == ".abrazo") return Kind::Session;
  return Kind::Unknown;
}

Kind kind_of(const std::string& file) {
  const Kind kind = kind_of_name(file);
  return kind == Kind::Manifest ? kind_of_json(file) : kind;
}

Status check_existence(const std::string& file) {
  std::error_code trouble;
  const auto status = std::filesystem::status(file, trouble);
  if (!std::filesystem::exists(status)) return Error{"there is no such file; check its name", file};
  if (std::filesystem::is_directory(status)) return Error{"is a folder; open a file in it", file};
  return Done{};
}

Result<Sorted> sort_files(const std::vector<std::string>& files) {
  Sorted sorted;
  for (const std::string& file : files) {
    const Kind kind = kind_of(file);
    if (kind == Kind::Unknown && !std::filesystem::is_directory(file)) return unknown_file(file);
    const Status there = check_existence(file);
    if (!there) return there.error();
    std::string& place = kind == Kind::Library    ? sorted.library
                         : kind == Kind::Manifest ? sorted.manifest
                         : kind == Kind::Motion   ? sorted.motion
                         : kind == Kind::Skeleton ? sorted.skeleton
                         : kind == Kind::Session  ? sorted.session
                                                  : sorted.joint_map;
    if (!place.empty() && kind == Kind::Motion)
      return Error{
          "is a second motion, and one plays the user; open one of the two, or list both as a pair in a "
          "manifest",
          file};
    const bool libraries = kind == Kind::Library || kind == Kind::Manifest;
    if (!place.empty() || (libraries && !(sorted.library + sorted.manifest).empty()))
      return Error{"is the second of its kind; open one of the two", file};
    place = file;
  }
  if (!sorted.session.empty() && !(sorted.motion + sorted.skeleton + sorted.joint_map).empty())
    return Error{"is a session, which has its own user; open it alone, or together with its library",
                 sorted.session};
  if (sorted.motion.empty() && !(sorted.skeleton + sorted.joint_map).empty())
    return Error{"says how to read a motion; open it together with one (.amc, .bvh, ...)",
                 sorted.skeleton.empty() ? sorted.joint_map : sorted.skeleton};
  return sorted;
}

/// Without another input, a take of the library plays the user; it is not selected from then.
void take_input_from_library(Material& material) {
  material = danced_with(material, static_cast<int>(material.library->takes().size()) - 1);
}

Result<MotionLibrary> build_from(const std::string& file, const Progress& progress,
                                 std::vector<std::string>& warnings) {
  const auto manifest = read_manifest(file);
  if (!manifest) return manifest.error();
  return build_library(*manifest, {}, progress, warnings);
}

Status add_library(const Sorted& sorted, Material& material, const Progress& progress) {
  const std::string& file = sorted.library.empty() ? sorted.manifest : sorted.library;
  report(progress, 0, "Opening " + std::filesystem::path(file).filename().string());
  auto library = sorted.library.empty() ? build_from(file, progress, material.warnings) : read_library(file);
  if (!library) return library.error();
  if (library->pair_count() == 0) return Error{"has no pairs; open one with at least one take", file};
  material.library = std::make_shared<const MotionLibrary>(std::move(library).value());
  material.library_file = file;
  return Done{};
}

Status add_motion(const Sorted& sorted, const ImportOptions& said, Material& material) {
  const std::string name = std::filesystem::path(sorted.motion).filename().string();
  ImportOptions options = said;
  if (!sorted.joint_map.empty()) {
    const auto content = read_whole_file(sorted.joint_map);
    if (!content) return content.error();
    auto map = parse_joint_map(*content, sorted.joint_map);
    if (!map) return map.error();
    options.joint_map = std::move(map).value();
  }
  auto clips = load_motion(sorted.motion, sorted.skeleton, options);
  if (!clips) return Error{in_words_of_the_window(clips.error().message), clips.error().where};
  ImportedClip& first = clips->front();
  if (clips->size() > 1)
    material.warnings.push_back(name + ": has " + std::to_string(clips->size()) + " performers; the first, " +
                                first.clip.name + ", plays the user");
  for (const ImportWarning& warning : first.report.warnings)
    material.warnings.push_back(name + ": " + in_words_of_the_window(warning.detail));
  material.input = std::move(first.clip);
  material.input_files = {sorted.motion};
  for (const std::string& file : {sorted.skeleton, sorted.joint_map})
    if (!file.empty()) material.input_files.push_back(file);
  material.excluded_takes.clear();
  return Done{};
}

}  // namespace

Result<Material> load_material(const std::vector<std::string>& files, const Material& open,
                               const Progress& progress, const ImportOptions& said) {
  Material material = open;
  material.warnings.clear();
  material.recorded.reset();
  material.project.reset();
  const auto sorted = sort_files(files);
  if (!sorted) return sorted.error();
  if (!sorted->session.empty())
    return load_session(sorted->session, sorted->library + sorted->manifest, open, progress);
  const bool new_library = !(sorted->library + sorted->manifest).empty();
  const bool new_input = !sorted->motion.empty();
  if (new_input) {
    const Status added = add_motion(*sorted, said, material);
    if (!added) return added.error();
  }
  if (new_library) {
    const Status added = add_library(*sorted, material, progress);
    if (!added) return added.error();
  }
  if (!material.library) {
    auto demo = make_demo(progress);
    if (!demo) return demo.error();
    material.library = demo->library;
    material.warnings.emplace_back(
        "no library is open: a generated dance answers; open a library (.h5) or a manifest");
  }
  if (new_library && !new_input) take_input_from_library(material);
  return material;
}

bool is_motion_file(const std::string& file) {
  return kind_of_name(file) == Kind::Motion;
}

bool is_joint_map_file(const std::string& file) {
  return kind_of(file) == Kind::JointMap;
}

Material with_library(std::shared_ptr<const MotionLibrary> library, std::vector<std::string> warnings) {
  Material material;
  material.library = std::move(library);
  take_input_from_library(material);
  material.warnings.insert(material.warnings.begin(), warnings.begin(), warnings.end());
  return material;
}

Material danced_with(const Material& open, int take) {
  Material material = open;
  material.recorded.reset();
  material.project.reset();
  material.input_files.clear();
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

std::string in_words_of_the_window(std::string message) {
  for (const auto& [option, words] : {std::pair<std::string_view, std::string_view>{
                                          "(--skeleton FILE)", "(open it together with the motion)"},
                                      {"(--joint-map FILE)", "(open it together with the motion)"},
                                      {"set the unit (--metres-per-unit)", "set the unit"},
                                      {"set it with --fps", "set it if it is another"}}) {
    const auto place = message.find(option);
    if (place != std::string::npos) message.replace(place, option.size(), words);
  }
  return message;
}

Clip clip_of_take(const MotionLibrary& library, int take) {
  Clip clip;
  clip.name = library.takes()[static_cast<std::size_t>(take)].name;
  const LibraryTake& about = library.takes()[static_cast<std::size_t>(take)];
  clip.fps = about.fps / std::max(1, about.frame_stride);
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    if (static_cast<int>(source.take) != take || source.swapped) continue;
    clip.poses.push_back(to_world(library.pose(pair).topRows<joint_count>(), library.root(pair)));
  }
  return clip;
}

}  // namespace abrazo::app
