#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>

#include "app/cli/command_line.hpp"
#include "app/cli/settings_options.hpp"
#include "core/base/atomic_file.hpp"
#include "core/library/motion_library_file.hpp"
#include "core/motion/bvh.hpp"
#include "core/motion/clip_csv.hpp"
#include "core/motion/import_clip.hpp"
#include "core/synthesis/clip_synthesis.hpp"
#include "core/synthesis/run_summary.hpp"
#include "core/synthesis/trace.hpp"

namespace abrazo::app {

namespace {

struct SynthOptions {
  std::string library, input, skeleton, output, trace, joint_map;
  double metres_per_unit = 0, fps = 0;
  std::vector<std::string> excluded;
  SettingsOptions settings;
  bool split = false, json = false;
};

/// Writes trace lines to a file that appears whole at the end.
class TraceFile {
 public:
  static Result<std::unique_ptr<TraceFile>> open(const std::string& path, const TraceHeader& header) {
    auto trace = std::unique_ptr<TraceFile>(new TraceFile(path));
    if (!trace->out_) return Error{"cannot be created; choose a folder that exists and can be written", path};
    trace->out_ << trace_header_line(header) << '\n';
    return trace;
  }
  void add(const std::string& line) { out_ << line << '\n'; }
  Status finish() {
    out_.close();
    if (!out_) return Error{"could not be written whole; is the disk full?", path_};
    return file_.commit();
  }

 private:
  explicit TraceFile(const std::string& path)
      : path_(path), file_(path), out_(file_.partial(), std::ios::binary) {}
  std::string path_;
  AtomicFile file_;
  std::ofstream out_;
};

std::string with_suffix(const std::string& path, const std::string& suffix) {
  const auto dot = path.find_last_of('.');
  return path.substr(0, dot) + suffix + path.substr(dot);
}

Result<std::string> clip_file_text(const std::string& path, std::span<const Clip> clips) {
  if (path.ends_with(".bvh")) return write_bvh(clips);
  return write_clip_csv(clips);
}

Status write_clips(const SynthOptions& options, const Clip& active, const Clip& passive) {
  const auto write = [](const std::string& path, std::span<const Clip> clips) -> Status {
    const auto text = clip_file_text(path, clips);
    if (!text) return text.error();
    return write_whole_file(path, *text);
  };
  if (!options.split) return write(options.output, std::array<Clip, 2>{active, passive});
  const Status first = write(with_suffix(options.output, "_active"), std::array<Clip, 1>{active});
  if (!first) return first;
  return write(with_suffix(options.output, "_passive"), std::array<Clip, 1>{passive});
}

Result<ImportedClip> load_input(const SynthOptions& options) {
  ImportOptions import;
  if (options.metres_per_unit > 0) import.metres_per_unit = options.metres_per_unit;
  if (options.fps > 0) import.fps = options.fps;
  if (!options.joint_map.empty()) {
    const auto text = read_whole_file(options.joint_map);
    if (!text) return text.error();
    auto map = parse_joint_map(*text, options.joint_map);
    if (!map) return map.error();
    import.joint_map = std::move(*map);
  }
  auto clips = load_motion(options.input, options.skeleton, import);
  if (!clips) return clips.error();
  if (clips->size() > 1)
    fmt::print(stderr, "abrazo: {}: has {} performers; '{}' is taken as the user\n", options.input,
               clips->size(), clips->front().clip.name);
  return std::move(clips->front());
}

Status check_output(const SynthOptions& options) {
  if (options.output.empty() || options.output.ends_with(".bvh") || options.output.ends_with(".csv"))
    return Done{};
  return Error{"this file type cannot be written; use .bvh or .csv", options.output};
}

Status run(const CommandLine& line, const SynthOptions& options) {
  if (const Status usable = check_output(options); !usable) return usable;
  const auto settings = options.settings.read();
  if (!settings) return settings.error();
  auto library_file = read_library(options.library);
  if (!library_file) return library_file.error();
  const auto library = std::make_shared<const MotionLibrary>(std::move(*library_file));
  const auto input = load_input(options);
  if (!input) return input.error();
  if (!line.quiet)
    for (const ImportWarning& warning : input->report.warnings)
      fmt::print(stderr, "abrazo: {}: {}: {}\n", options.input, warning.kind, warning.detail);
  const Clip& clip = input->clip;
  auto synthesizer = PartnerSynthesizer::create(library, *settings, options.excluded);
  if (!synthesizer) return synthesizer.error();

  const double rate = clip_step_rate(clip, *settings);
  std::unique_ptr<TraceFile> trace;
  if (!options.trace.empty()) {
    auto opened = TraceFile::open(options.trace, {options.library, options.input, rate, *settings});
    if (!opened) return opened.error();
    trace = std::move(*opened);
  }
  Clip active{"active", rate, {}};
  Clip passive{"passive", rate, {}};
  RunSummary summary(*library);
  const Status stepped = synthesize_clip(
      **synthesizer, clip,
      [&](const ClipStep& step) -> Status {
        if (trace) trace->add(trace_frame_line(step.result, *library, step.input_frame, step.time_s));
        active.poses.emplace_back(step.result.active());
        passive.poses.emplace_back(step.result.passive());
        summary.add(step.result);
        return Done{};
      },
      terminal_progress(line));
  if (!stepped) return stepped;
  if (trace)
    if (const Status finished = trace->finish(); !finished) return finished;
  if (!options.output.empty())
    if (const Status written = write_clips(options, active, passive); !written) return written;
  if (options.json)
    fmt::print("{}\n", summary.json(rate));
  else if (!line.quiet)
    fmt::print("{}", summary.text(rate));
  return Done{};
}

}  // namespace

void add_synth_command(CommandLine& line) {
  auto options = std::make_shared<SynthOptions>();
  CLI::App* synth = line.app.add_subcommand(
      "synth", "A recorded user in, both characters out: the whole pipeline, as fast as it goes");
  synth->add_option("--library", options->library, "motion library (abrazo library build)")->required();
  synth->add_option("--input", options->input, "the user's motion: .bvh or .amc")->required();
  synth->add_option("--skeleton", options->skeleton, ".asf of an .amc input");
  synth->add_option("--metres-per-unit", options->metres_per_unit,
                    "length unit of the input; guessed and reported when not given");
  synth->add_option("--fps", options->fps,
                    "frame rate of the input, where the file does not say or is wrong");
  synth->add_option("--joint-map", options->joint_map,
                    "JSON joint map, where none of the built-in ones fits");
  synth->add_option("--exclude", options->excluded, "a take that must not be selected; may be repeated");
  synth->add_option("-o", options->output, "both characters: .bvh (two roots) or .csv, at the step rate");
  synth->add_flag("--split", options->split, "two files instead: OUT_active and OUT_passive");
  synth->add_option("--trace", options->trace,
                    "one JSON object per solved step, with every reason (JSON lines)");
  synth->add_flag("--json", options->json, "the summary as one JSON object on stdout");
  options->settings.add_to(*synth);
  synth->callback([&line, options] {
    const Status done = run(line, *options);
    if (!done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
