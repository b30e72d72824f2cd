#include "app/cli/motion_reading.hpp"

#include <fmt/core.h>

#include "core/base/text.hpp"
#include "core/motion/joints/motion_format.hpp"

namespace abrazo::app {

void add_reading_options(CLI::App& command, MotionReading& reading) {
  command.add_option("--skeleton", reading.skeleton, "the .asf of an .amc")->type_name("ASF");
  command
      .add_option("--metres-per-unit", reading.metres_per_unit,
                  "length of the file's unit; by default from the file or guessed")
      ->check(above_zero)
      ->type_name("METRES");
  command.add_option("--fps", reading.fps, "frame rate, overrides the file")
      ->check(above_zero)
      ->type_name("HZ");
  command
      .add_option("--joint-map", reading.joint_map,
                  "which point is which joint: a built-in map or marker model, or a JSON file")
      ->type_name("NAME|JSON");
  command.add_option("--up", reading.up, "the file's axis that points up")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("AXIS");
  command.add_option("--performer", reading.performer, "which performer of a file with several")
      ->type_name("N|NAME");
  command
      .add_option("--animation", reading.animation,
                  "which animation of a file with several; by default the longest")
      ->type_name("NAME");
}

namespace {

/// "1 Anna, 2 Ben".
std::string who_is_there(const std::vector<ImportedClip>& clips) {
  std::string names;
  for (std::size_t c = 0; c < clips.size(); ++c)
    names += fmt::format("{}{} {}", c > 0 ? ", " : "", c + 1, clips[c].clip.name);
  return names;
}

/// Of the clips the one that is meant by its number or its name.
Result<std::vector<ImportedClip>> only(std::vector<ImportedClip> clips, const MotionReading& reading) {
  const auto number = parse_number(reading.performer);
  for (std::size_t c = 0; c < clips.size(); ++c)
    if (clips[c].clip.name == reading.performer || (number && *number == static_cast<double>(c + 1)))
      return std::vector<ImportedClip>{std::move(clips[c])};
  return Error{fmt::format("has no performer {}; it holds {}", reading.performer, who_is_there(clips)),
               reading.file};
}

}  // namespace

Result<std::vector<ImportedClip>> read_performers(const MotionReading& reading) {
  ImportOptions options;
  if (reading.metres_per_unit > 0) options.metres_per_unit = reading.metres_per_unit;
  if (reading.fps > 0) options.fps = reading.fps;
  if (!reading.up.empty()) options.up_axis = reading.up == "z" ? UpAxis::Z : UpAxis::Y;
  if (!reading.joint_map.empty())
    if (const Status chosen = choose_joints(reading.joint_map, options); !chosen) return chosen.error();
  const auto format = format_of_name(reading.file);
  if (!reading.skeleton.empty() && format && format != MotionFormat::Amc)
    return Error{"a " + std::string(name_of(*format)) + " file has its own skeleton; leave out --skeleton",
                 reading.file};
  options.animation = reading.animation;
  auto clips = load_motion(reading.file, reading.skeleton, options);
  if (!clips || reading.performer.empty()) return clips;
  return only(std::move(*clips), reading);
}

Result<ImportedClip> read_performer(CommandLine& line, const MotionReading& reading) {
  Result<std::vector<ImportedClip>> clips = read_performers(reading);
  if (!clips) return clips.error();
  if (clips->size() > 1)
    return Error{fmt::format("holds {} performers; choose one with --performer: {}", clips->size(),
                             who_is_there(*clips)),
                 reading.file};
  ImportedClip& imported = clips->front();
  warn_of_import(line, reading, imported);
  return std::move(imported);
}

void warn_of_import(CommandLine& line, const MotionReading& reading, const ImportedClip& imported) {
  for (const ImportWarning& warning : imported.report.warnings)
    warn(line,
         fmt::format("{}{}: {}: {}", reading.file, warning.line > 0 ? fmt::format(":{}", warning.line) : "",
                     warning.kind, warning.detail));
}

void add_space_options(CLI::App& command, std::string& units, std::string& up) {
  command.add_option("--out-units", units, "unit of the written .bvh or .csv; by default metres")
      ->check(CLI::IsMember({"m", "cm", "mm"}))
      ->type_name("UNIT");
  command.add_option("--out-up", up, "axis that points up in the written .bvh or .csv; by default y")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("AXIS");
}

ClipFileSpace file_space(const std::string& units, const std::string& up) {
  return {units == "cm" ? 100.0 : units == "mm" ? 1000.0 : 1.0, up == "z" ? UpAxis::Z : UpAxis::Y};
}

}  // namespace abrazo::app
