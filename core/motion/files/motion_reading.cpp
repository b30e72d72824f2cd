#include "core/motion/files/motion_reading.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "core/base/printable.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/joint_order.hpp"
#include "core/motion/joints/motion_format.hpp"

namespace abrazo {

namespace {

Status check_above_zero(std::optional<double> number, const char* name, Hint hint) {
  if (!number || (std::isfinite(*number) && *number > 0)) return Done{};
  return Error{"expected a number above 0, found '" + exact_text(*number) + "'", name, hint};
}

Result<ImportOptions> options_of(const MotionReading& reading) {
  if (const Status usable = check_above_zero(reading.metres_per_unit, "metres per unit", Hint::SetUnit);
      !usable)
    return usable.error();
  if (const Status usable = check_above_zero(reading.fps, "frame rate", Hint::SetFrameRate); !usable)
    return usable.error();
  if (reading.floor_m && !std::isfinite(*reading.floor_m))
    return Error{"expected a finite number of metres", "height of the floor"};
  const auto up = find_up_axis(reading.up);
  if (!reading.up.empty() && !up)
    return Error{"'" + reading.up + "' is not an axis; use " + up_axis_names(), "axis that points up",
                 Hint::SetUpAxis};
  ImportOptions options;
  options.metres_per_unit = reading.metres_per_unit;
  options.fps = reading.fps;
  options.up_axis = up;
  if (!reading.joint_map.empty())
    if (const Status chosen = choose_joints(reading.joint_map, options); !chosen) return chosen.error();
  if (!reading.joints.empty()) {
    auto order = find_joint_order(reading.joints);
    if (!order) return order.error();
    options.joint_order = std::move(*order);
  }
  options.animation = reading.animation;
  options.body_model = reading.body_model;
  options.floor_m = reading.floor_m;
  return options;
}

/// "1 Anna, 2 Ben".
std::string who_is_there(const std::vector<ImportedClip>& clips) {
  std::string names;
  for (std::size_t c = 0; c < clips.size(); ++c)
    names += fmt::format("{}{} {}", c > 0 ? ", " : "", c + 1, printable_line(clips[c].clip.name));
  return names;
}

}  // namespace

std::optional<std::size_t> find_performer(const std::vector<ImportedClip>& clips, const std::string& wanted) {
  const auto number = parse_number(wanted);
  for (std::size_t c = 0; c < clips.size(); ++c)
    if (clips[c].clip.name == wanted || (number && *number == static_cast<double>(c + 1))) return c;
  return std::nullopt;
}

Status MotionPoints::read(const MotionReading& reading, const ImportOptions& options,
                          const Progress& progress) {
  MotionReading wanted;
  wanted.file = reading.file, wanted.skeleton = reading.skeleton, wanted.joints = reading.joints;
  wanted.animation = reading.animation, wanted.body_model = reading.body_model;
  if (!motions_.empty() && wanted == read_) return Done{};
  motions_.clear();
  auto motions = read_motion_points(reading.file, reading.skeleton, options, progress);
  if (!motions) return motions.error();
  motions_ = std::move(*motions);
  read_ = std::move(wanted);
  return Done{};
}

Result<std::vector<ImportedClip>> MotionPoints::performers(const MotionReading& reading,
                                                           const Progress& progress) {
  const auto options = options_of(reading);
  if (!options) return options.error();
  const auto format = format_of_name(reading.file);
  if (!reading.skeleton.empty() && format && format != MotionFormat::Amc)
    return Error{"a " + std::string(name_of(*format)) + " file has its own skeleton; leave out the other one",
                 reading.file, Hint::LeaveOutSkeleton};
  if (const Status done = read(reading, *options, progress); !done) return done.error();
  auto clips = import_performers(reading.file, motions_, *options);
  if (!clips || reading.performer.empty()) return clips;
  if (const auto found = find_performer(*clips, reading.performer))
    return std::vector<ImportedClip>{std::move((*clips)[*found])};
  return Error{fmt::format("has no performer {}; it holds {}", printable_line(reading.performer),
                           who_is_there(*clips)),
               reading.file};
}

Result<std::vector<ImportedClip>> read_performers(const MotionReading& reading, const Progress& progress) {
  return MotionPoints().performers(reading, progress);
}

Result<ImportedClip> read_performer(const MotionReading& reading, const Progress& progress) {
  Result<std::vector<ImportedClip>> clips = read_performers(reading, progress);
  if (!clips) return clips.error();
  if (clips->size() > 1)
    return Error{fmt::format("holds {} performers: {}; choose one", clips->size(), who_is_there(*clips)),
                 reading.file, Hint::ChoosePerformer};
  return std::move(clips->front());
}

std::vector<Warning> warnings_of_import(const MotionReading& reading, const ImportedClip& imported) {
  std::vector<Warning> sentences;
  for (const ImportWarning& warning : imported.report.warnings)
    sentences.push_back(
        {fmt::format("{}{}: {}: {}", reading.file, warning.line > 0 ? fmt::format(":{}", warning.line) : "",
                     warning.kind, warning.detail),
         warning.hint});
  return sentences;
}

}  // namespace abrazo
