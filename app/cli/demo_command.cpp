#include <fmt/core.h>

#include <cstdint>
#include <map>
#include <memory>

#include "app/cli/command_line.hpp"
#include "core/choreography/demo_set.hpp"
#include "core/choreography/salsa.hpp"

namespace abrazo::app {
namespace {

struct DemoArguments {
  std::string folder;
  std::string style = "salsa";
  std::uint64_t seed = 1;
  double minutes = 1;
};

void print_summary(const std::vector<PairedTake>& takes) {
  std::map<std::string, int> moves;
  for (const PairedTake& take : takes) {
    fmt::print("{}_a.bvh, {}_b.bvh: {} frames at {} Hz, {} moves\n", take.name, take.name,
               take.a.poses.size(), take.fps, take.labels.size());
    for (const LabelInterval& label : take.labels) ++moves[label.label];
  }
  fmt::print("labels.csv:");
  for (const auto& [label, count] : moves) fmt::print(" {} x {}", label, count);
  fmt::print("\n");
}

void run_demo(CommandLine& line, const DemoArguments& arguments) {
  if (arguments.style != "salsa")
    return fail(line,
                {"only salsa can be generated so far; use --style salsa", "--style " + arguments.style});
  const std::vector<PairedTake> takes =
      generate_salsa({.seed = arguments.seed, .minutes = arguments.minutes});
  const auto manifest = write_demo_set(takes, fmt::format("demo-salsa-{}", arguments.seed), arguments.folder,
                                       terminal_progress(line));
  if (!manifest) return fail(line, manifest.error());
  print_summary(takes);
  fmt::print("manifest: {}\n", manifest->string());
  fmt::print("next: abrazo library build {} -o {}\n", manifest->string(),
             (manifest->parent_path() / "library.h5").string());
}

}  // namespace

void add_demo_command(CommandLine& line) {
  const auto arguments = std::make_shared<DemoArguments>();
  CLI::App* demo = line.app.add_subcommand(
      "demo", "Write a generated, labelled set of paired takes (BVH, labels, manifest)");
  demo->add_option("-o,--output", arguments->folder, "folder to write into; made when it is not there")
      ->required();
  demo->add_option("--seed", arguments->seed, "same seed, same dance")->capture_default_str();
  demo->add_option("--minutes", arguments->minutes, "of motion in all, to the nearest 8-count")
      ->check(CLI::Range(0.01, 600.0))
      ->capture_default_str();
  demo->add_option("--style", arguments->style, "what to generate")
      ->check(CLI::IsMember({"salsa", "fight"}))
      ->capture_default_str();
  demo->callback([&line, arguments] { run_demo(line, *arguments); });
}

}  // namespace abrazo::app
