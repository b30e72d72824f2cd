#include "core/base/text.hpp"
#include "core/motion/files/import_clip.hpp"

namespace abrazo {

namespace {

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
  const Result<std::vector<NamedMotion>> motions = read_motion_points(file, skeleton, options.joint_order);
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
