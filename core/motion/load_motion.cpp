#include <algorithm>
#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/motion/asf_amc.hpp"
#include "core/motion/bvh.hpp"
#include "core/motion/import_clip.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

std::string extension_of(const fs::path& path) {
  return lower_case(path.extension().string());
}

/// "60_01_b.amc" may go with 60_01_b.asf, 60_01.asf or 60.asf; else with the only .asf of its folder.
Result<fs::path> skeleton_beside(const fs::path& motion) {
  std::vector<fs::path> skeletons;
  std::error_code ignored;
  const fs::path folder = motion.has_parent_path() ? motion.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (extension_of(entry.path()) == ".asf")
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

Result<std::vector<NamedMotion>> read_motions(const fs::path& file, const std::string& skeleton) {
  Result<std::string> text = read_whole_file(file);
  if (!text) return text.error();
  const std::string extension = extension_of(file);
  if (extension == ".amc") return read_acclaim(file, skeleton, *text);
  if (extension == ".bvh") {
    Result<std::vector<NamedMotion>> motions = read_bvh(*text, file.string());
    // A lone performer is called like the file; several keep the names of their roots.
    if (motions && motions->size() == 1) motions->front().name = file.stem().string();
    return motions;
  }
  if (extension == ".asf")
    return Error{"is a skeleton without motion; name the .amc and give this file as its skeleton",
                 file.string()};
  return Error{"is not a motion file that can be read; expected .bvh, or .amc with its .asf", file.string()};
}

/// Performers of one file stand on one floor: what one must be moved by, all are.
void share_floor(std::vector<ImportedClip>& clips) {
  double shift = 0;
  for (const ImportedClip& imported : clips)
    if (shift == 0) shift = imported.report.floor_shift_m;
  for (ImportedClip& imported : clips) {
    const double correction = shift - imported.report.floor_shift_m;
    if (correction == 0) continue;
    for (Pose& pose : imported.clip.poses) pose.col(1).array() += correction;
    imported.report.floor_shift_m = shift;
    imported.report.warnings.push_back(
        {"floor", 0, "moved by " + exact_text(shift) + " m with the other performer of the file"});
  }
}

}  // namespace

Result<std::vector<ImportedClip>> load_motion(const std::string& file, const std::string& skeleton,
                                              const ImportOptions& options) {
  const Result<std::vector<NamedMotion>> motions = read_motions(file, skeleton);
  if (!motions) return motions.error();
  std::vector<ImportedClip> clips;
  ImportOptions settled = options;
  for (const NamedMotion& motion : *motions) {
    Result<ImportedClip> imported = import_clip(motion, settled);
    if (!imported) {
      Error error = imported.error();
      error.where = motions->size() > 1 ? file + ": " + error.where : file;
      return error;
    }
    if (clips.empty()) {
      // Performers of one file share unit and axes; a second guess could differ from the first.
      settled.metres_per_unit = imported->report.metres_per_unit;
      settled.up_axis = imported->report.up_axis;
    } else {
      imported->report.unit_guessed = clips.front().report.unit_guessed;
      imported->report.up_axis_guessed = clips.front().report.up_axis_guessed;
    }
    clips.push_back(std::move(*imported));
  }
  share_floor(clips);
  return clips;
}

}  // namespace abrazo
