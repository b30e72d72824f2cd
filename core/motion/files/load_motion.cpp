#include <algorithm>
#include <span>

#include "core/base/printable.hpp"
#include "core/base/text.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/performers.hpp"

namespace abrazo {

namespace {

/// Where the posture of the first performer leaves open which axis points up, another one's may not: who is
/// head down or lies says less than who stands.
/// @param others  performers and objects of the same file
/// @return the report of the first of them without this question; nothing if there is none
std::optional<ImportReport> without_doubt_of_axis(std::span<const NamedMotion> others,
                                                  const ImportOptions& options) {
  for (const NamedMotion& other : others)
    if (Result<ImportedClip> imported = import_clip(other, options);
        imported && !imported->report.asks_about("up-axis"))
      return std::move(imported->report);
  return std::nullopt;
}

/// Performers of one file share unit and axes: a second guess could differ from the first.
void share_space(const ImportReport& first, ImportedClip& imported) {
  imported.report.unit_guessed = first.unit_guessed;
  imported.report.up_axis_guessed = first.up_axis_guessed;
}

/// "Box (8 points)" of one that is no body; of a body why it cannot be read.
std::string why_left_out(const NamedMotion& motion, const Error& error) {
  if (!joints_are_known(motion))
    return printable_line(motion.name) + " (" + std::to_string(motion.points.size()) + " points)";
  return printable_line(motion.name) + " (" + error.message + ")";
}

/// If no performer is readable: the one with the most information.
Error nobody(const std::string& file, const std::vector<NamedMotion>& motions,
             const std::vector<Error>& errors) {
  std::size_t most = 0;
  std::vector<std::string> names;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    names.push_back(printable_line(motions[m].name) + " with " + std::to_string(motions[m].points.size()) +
                    " points");
    const bool better = joints_are_known(motions[m]) && !joints_are_known(motions[most]);
    if (better ||
        (motions[m].points.size() > motions[most].points.size() && !joints_are_known(motions[most])))
      most = m;
  }
  Error error = errors[most];
  error.where = motions.size() > 1 ? file + ": " + error.where : file;
  if (motions.size() > 1) error.message += ". The file holds " + some_of(names);
  return error;
}

}  // namespace

Result<std::vector<ImportedClip>> load_motion(const std::string& file, const std::string& skeleton,
                                              const ImportOptions& options, const Progress& progress) {
  const Result<std::vector<NamedMotion>> motions = read_motion_points(file, skeleton, options, progress);
  if (!motions) return motions.error();
  return import_performers(file, *motions, options);
}

Result<std::vector<ImportedClip>> import_performers(const std::string& file,
                                                    const std::vector<NamedMotion>& motions,
                                                    const ImportOptions& options) {
  std::vector<ImportedClip> clips;
  std::vector<Error> errors;
  std::vector<std::string> left_out;
  ImportOptions settled = options;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const NamedMotion& motion = motions[m];
    Result<ImportedClip> imported = import_clip(motion, settled);
    if (!imported) {
      errors.push_back(imported.error());
      left_out.push_back(why_left_out(motion, imported.error()));
      continue;
    }
    if (clips.empty()) {
      if (imported->report.asks_about("up-axis"))
        if (const auto sure = without_doubt_of_axis(std::span(motions).subspan(m + 1), options)) {
          settled.up_axis = sure->up_axis;
          imported = import_clip(motion, settled);
          if (!imported) return imported.error();
          imported->report.up_axis_guessed = sure->up_axis_guessed;
        }
      settled.metres_per_unit = imported->report.metres_per_unit;
      settled.up_axis = imported->report.up_axis;
    } else {
      share_space(clips.front().report, *imported);
    }
    clips.push_back(std::move(*imported));
  }
  if (clips.empty()) return nobody(file, motions, errors);
  if (!left_out.empty())
    clips.front().report.warnings.push_back(
        {"left-out", 0,
         std::to_string(left_out.size()) + " of " + std::to_string(motions.size()) +
             " in the file cannot be read as performers and were left out: " + some_of(left_out)});
  std::vector<ImportedClip*> all;
  for (ImportedClip& clip : clips) all.push_back(&clip);
  share_floor(all);
  return clips;
}

}  // namespace abrazo
