#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/cli/command_line.hpp"
#include "app/cli/evaluation_data.hpp"
#include "app/cli/report_folder.hpp"
#include "app/cli/settings_options.hpp"
#include "core/base/json_text.hpp"
#include "core/evaluation/sweep/sweep.hpp"
#include "core/evaluation/sweep/sweep_report.hpp"

namespace abrazo::app {

namespace {

struct SweepArguments {
  EvaluationSource source;
  std::string x, y, metric, report, shard = "1/1";
  bool merge = false, json = false;
  SettingsOptions settings;
};

Result<SweepOutcome> run(CommandLine& line, const SweepArguments& arguments) {
  if (arguments.merge) return merge_sweep(arguments.report, arguments.metric);
  const auto settings = arguments.settings.read();
  if (!settings) return settings.error();
  const auto x = parse_sweep_axis(arguments.x), y = parse_sweep_axis(arguments.y);
  if (!x) return x.error();
  if (!y) return y.error();
  const auto shard = parse_sweep_shard(arguments.shard);
  if (!shard) return shard.error();
  Sweep sweep{.data = "", .settings = *settings, .x = *x, .y = *y, .metric = arguments.metric};
  if (const Status usable = check_sweep(sweep); !usable) return usable.error();
  const auto manifests = read_manifests(arguments.source);
  if (!manifests) return manifests.error();
  ReportFolder report_folder(arguments.report);
  if (const Status made = report_folder.make(); !made) return made.error();

  const Progress progress = terminal_progress(line);
  const auto data = read_takes(line, *manifests, arguments.source.both_roles, part(progress, 0, 0.05));
  if (!data) return data.error();
  const std::vector<std::string>& hold_out = arguments.source.hold_out;
  sweep.data = identity_of(*data, hold_out);
  const auto evaluate_point = [&](const Settings& at, const Progress& within) {
    return evaluate(*data, {.parts = sweep_parts(), .settings = at, .hold_out = hold_out, .variants = false},
                    within);
  };
  return run_sweep(sweep, *shard, arguments.report, evaluate_point, part(progress, 0.05, 1));
}

std::string missing_json(const SweepOutcome& outcome) {
  JsonText json;
  json.begin_object().key("shards").value(outcome.shard_count).key("missing").begin_array();
  for (const int index : outcome.missing) json.value(index);
  return json.end_array().end_object().take();
}

std::string summary(const SweepOutcome& outcome, const std::string& folder) {
  std::string text;
  if (outcome.was_there) text = "this shard had been evaluated before; remove its file to do it again\n";
  if (!outcome.missing.empty()) {
    std::string list;
    for (const int index : outcome.missing) list += fmt::format(" {}/{}", index, outcome.shard_count);
    return text + fmt::format("missing shards:{}\n", list);
  }
  const Sweep& sweep = outcome.sweep;
  const Figures& figures = outcome.points[static_cast<std::size_t>(*outcome.best)];
  return text + fmt::format("best {}: {:.4g}\noptions: {}\nreport: {}\n", sweep.metric,
                            figures.at(sweep.metric), settings_options(settings_at(sweep, *outcome.best)),
                            (std::filesystem::path(folder) / "sweep.html").string());
}

Status run_sweep_command(CommandLine& line, const SweepArguments& arguments) {
  const auto outcome = run(line, arguments);
  if (!outcome) return outcome.error();
  if (arguments.json)
    answer_json(line, outcome->missing.empty() ? sweep_json(*outcome) : missing_json(*outcome));
  else if (!line.quiet)
    answer(line, summary(*outcome, arguments.report));
  return Done{};
}

/// What a sweep needs and a merge does not.
void require_for_sweep(const SweepArguments& arguments) {
  if (arguments.merge) return;
  for (const auto& [name, value] :
       {std::pair("--manifest", &arguments.source.manifest), std::pair("--x", &arguments.x),
        std::pair("--y", &arguments.y), std::pair("--metric", &arguments.metric)})
    if (value->empty()) throw CLI::RequiredError(name);
}

}  // namespace

void add_sweep_command(CommandLine& line) {
  const auto arguments = std::make_shared<SweepArguments>();
  CLI::App* command = line.app.add_subcommand(
      "sweep",
      "a grid over two settings, each point an evaluation: sweep.json and sweep.html with a heat map");
  add_evaluation_source(*command, arguments->source);
  command->get_option("--manifest")->required(false);  // a merge needs none
  const std::string axis = "SETTING=FROM:TO:COUNT, SETTING=log:FROM:TO:COUNT, or SETTING=A,B,C";
  command->add_option("--x", arguments->x, "columns of the grid: " + axis)->type_name("AXIS");
  command->add_option("--y", arguments->y, "rows of the grid, likewise")->type_name("AXIS");
  command
      ->add_option("--metric", arguments->metric,
                   "path of a figure in report.json, as in partner.mean_joint_error_m or moves.rate")
      ->type_name("NAME");
  command
      ->add_option("--report", arguments->report, "folder for the shards and the report; created if missing")
      ->required()
      ->type_name("DIR");
  CLI::Option* shard =
      command
          ->add_option("--shard", arguments->shard,
                       "evaluate only this part of the points, I from 1 to N; the last part to be done "
                       "draws them all")
          ->type_name("I/N")
          ->capture_default_str();
  command
      ->add_flag(
          "--merge", arguments->merge,
          "evaluate nothing: read the shards in DIR and draw them, for another --metric if one is given")
      ->excludes(shard)
      ->excludes("--manifest")
      ->excludes("--users")
      ->excludes("--hold-out")
      ->excludes("--x")
      ->excludes("--y");
  command->add_flag("--json", arguments->json,
                    "sweep.json on stdout as well; while shards are missing, which");
  arguments->settings.add_to(*command);
  command->callback([&line, arguments] {
    require_for_sweep(*arguments);
    if (const Status done = run_sweep_command(line, *arguments); !done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
