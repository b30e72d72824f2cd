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
  if (!reading.up.empty() && reading.up != "y" && reading.up != "z")
    return Error{"'" + reading.up + "' is not an axis; use y or z", "axis that points up", Hint::SetUpAxis};
  ImportOptions options;
  options.metres_per_unit = reading.metres_per_unit;
  options.fps = reading.fps;
  if (!reading.up.empty()) options.up_axis = reading.up == "z" ? UpAxis::Z : UpAxis::Y;
  if (!reading.joint_map.empty())
    if (const Status chosen = choose_joints(reading.joint_map, options); !chosen) return chosen.error();
  if (!reading.joints.empty()) {
    auto order = find_joint_order(reading.joints);
    if (!order) return order.error();
    options.joint_order = std::move(*order);
  }
  options.animation = reading.animation;
  options.body_model = reading.body_model;
  return options;
}

/// "1 Anna, 2 Ben".
std::string who_is_there(const std::vector<ImportedClip>& clips) {
  std::string names;
  for (std::size_t c = 0; c < clips.size(); ++c)
    names += fmt::format("{}{} {}", c > 0 ? ", " : "", c + 1, printable_line(clips[c].clip.name));
  return names;
}

/// Of the clips the one that is meant by its name or its number.
Result<std::vector<ImportedClip>> only(std::vector<ImportedClip> clips, const MotionReading& reading) {
  const auto number = parse_number(reading.performer);
  for (std::size_t c = 0; c < clips.size(); ++c)
    if (clips[c].clip.name == reading.performer || (number && *number == static_cast<double>(c + 1)))
      return std::vector<ImportedClip>{std::move(clips[c])};
  return Error{
      fmt::format("has no performer {}; it holds {}", printable_line(reading.performer), who_is_there(clips)),
      reading.file};
}

}  // namespace

Result<std::vector<ImportedClip>> read_performers(const MotionReading& reading, const Progress& progress) {
  const auto options = options_of(reading);
  if (!options) return options.error();
  const auto format = format_of_name(reading.file);
  if (!reading.skeleton.empty() && format && format != MotionFormat::Amc)
    return Error{"a " + std::string(name_of(*format)) + " file has its own skeleton; leave out the other one",
                 reading.file, Hint::LeaveOutSkeleton};
  auto clips = load_motion(reading.file, reading.skeleton, *options, progress);
  if (!clips || reading.performer.empty()) return clips;
  return only(std::move(*clips), reading);
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
