#include <algorithm>
#include <array>
#include <memory>
#include <span>

#include "app/cli/character_option.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/interruption.hpp"
#include "app/cli/motion_reading.hpp"
#include "app/cli/settings_options.hpp"
#include "core/base/line_file.hpp"
#include "core/base/output_file.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/metrics/clip_run.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/motion/scenes/character_glb.hpp"
#include "core/synthesis/frames/trace.hpp"

namespace abrazo::app {

namespace {

struct SynthOptions {
  std::string library, output, trace, character;
  MotionReading input;
  std::vector<std::string> excluded;
  SettingsOptions settings;
  bool split = false, json = false;
};

std::vector<std::string> motion_files(const SynthOptions& options) {
  if (options.output.empty()) return {};
  if (!options.split && options.character.empty()) return {options.output};
  return {with_suffix(options.output, "_active"), with_suffix(options.output, "_passive")};
}

Status write_clips(const SynthOptions& options, const std::array<Clip, 2>& clips) {
  const std::vector<std::string> files = motion_files(options);
  std::vector<std::string> contents;
  if (options.character.empty()) {
    const std::size_t clips_each = clips.size() / files.size();
    for (std::size_t i = 0; i < files.size(); ++i) {
      auto content = clip_file_content(files[i], std::span(clips).subspan(i, clips_each));
      if (!content) return content.error();
      contents.push_back(std::move(*content));
    }
  } else {
    auto performed = character_performances(options.character, clips);
    if (!performed) return performed.error();
    contents = std::move(*performed);
  }
  WholeFiles written;
  for (std::size_t i = 0; i < files.size(); ++i)
    if (const Status added = written.add(files[i], contents[i]); !added) return added;
  return written.commit();
}

/// The files that will be written, asked before the work.
Status check_outputs(const SynthOptions& options) {
  const std::vector<std::string> inputs = {options.library, options.input.file, options.input.skeleton,
                                           options.input.joint_map, options.character};
  if (!options.output.empty()) {
    const Status known = options.character.empty()
                             ? check_clip_file(options.output, {}, options.split ? 1 : 2)
                             : check_character_file(options.output);
    if (!known) return known;
  }
  std::vector<std::string> outputs = motion_files(options);
  if (!options.trace.empty()) {
    if (std::find(outputs.begin(), outputs.end(), options.trace) != outputs.end())
      return Error{"the trace and the motion cannot share a file; name two", options.trace};
    outputs.push_back(options.trace);
  }
  for (const std::string& output : outputs)
    if (const Status usable = check_output(output, inputs); !usable) return usable;
  return Done{};
}

Status write_outputs(const SynthOptions& options, const ClipRun& run, LineFile* trace) {
  if (interrupted()) return Error{"cancelled", options.input.file};
  if (trace)
    if (const Status finished = trace->finish(); !finished) return finished;
  if (!options.output.empty()) return write_clips(options, {run.active, run.passive});
  return Done{};
}

Status run_synth(CommandLine& line, const SynthOptions& options) {
  if (const Status usable = check_outputs(options); !usable) return usable;
  const auto settings = options.settings.read();
  if (!settings) return settings.error();
  auto library_file = read_library(options.library);
  if (!library_file) return library_file.error();
  const auto library = std::make_shared<const MotionLibrary>(std::move(*library_file));
  const auto input = read_performer(line, options.input);
  if (!input) return input.error();
  auto synthesizer = PartnerSynthesizer::create(library, *settings, options.excluded);
  if (!synthesizer) return synthesizer.error();

  std::unique_ptr<LineFile> trace;
  if (!options.trace.empty()) {
    auto opened = LineFile::open(options.trace);
    if (!opened) return opened.error();
    trace = std::move(*opened);
    const double rate = clip_step_rate(input->clip, *settings);
    trace->add(trace_header_line({options.library, options.input.file, rate, *settings}));
  }
  const auto add_to_trace = [&](const ClipStep& step) {
    if (trace) trace->add(trace_frame_line(step.result, *library, step.input_frame, step.time_s));
  };
  const auto run = run_clip(**synthesizer, input->clip, add_to_trace, terminal_progress(line));
  if (!run) return run.error();
  if (const Status written = write_outputs(options, *run, trace.get()); !written) return written;
  if (options.json)
    answer_json(line, run->summary.json(run->rate_hz()));
  else if (!line.quiet)
    answer(line, run->summary.text(run->rate_hz()));
  return Done{};
}

}  // namespace

void add_synth_command(CommandLine& line) {
  auto options = std::make_shared<SynthOptions>();
  CLI::App* synth = line.app.add_subcommand(
      "synth", "a recorded user in, both characters out: the whole pipeline, as fast as possible");
  synth->add_option("--library", options->library, "motion library (abrazo library build)")
      ->required()
      ->type_name("LIB");
  synth->add_option("--input", options->input.file, "the user's motion: .bvh, or .amc with its .asf")
      ->required()
      ->type_name("FILE");
  add_reading_options(*synth, options->input);
  synth->add_option("--exclude", options->excluded, "a take that is never selected; may be repeated")
      ->expected(1)
      ->allow_extra_args(false)  // otherwise it also takes the words that follow
      ->take_all()
      ->type_name("TAKE");
  CLI::Option* output =
      synth
          ->add_option("-o,--output", options->output,
                       "both characters at the step rate: .bvh (two roots), .glb, .csv, .npz")
          ->type_name("FILE");
  synth->add_flag("--split", options->split, "two files instead: OUT_active and OUT_passive")->needs(output);
  add_character_option(*synth, options->character, output, "OUT_active and OUT_passive");
  synth
      ->add_option("--trace", options->trace,
                   "one JSON object per solved step, with all intermediate results (JSON lines)")
      ->type_name("FILE");
  synth->add_flag("--json", options->json, "the summary as one JSON object on stdout");
  options->settings.add_to(*synth);
  synth->callback([&line, options] {
    if (const Status done = run_synth(line, *options); !done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
