#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <optional>

#include "app/cli/character_output.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/interruption.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/json_text.hpp"
#include "core/base/line_file.hpp"
#include "core/base/output_file.hpp"
#include "core/base/statistics.hpp"
#include "core/bodies/chosen_body.hpp"
#include "core/bodies/pair_retargeting.hpp"
#include "core/bodies/retargeted_frame.hpp"
#include "core/evaluation/run/library_takes.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/synthesis/frames/recording_trace.hpp"
#include "core/synthesis/frames/trace.hpp"

namespace abrazo::app {

namespace {

struct RetargetArguments {
  std::string library, manifest, output, trace;
  std::vector<std::string> takes;
  long long from = 0;
  std::optional<long long> to;
  std::string active_body = "library", passive_body = "library";
  CharacterOutput character;
  bool json = false;

  const std::string& source() const { return library.empty() ? manifest : library; }
  /// Of several takes each has files of its own.
  std::string file_of(const std::string& path, const std::string& take) const {
    return takes.size() == 1 ? path : with_suffix(path, "_" + take);
  }
};

struct Choices {
  BodyChoice active, passive;
};

Result<Choices> read_choices(const RetargetArguments& arguments) {
  auto active = parse_body_choice(arguments.active_body);
  if (!active) return active.error();
  auto passive = parse_body_choice(arguments.passive_body);
  if (!passive) return passive.error();
  return Choices{std::move(*active), std::move(*passive)};
}

Status check_outputs(const RetargetArguments& arguments, const Choices& choices) {
  std::vector<std::string> inputs = {arguments.source()};
  for (const BodyChoice* choice : {&choices.active, &choices.passive})
    if (!choice->file.empty()) inputs.push_back(choice->file);
  if (arguments.character.is_given()) inputs.push_back(arguments.character.file());
  const Status known = arguments.character.is_given() ? arguments.character.check(arguments.output)
                                                      : check_clip_file(arguments.output, {}, 2);
  if (!known) return known;
  for (const std::string& take : arguments.takes) {
    const std::string output = arguments.file_of(arguments.output, take);
    std::vector<std::string> files = {output};
    if (arguments.character.is_given()) {
      const auto both = arguments.character.outputs(output);
      files.assign(both.begin(), both.end());
    }
    for (const std::string& file : files)
      if (const Status usable = check_output(file, inputs); !usable) return usable;
    if (arguments.trace.empty()) continue;
    const std::string trace = arguments.file_of(arguments.trace, take);
    if (trace == output) return Error{"the trace and the motion cannot share a file; name two", trace};
    if (const Status usable = check_output(trace, inputs); !usable) return usable;
  }
  return Done{};
}

template <typename Takes>
Error unknown_take(const std::string& name, const Takes& takes, const std::string& source) {
  std::vector<std::string> names;
  for (const auto& take : takes) names.push_back(take.name);
  return {fmt::format("has no take {}; there are {}", name, fmt::join(names, ", ")), source};
}

Result<std::vector<PairedTake>> takes_of_manifest(CommandLine& line, const RetargetArguments& arguments,
                                                  const Progress& progress) {
  const auto manifest = read_manifest(arguments.manifest);
  if (!manifest) return manifest.error();
  std::vector<const Manifest::Take*> wanted;
  for (const std::string& name : arguments.takes) {
    const auto found = std::ranges::find(manifest->takes, name, &Manifest::Take::name);
    if (found == manifest->takes.end()) return unknown_take(name, manifest->takes, arguments.manifest);
    wanted.push_back(&*found);
  }
  std::vector<PairedTake> takes;
  std::vector<std::string> warnings = manifest->warnings;
  for (const Manifest::Take* entry : wanted) {
    auto take = load_take(*entry, warnings, progress);
    if (!take) return take.error();
    takes.push_back(std::move(*take));
  }
  for (const std::string& warning : warnings) warn(line, warning);
  return takes;
}

Result<std::vector<PairedTake>> takes_of_library_file(const RetargetArguments& arguments) {
  const auto library = read_library(arguments.library);
  if (!library) return library.error();
  auto all = takes_of_library(*library);
  if (!all) return all.error();
  std::vector<PairedTake> takes;
  for (const std::string& name : arguments.takes) {
    const auto found = std::ranges::find(*all, name, &PairedTake::name);
    if (found == all->end()) return unknown_take(name, *all, arguments.library);
    takes.push_back(*found);
  }
  return takes;
}

/// What was made of one take, and how it is named.
struct Made {
  RetargetedPair pair;
  ChosenBody active, passive;
};

Result<Made> make(const RetargetArguments& arguments, const Choices& choices, const PairedTake& take,
                  const Progress& progress) {
  const RecordedPair whole = recorded_pair_of(take);
  // Bodies are measured over the whole take, so that a part of it gets the same.
  const Body active = body_of(whole.active.poses), passive = body_of(whole.passive.poses);
  auto part_of_take = cut(whole, arguments.from, arguments.to);
  if (!part_of_take) return part_of_take.error();
  auto to_active = choose_body(choices.active, active, progress);
  if (!to_active) return to_active.error();
  auto to_passive = choose_body(choices.passive, passive, progress);
  if (!to_passive) return to_passive.error();
  auto pair = retarget_pair(std::move(*part_of_take),
                            {{active, to_active->body}, {passive, to_passive->body}}, progress);
  if (!pair) return pair.error();
  return Made{std::move(*pair), std::move(*to_active), std::move(*to_passive)};
}

struct Summary {
  std::size_t holds = 0;  ///< frames with one
  double hold_change_mean_m = 0, hold_change_max_m = 0, bone_error_max = 0, excess_max_m = 0;
  std::size_t nearest_only = 0;
  std::string first_shortfall;
  double first_shortfall_s = 0;
};

Summary summary_of(const RetargetedPair& pair) {
  Summary summary;
  std::vector<double> holds_m;
  for (std::size_t frame = 0; frame < pair.frames.size(); ++frame) {
    const RetargetedFrame& made = pair.frames[frame];
    if (made.holds > 0) holds_m.push_back(made.hold_change_m);
    summary.hold_change_max_m = std::max(summary.hold_change_max_m, made.hold_change_m);
    summary.bone_error_max = std::max(summary.bone_error_max, made.bone_error);
    summary.excess_max_m = std::max(summary.excess_max_m, made.excess_m);
    if (!made.is_nearest_only()) continue;
    if (summary.nearest_only++ == 0) {
      summary.first_shortfall = made.shortfall();
      summary.first_shortfall_s = static_cast<double>(frame) / pair.recorded.active.fps;
    }
  }
  summary.holds = holds_m.size();
  summary.hold_change_mean_m = mean(holds_m);
  return summary;
}

std::string text_of(const Made& made, const std::string& file) {
  const Summary summary = summary_of(made.pair);
  const std::string holds =
      summary.holds == 0 ? "no hands hold one another"
                         : fmt::format("holds change by {:.1f} mm on average, at most {:.1f}",
                                       1000 * summary.hold_change_mean_m, 1000 * summary.hold_change_max_m);
  std::string text = fmt::format(
      "{}: {} frames, active {} ({:.2f} m), passive {} ({:.2f} m), to {}\n  {}; bodies overlap by {:.1f} mm "
      "more "
      "at most; bones differ by {:.3f} % at most\n",
      made.pair.recorded.name, made.pair.frames.size(), made.active.name, made.active.body.height(),
      made.passive.name, made.passive.body.height(), file, holds, 1000 * summary.excess_max_m,
      100 * summary.bone_error_max);
  if (summary.nearest_only > 0)
    text += fmt::format("  {} of them are the nearest that these bodies can do; the first at {:.2f} s: {}\n",
                        summary.nearest_only, summary.first_shortfall_s, summary.first_shortfall);
  return text;
}

std::string json_of(const std::vector<Made>& all) {
  JsonText json;
  json.begin_object().key("takes").begin_array();
  for (const Made& made : all) {
    const Summary summary = summary_of(made.pair);
    json.begin_object();
    json.key("take").value(made.pair.recorded.name);
    json.key("frames").value(static_cast<int>(made.pair.frames.size()));
    json.key("active_body").value(made.active.name);
    json.key("passive_body").value(made.passive.name);
    json.key("hold_change_mean_m").value(summary.hold_change_mean_m);
    json.key("hold_change_max_m").value(summary.hold_change_max_m);
    json.key("excess_penetration_max_m").value(summary.excess_max_m);
    json.key("bone_length_max").value(summary.bone_error_max);
    json.key("nearest_only").value(static_cast<int>(summary.nearest_only));
    json.end_object();
  }
  json.end_array().end_object();
  return json.take();
}

/// Everything is made before the first file is written.
Status write_outputs(const RetargetArguments& arguments, const std::vector<Made>& all) {
  std::vector<std::pair<std::string, std::string>> contents;
  std::vector<std::unique_ptr<LineFile>> traces;
  for (const Made& made : all) {
    const std::string& take = made.pair.recorded.name;
    const std::string output = arguments.file_of(arguments.output, take);
    if (arguments.character.is_given()) {
      auto both = arguments.character.contents(output, made.pair.active(), made.pair.passive());
      if (!both) return both.error();
      std::ranges::move(*both, std::back_inserter(contents));
    } else {
      auto content = clip_file_content(output, std::array<Clip, 2>{made.pair.active(), made.pair.passive()});
      if (!content) return content.error();
      contents.emplace_back(output, std::move(*content));
    }
    if (arguments.trace.empty()) continue;
    auto trace = LineFile::open(arguments.file_of(arguments.trace, take));
    if (!trace) return trace.error();
    const double fps = made.pair.recorded.active.fps;
    (*trace)->add(trace_header_line({arguments.source(), take, fps, Settings{}}));
    for (std::size_t frame = 0; frame < made.pair.frames.size(); ++frame)
      (*trace)->add(trace_frame_line(frame_result_of(made.pair, frame),
                                     arguments.from + static_cast<long long>(frame),
                                     static_cast<double>(frame) / fps));
    traces.push_back(std::move(*trace));
  }
  if (interrupted()) return Error{"cancelled", arguments.source()};
  for (const auto& trace : traces)
    if (const Status finished = trace->finish(); !finished) return finished;
  for (const auto& [file, content] : contents)
    if (const Status written = write_whole_file(file, content); !written) return written;
  return Done{};
}

Status run_retarget(CommandLine& line, const RetargetArguments& arguments) {
  if (arguments.library.empty() == arguments.manifest.empty())
    return Error{"the take comes from --library or from --manifest: name one of them", ""};
  const auto choices = read_choices(arguments);
  if (!choices) return choices.error();
  if (const Status usable = check_outputs(arguments, *choices); !usable) return usable;
  const Progress progress = terminal_progress(line);
  const auto takes = arguments.library.empty() ? takes_of_manifest(line, arguments, part(progress, 0, 0.1))
                                               : takes_of_library_file(arguments);
  if (!takes) return takes.error();
  std::vector<Made> all;
  for (std::size_t t = 0; t < takes->size(); ++t) {
    const double begin = 0.1 + 0.9 * static_cast<double>(t) / static_cast<double>(takes->size());
    const double end = 0.1 + 0.9 * static_cast<double>(t + 1) / static_cast<double>(takes->size());
    auto made = make(arguments, *choices, (*takes)[t], part(progress, begin, end));
    if (!made) return made.error();
    all.push_back(std::move(*made));
  }
  if (const Status written = write_outputs(arguments, all); !written) return written;
  if (arguments.json) {
    answer_json(line, json_of(all));
  } else if (!line.quiet) {
    std::string text;
    for (const Made& made : all)
      text += text_of(made, arguments.file_of(arguments.output, made.pair.recorded.name));
    answer(line, text);
  }
  return Done{};
}

}  // namespace

void add_retarget_command(CommandLine& line) {
  const auto arguments = std::make_shared<RetargetArguments>();
  CLI::App* command = line.app.add_subcommand(
      "retarget", "a recorded pair on two other bodies: contacts, steps and holds stay what they were");
  CLI::Option* library =
      command->add_option("--library", arguments->library, "motion library with the take")->type_name("LIB");
  command->add_option("--manifest", arguments->manifest, "or a manifest with it (JSON)")
      ->type_name("MANIFEST")
      ->excludes(library);
  command->add_option("--take", arguments->takes, "the take; may be repeated, which gives OUT_TAKE for each")
      ->required()
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("TAKE");
  command->add_option("--from", arguments->from, "first frame")->type_name("FRAME")->capture_default_str();
  command->add_option("--to", arguments->to, "frame behind the last; by default all")->type_name("FRAME");
  const char* const body = "library, scale:NUMBER (0.3 to 3), or a motion file whose proportions it gets";
  command->add_option("--active-body", arguments->active_body, std::string("body of who leads: ") + body)
      ->type_name("BODY")
      ->capture_default_str();
  command->add_option("--passive-body", arguments->passive_body, std::string("body of the partner: ") + body)
      ->type_name("BODY")
      ->capture_default_str();
  CLI::Option* output = command
                            ->add_option("-o,--output", arguments->output,
                                         "both characters: .bvh (two roots), .glb, .csv, .npz")
                            ->required()
                            ->type_name("FILE");
  arguments->character.add_to(*command, output);
  command
      ->add_option(
          "--trace", arguments->trace,
          "one JSON object per frame (JSON lines), for abrazo render: recording, mesh, result, status")
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, "the summary as one JSON object on stdout");
  command->callback([&line, arguments] {
    if (const Status done = run_retarget(line, *arguments); !done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
