#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "app/cli/library_command.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/output_file.hpp"
#include "core/library/takes/dataset_plan.hpp"

namespace abrazo::app {

namespace {

struct PlanArguments {
  std::string dataset, folder, body_model, output;
};

void run_library_plan(CommandLine& line, const PlanArguments& arguments) {
  if (const Status usable = check_output(arguments.output, {}); !usable) return fail(line, usable.error());
  const auto manifest = plan_dataset(arguments.dataset, arguments.folder, arguments.body_model);
  if (!manifest) return fail(line, manifest.error());
  for (const std::string& warning : manifest->warnings) warn(line, arguments.folder + ": " + warning);
  const std::filesystem::path output(arguments.output);
  const std::string json = manifest_json(*manifest, output.has_parent_path() ? output.parent_path() : ".");
  if (const Status written = write_whole_file(arguments.output, json); !written)
    return fail(line, written.error());
  const auto labelled = std::count_if(manifest->takes.begin(), manifest->takes.end(),
                                      [](const Manifest::Take& take) { return !take.labels.empty(); });
  if (!line.quiet)
    answer(line, fmt::format("{}: {} takes of two performers, {} with labels\n", arguments.output,
                             manifest->takes.size(), labelled));
}

}  // namespace

void add_library_plan(CLI::App& library, CommandLine& line) {
  CLI::App* plan =
      library.add_subcommand("plan", "write a manifest of the pairs in a folder, as a dataset lays them out");
  const auto arguments = std::make_shared<PlanArguments>();
  std::string names;
  for (const DatasetLayout& layout : dataset_layouts()) names += (names.empty() ? "" : "|") + layout.name;
  plan->add_option("--dataset", arguments->dataset, "how the files are laid out")
      ->required()
      ->type_name(names);
  plan->add_option("DIR", arguments->folder, "folder with the motion files")->required()->type_name("");
  plan->add_option("--body-model", arguments->body_model,
                   "of SMPL or SMPL-X parameters: the .npz of the body model")
      ->type_name("NPZ");
  plan->add_option("-o,--output", arguments->output, "the manifest to write")->required()->type_name("JSON");
  plan->callback([&line, arguments] { run_library_plan(line, *arguments); });
}

}  // namespace abrazo::app
