#include <fmt/core.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "app/cli/hint_words.hpp"
#include "app/cli/interruption.hpp"
#include "app/cli/motion_reading.hpp"
#include "app/cli/text_lines.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/json_text.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/tables/clip_csv.hpp"

namespace abrazo::app {

namespace {

/// Options of `motion info`, `motion positions` and `motion convert`.
struct MotionWords {
  MotionReading reading;
  WrittenSpace space;
  std::string output;
  bool json = false;
};

void add_file(CLI::App& command, MotionWords& words) {
  command
      .add_option("FILE", words.reading.file,
                  "motion: .bvh, .amc with its .asf, .c3d, .trc, .csv, .glb, .fbx, .dae, .npy, .npz")
      ->required()
      ->type_name("");
  add_reading_options(command, words.reading);
}

const char* guess_mark(bool guessed) {
  return guessed ? " (guessed)" : "";
}

void add_performer(TextLines& text, const ImportedClip& imported) {
  const ImportReport& report = imported.report;
  text.add("{}", imported.clip.name);
  text.add("  frames   {} ({:.2f} s)", imported.clip.poses.size(), imported.clip.duration_s());
  text.add("  fps      {}{}", exact_text(report.fps), guess_mark(report.fps_guessed));
  text.add("  joints   {} by the joint map '{}'", joint_count, report.joint_map);
  text.add("  unit     {} m{}", exact_text(report.metres_per_unit), guess_mark(report.unit_guessed));
  text.add("  up       {}{}", name_of(report.up_axis), guess_mark(report.up_axis_guessed));
  text.add("  height   {:.3f} m to the head joint", report.height_m);
  text.add("  floor    toe bases rest at {:.3f} m{}", report.floor_y_m,
           report.floor_shift_m == 0 ? "" : fmt::format("; moved by {:.3f} m", report.floor_shift_m));
  if (report.animations.size() > 1) text.add("  animations {}", some_of(report.animations, 40));
  for (const ImportWarning& warning : report.warnings)
    text.add("  warning  {}{}: {}", warning.kind,
             warning.line > 0 ? fmt::format(" (line {})", warning.line) : "",
             warning.detail + std::string(option_words(warning.hint)));
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
  json.key("up").value(name_of(report.up_axis));
  json.key("height").value(report.height_m);
  json.key("floor").value(report.floor_y_m);
  json.key("floor_shift").value(report.floor_shift_m);
  json.key("guessed").begin_object();
  json.key("fps").value(report.fps_guessed);
  json.key("metres_per_unit").value(report.unit_guessed);
  json.key("up").value(report.up_axis_guessed);
  json.end_object();
  json.key("animations").begin_array();
  for (const std::string& animation : report.animations) json.value(animation);
  json.end_array();
  json.key("warnings").begin_array();
  for (const ImportWarning& warning : report.warnings) {
    json.begin_object();
    json.key("kind").value(warning.kind);
    json.key("line").value(warning.line);
    json.key("detail").value(warning.detail + std::string(option_words(warning.hint)));
    json.end_object();
  }
  json.end_array();
}

void run_info(CommandLine& line, const MotionWords& words) {
  const Result<std::vector<ImportedClip>> clips = read_performers(words.reading, until_interrupted);
  if (!clips) return fail(line, clips.error());
  if (!words.json) {
    TextLines text;
    for (const ImportedClip& imported : *clips) add_performer(text, imported);
    return answer(line, text.take());
  }
  // The fields of the first performer are at the top level; the list has all performers.
  JsonText json;
  json.begin_object();
  json.key("file").value(words.reading.file);
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
  answer_json(line, json.text());
}

void run_positions(CommandLine& line, const MotionWords& words) {
  if (const Status usable = check_output(words.output, {words.reading.file, words.reading.skeleton}); !usable)
    return fail(line, usable.error());
  const Result<ImportedClip> imported = read_performer(line, words.reading);
  if (!imported) return fail(line, imported.error());
  const Result<std::string> csv = write_clip_csv(std::span<const Clip>(&imported->clip, 1));
  if (!csv) return fail(line, csv.error());
  if (interrupted()) return fail(line, {"cancelled", words.output});
  if (const Status written = write_whole_file(words.output, *csv); !written) fail(line, written.error());
}

Result<std::vector<Clip>> clips_to_convert(CommandLine& line, const MotionWords& words) {
  auto all = read_performers(words.reading, until_interrupted);
  if (!all) return all.error();
  std::vector<Clip> clips;
  for (ImportedClip& imported : *all) {
    warn_of_import(line, words.reading, imported);
    clips.push_back(std::move(imported.clip));
  }
  return clips;
}

void run_convert(CommandLine& line, const MotionWords& words) {
  const auto space = file_space(words.space);
  if (!space) return fail(line, space.error());
  if (const Status known = check_clip_file(words.output, *space); !known) return fail(line, known.error());
  const std::vector<std::string> inputs = {words.reading.file, words.reading.skeleton,
                                           words.reading.joint_map};
  if (const Status usable = check_output(words.output, inputs); !usable) return fail(line, usable.error());
  const auto clips = clips_to_convert(line, words);
  if (!clips) return fail(line, clips.error());
  if (interrupted()) return fail(line, {"cancelled", words.output});
  if (const Status written = write_clip_file(words.output, *clips, *space); !written)
    return fail(line, written.error());
  if (!line.quiet)
    answer(line, fmt::format("{}: {} of {} frames at {} Hz\n", words.output,
                             clips->size() == 1 ? "a body" : fmt::format("{} bodies", clips->size()),
                             clips->front().poses.size(), exact_text(clips->front().fps)));
}

}  // namespace

void add_motion_command(CommandLine& line) {
  CLI::App* motion = line.app.add_subcommand("motion", "show and convert motion files");
  motion->require_subcommand(1);

  const auto info_words = std::make_shared<MotionWords>();
  CLI::App* info =
      motion->add_subcommand("info", "frames, rate, joints, height, floor and warnings about a file");
  add_file(*info, *info_words);
  info->add_flag("--json", info_words->json, "one JSON object on stdout");
  info->callback([&line, info_words] { run_info(line, *info_words); });

  const auto words = std::make_shared<MotionWords>();
  CLI::App* positions =
      motion->add_subcommand("positions", "write the world positions of the 25 joints, in metres, Y up");
  add_file(*positions, *words);
  positions->add_option("-o,--output", words->output, "the CSV file to write")->required()->type_name("CSV");
  positions->callback([&line, words] { run_positions(line, *words); });

  const auto convert_words = std::make_shared<MotionWords>();
  CLI::App* convert = motion->add_subcommand(
      "convert", "write the 25 joints of all performers, or of one, as another motion file");
  add_file(*convert, *convert_words);
  convert->add_option("-o,--output", convert_words->output, "the .bvh, .glb, .csv, .npz or .npy to write")
      ->required()
      ->type_name("FILE");
  add_space_options(*convert, convert_words->space);
  convert->callback([&line, convert_words] { run_convert(line, *convert_words); });
}

}  // namespace abrazo::app
