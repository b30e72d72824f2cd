#include <fmt/core.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/json_text.hpp"
#include "core/base/text.hpp"
#include "core/motion/clip_csv.hpp"
#include "core/motion/import_clip.hpp"

namespace abrazo::app {

namespace {

/// What `motion info` and `motion positions` are told.
struct MotionWords {
  std::string file, skeleton, joint_map, up, output;
  double metres_per_unit = 0, fps = 0;
  int performer = 0;  ///< 1-based; 0 = the only one
  bool json = false;
};

/// CLI11's own check answers with the largest double spelled out.
const CLI::Validator above_zero(
    [](const std::string& word) {
      const auto number = parse_number(word);
      return number && *number > 0 ? std::string() : "expected a number above 0, found '" + word + "'";
    },
    "ABOVE 0");

void add_reading_options(CLI::App& command, MotionWords& words) {
  command.add_option("FILE", words.file, "motion: .bvh, or .amc with its .asf")->required();
  command.add_option("--skeleton", words.skeleton, "the .asf of an .amc");
  command.add_option("--metres-per-unit", words.metres_per_unit, "length of the file's unit")
      ->check(above_zero);
  command.add_option("--fps", words.fps, "frame rate, over what the file says")->check(above_zero);
  command.add_option("--joint-map", words.joint_map, "JSON file that says which point is which joint");
  command.add_option("--up", words.up, "the file's axis that points up")->check(CLI::IsMember({"y", "z"}));
}

Result<std::vector<ImportedClip>> load(const MotionWords& words) {
  ImportOptions options;
  if (words.metres_per_unit > 0) options.metres_per_unit = words.metres_per_unit;
  if (words.fps > 0) options.fps = words.fps;
  if (!words.up.empty()) options.up_axis = words.up == "z" ? UpAxis::Z : UpAxis::Y;
  if (!words.joint_map.empty()) {
    const Result<std::string> text = read_whole_file(words.joint_map);
    if (!text) return text.error();
    Result<JointMap> map = parse_joint_map(*text, words.joint_map);
    if (!map) return map.error();
    options.joint_map = std::move(*map);
  }
  return load_motion(words.file, words.skeleton, options);
}

const char* guess_mark(bool guessed) {
  return guessed ? " (guessed)" : "";
}

void print_performer(const ImportedClip& imported) {
  const ImportReport& report = imported.report;
  fmt::print("{}\n", imported.clip.name);
  fmt::print("  frames   {} ({:.2f} s)\n", imported.clip.poses.size(), imported.clip.duration_s());
  fmt::print("  fps      {}{}\n", exact_text(report.fps), guess_mark(report.fps_guessed));
  fmt::print("  joints   {} by the joint map '{}'\n", joint_count, report.joint_map);
  fmt::print("  unit     {} m{}\n", exact_text(report.metres_per_unit), guess_mark(report.unit_guessed));
  fmt::print("  up       {}{}\n", report.up_axis == UpAxis::Z ? 'z' : 'y',
             guess_mark(report.up_axis_guessed));
  fmt::print("  height   {:.3f} m\n", report.height_m);
  fmt::print("  floor    toe bases rest at {:.3f} m{}\n", report.floor_y_m,
             report.floor_shift_m == 0 ? "" : fmt::format("; moved by {:.3f} m", report.floor_shift_m));
  for (const ImportWarning& warning : report.warnings)
    fmt::print("  warning  {}{}: {}\n", warning.kind,
               warning.line > 0 ? fmt::format(" (line {})", warning.line) : "", warning.detail);
}

/// The fields of one performer, into an object that is open.
void put_performer(JsonText& json, const ImportedClip& imported) {
  const ImportReport& report = imported.report;
  json.key("name").value(imported.clip.name);
  json.key("frames").value(static_cast<long long>(imported.clip.poses.size()));
  json.key("fps").value(report.fps);
  json.key("duration").value(imported.clip.duration_s());
  json.key("joints").value(joint_count);
  json.key("joint_map").value(report.joint_map);
  json.key("metres_per_unit").value(report.metres_per_unit);
  json.key("up").value(report.up_axis == UpAxis::Z ? "z" : "y");
  json.key("height").value(report.height_m);
  json.key("floor").value(report.floor_y_m);
  json.key("floor_shift").value(report.floor_shift_m);
  json.key("guessed").begin_object();
  json.key("fps").value(report.fps_guessed);
  json.key("metres_per_unit").value(report.unit_guessed);
  json.key("up").value(report.up_axis_guessed);
  json.end_object();
  json.key("warnings").begin_array();
  for (const ImportWarning& warning : report.warnings) {
    json.begin_object();
    json.key("kind").value(warning.kind);
    json.key("line").value(warning.line);
    json.key("detail").value(warning.detail);
    json.end_object();
  }
  json.end_array();
}

void run_info(CommandLine& line, const MotionWords& words) {
  const Result<std::vector<ImportedClip>> clips = load(words);
  if (!clips) return fail(line, clips.error());
  if (!words.json) {
    for (const ImportedClip& imported : *clips) print_performer(imported);
    return;
  }
  // The fields of the first performer stand at the top; all performers stand in the list.
  JsonText json;
  json.begin_object();
  json.key("file").value(words.file);
  put_performer(json, clips->front());
  json.key("joint_names").begin_array();
  for (const std::string_view name : joint_names) json.value(name);
  json.end_array();
  json.key("performers").begin_array();
  for (const ImportedClip& imported : *clips) {
    json.begin_object();
    put_performer(json, imported);
    json.end_object();
  }
  json.end_array();
  json.end_object();
  fmt::print("{}\n", json.text());
}

void run_positions(CommandLine& line, const MotionWords& words) {
  const Result<std::vector<ImportedClip>> clips = load(words);
  if (!clips) return fail(line, clips.error());
  const std::size_t count = clips->size();
  if (words.performer == 0 && count > 1)
    return fail(line, {fmt::format("holds {} performers; choose one with --performer 1 to {}", count, count),
                       words.file});
  const std::size_t chosen = words.performer == 0 ? 0 : static_cast<std::size_t>(words.performer - 1);
  if (chosen >= count)
    return fail(line, {fmt::format("has no performer {}; it holds {}", words.performer, count), words.file});
  const ImportedClip& imported = (*clips)[chosen];
  const Result<std::string> csv = write_clip_csv(std::span<const Clip>(&imported.clip, 1));
  if (!csv) return fail(line, csv.error());
  const Status written = write_whole_file(words.output, *csv);
  if (!written) return fail(line, written.error());
  for (const ImportWarning& warning : imported.report.warnings)
    if (!line.quiet) fmt::print(stderr, "{}: {}: {}\n", words.file, warning.kind, warning.detail);
}

}  // namespace

void add_motion_command(CommandLine& line) {
  CLI::App* motion = line.app.add_subcommand("motion", "looks into motion files");
  motion->require_subcommand(1);
  const auto words = std::make_shared<MotionWords>();

  CLI::App* info =
      motion->add_subcommand("info", "frames, rate, joints, height, floor and everything odd about a file");
  add_reading_options(*info, *words);
  info->add_flag("--json", words->json, "one JSON object");
  info->callback([&line, words] { run_info(line, *words); });

  CLI::App* positions =
      motion->add_subcommand("positions", "world positions of the 25 joints in metres, Y up");
  add_reading_options(*positions, *words);
  positions->add_option("-o,--output", words->output, "the CSV file to write")->required();
  positions->add_option("--performer", words->performer, "which performer of a file with several, from 1")
      ->check(above_zero);
  positions->callback([&line, words] { run_positions(line, *words); });
}

}  // namespace abrazo::app
