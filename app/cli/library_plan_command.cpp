#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "app/cli/library_command.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/output_file.hpp"
#include "core/library/build/dataset_plan.hpp"

namespace abrazo::app {

namespace {

struct PlanArguments {
  DatasetFolder wanted;
  std::string moves, output;
};

void run_library_plan(CommandLine& line, const PlanArguments& arguments) {
  if (const Status usable = check_output(arguments.output, {}); !usable) return fail(line, usable.error());
  DatasetFolder wanted = arguments.wanted;
  if (arguments.moves == "folder") wanted.moves = MovesFrom::Folders;
  if (arguments.moves == "name") wanted.moves = MovesFrom::Names;
  const auto manifest = plan_dataset(wanted);
  if (!manifest) return fail(line, manifest.error());
  for (const std::string& warning : manifest->warnings) warn(line, wanted.folder.string() + ": " + warning);
  const std::filesystem::path output(arguments.output);
  const std::string json = manifest_json(*manifest, output.has_parent_path() ? output.parent_path() : ".");
  if (const Status written = write_whole_file(arguments.output, json); !written)
    return fail(line, written.error());
  const auto labelled =
      std::count_if(manifest->takes.begin(), manifest->takes.end(),
                    [](const Manifest::Take& take) { return !take.labels.empty() || !take.move.empty(); });
  if (!line.quiet)
    answer(line, fmt::format("{}: {} takes of two performers, {} with labels\n", arguments.output,
                             manifest->takes.size(), labelled));
}

}  // namespace

void add_library_plan(CLI::App& library, CommandLine& line) {
  CLI::App* plan = library.add_subcommand("plan", "pair the motion files of a folder and write a manifest");
  const auto arguments = std::make_shared<PlanArguments>();
  std::string names;
  for (const Dataset& dataset : datasets()) names += (names.empty() ? "" : "|") + dataset.name;
  plan->add_option("--dataset", arguments->wanted.dataset,
                   "what is known of the files: rate, unit and axis of a "
                   "published dataset, or nothing of a folder")
      ->required()
      ->type_name(names);
  plan->add_option("DIR", arguments->wanted.folder, "folder with the motion files")
      ->required()
      ->type_name("");
  plan->add_option("--body-model", arguments->wanted.body_model,
                   "of SMPL or SMPL-X parameters: the .npz of the body model")
      ->type_name("NPZ");
  CLI::Option* labels =
      plan->add_option("--labels", arguments->wanted.labels, "label file of all takes, as CSV")
          ->type_name("CSV");
  plan->add_option("--moves", arguments->moves, "each take is one move, called like its folder or itself")
      ->check(CLI::IsMember({"folder", "name"}))
      ->excludes(labels)
      ->type_name("folder|name");
  plan->add_option("-o,--output", arguments->output, "the manifest to write")->required()->type_name("JSON");
  plan->callback([&line, arguments] { run_library_plan(line, *arguments); });
}

}  // namespace abrazo::app
