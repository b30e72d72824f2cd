#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>

#include "app/cli/command_line.hpp"
#include "app/cli/interruption.hpp"
#include "core/base/text.hpp"
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

/// CLI11 takes -1 and numbers beyond 64 bits for another seed without a word.
const CLI::Validator whole_number(
    [](const std::string& word) {
      const auto number = parse_integer(word);
      return number && *number >= 0 ? std::string() : "expected a whole number from 0, found '" + word + "'";
    },
    "");

const CLI::Validator minutes_range(
    [](const std::string& word) {
      const auto number = parse_number(word);
      const bool usable = number && *number >= 0.01 && *number <= 600;
      return usable ? std::string() : "expected a number from 0.01 to 600, found '" + word + "'";
    },
    "");

std::string summary(const std::vector<PairedTake>& takes, const std::filesystem::path& manifest) {
  std::string text;
  std::map<std::string, int> moves;
  for (const PairedTake& take : takes) {
    text += fmt::format("{}_a.bvh, {}_b.bvh: {} frames at {} Hz, {} moves\n", take.name, take.name,
                        take.a.poses.size(), take.fps, take.labels.size());
    for (const LabelInterval& label : take.labels) ++moves[label.label];
  }
  text += "labels.csv:";
  for (const auto& [label, count] : moves) text += fmt::format(" {} x {}", label, count);
  return text + fmt::format("\nmanifest: {}\nnext: abrazo library build {} -o {}\n", manifest.string(),
                            manifest.string(), (manifest.parent_path() / "library.h5").string());
}

void run_demo(CommandLine& line, const DemoArguments& arguments) {
  if (arguments.style != "salsa")
    return fail(line,
                {"only salsa can be generated so far; use --style salsa", "--style " + arguments.style});
  const std::vector<PairedTake> takes =
      generate_salsa({.seed = arguments.seed, .minutes = arguments.minutes});
  if (interrupted()) return fail(line, {"cancelled", arguments.folder});
  const auto manifest = write_demo_set(takes, fmt::format("demo-salsa-{}", arguments.seed), arguments.folder,
                                       terminal_progress(line));
  if (!manifest) return fail(line, manifest.error());
  if (!line.quiet) answer(line, summary(takes, *manifest));
}

}  // namespace

void add_demo_command(CommandLine& line) {
  const auto arguments = std::make_shared<DemoArguments>();
  CLI::App* demo = line.app.add_subcommand(
      "demo", "Write a generated, labelled set of paired takes (BVH, labels, manifest)");
  demo->add_option("-o,--output", arguments->folder, "folder to write into; made when it is not there")
      ->required()
      ->check([](const std::string& word) { return std::string(word.empty() ? "the name is empty" : ""); })
      ->type_name("DIR");
  demo->add_option("--seed", arguments->seed, "same seed, same dance")
      ->check(whole_number)
      ->type_name("N")
      ->capture_default_str();
  demo->add_option("--minutes", arguments->minutes, "of motion in all, to the nearest 8-count; 0.01 to 600")
      ->check(minutes_range)
      ->type_name("MINUTES")
      ->capture_default_str();
  demo->add_option("--style", arguments->style, "what to generate")
      ->check(CLI::IsMember({"salsa", "fight"}))
      ->type_name("STYLE")
      ->capture_default_str();
  demo->callback([&line, arguments] { run_demo(line, *arguments); });
}

}  // namespace abrazo::app
