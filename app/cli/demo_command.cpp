#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "app/cli/command_line.hpp"
#include "app/cli/interruption.hpp"
#include "core/base/text.hpp"
#include "core/choreography/demo_set.hpp"
#include "core/choreography/fight.hpp"
#include "core/choreography/salsa.hpp"

namespace abrazo::app {
namespace {

/// A number for both performers, or one for each.
using OneOrTwo = std::vector<double>;

struct DemoArguments {
  std::string folder;
  std::string style = "salsa";
  ChoreographyOptions options;
  OneOrTwo height, arms, legs, skill, amplitude, timing_error, wander;
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

/// The value for performer 0 or 1; without one the default stays.
void take_over(const OneOrTwo& given, std::size_t performer, double& value) {
  if (!given.empty()) value = given[std::min(performer, given.size() - 1)];
}

ChoreographyOptions choreography(const DemoArguments& arguments) {
  ChoreographyOptions options = arguments.options;
  if (arguments.style == "fight") options.b.height_m = 1.72;
  std::size_t performer = 0;
  for (PerformerOptions* build : {&options.a, &options.b}) {
    take_over(arguments.height, performer, build->height_m);
    take_over(arguments.arms, performer, build->arm_scale);
    take_over(arguments.legs, performer, build->leg_scale);
    double skill = 1;
    take_over(arguments.skill, performer, skill);
    build->performance = performance_of_skill(skill);
    take_over(arguments.amplitude, performer, build->performance.amplitude);
    take_over(arguments.timing_error, performer, build->performance.timing_error_s);
    take_over(arguments.wander, performer, build->performance.wander_m);
    ++performer;
  }
  return options;
}

void run_demo(CommandLine& line, const DemoArguments& arguments) {
  const ChoreographyOptions options = choreography(arguments);
  const Progress progress = terminal_progress(line);
  const std::vector<PairedTake> takes = arguments.style == "fight"
                                            ? generate_fight(options, part(progress, 0, 0.8))
                                            : generate_salsa(options, part(progress, 0, 0.8));
  if (interrupted()) return fail(line, {"cancelled", arguments.folder});
  const auto manifest = write_demo_set(takes, fmt::format("demo-{}-{}", arguments.style, options.seed),
                                       arguments.folder, part(progress, 0.8, 1));
  if (!manifest) return fail(line, manifest.error());
  if (!line.quiet) answer(line, summary(takes, *manifest));
}

void add_demo_performer_option(CLI::App& demo, const char* name, OneOrTwo& values, double low, double high,
                               const std::string& help) {
  demo.add_option(name, values, help)
      ->delimiter(',')
      ->expected(1, 2)
      ->allow_extra_args(false)
      ->check(CLI::Range(low, high))
      ->type_name("A[,B]")
      ->group("Performers");
}

}  // namespace

void add_demo_command(CommandLine& line) {
  const auto arguments = std::make_shared<DemoArguments>();
  CLI::App* demo = line.app.add_subcommand(
      "demo", "Write a generated, labelled set of paired takes (BVH, labels, manifest)");
  demo->add_option("-o,--output", arguments->folder, "folder to write into; created if missing")
      ->required()
      ->check([](const std::string& word) { return std::string(word.empty() ? "the name is empty" : ""); })
      ->type_name("DIR");
  demo->add_option("--seed", arguments->options.seed, "same seed, same dance")
      ->check(whole_number)
      ->type_name("N")
      ->capture_default_str();
  demo->add_option("--minutes", arguments->options.minutes, "of motion in all; 0.01 to 600")
      ->check(minutes_range)
      ->type_name("MINUTES")
      ->capture_default_str();
  demo->add_option("--style", arguments->style, "what to generate")
      ->check(CLI::IsMember({"salsa", "fight"}))
      ->type_name("STYLE")
      ->capture_default_str();
  demo->add_option("--tempo", arguments->options.tempo_bpm,
                   "salsa: beats per minute, 120 to 220; by default drawn from 160 to 190 for every take")
      ->check(CLI::Range(120.0, 220.0))
      ->type_name("BPM");
  demo->add_option("--pace", arguments->options.pace, "fight: speed of blows and footwork against the usual")
      ->check(CLI::Range(0.5, 1.5))
      ->type_name("FACTOR")
      ->capture_default_str();
  demo->add_option("--take-seconds", arguments->options.take_seconds, "length of a take, about")
      ->check(CLI::Range(5.0, 600.0))
      ->type_name("SECONDS")
      ->capture_default_str();
  add_demo_performer_option(*demo, "--height", arguments->height, 1.4, 2.2,
                            "metres; 1.80,1.66 for salsa and 1.80,1.72 for fight when not given");
  add_demo_performer_option(*demo, "--arms", arguments->arms, 0.8, 1.25,
                            "length of the arms against the usual");
  add_demo_performer_option(*demo, "--legs", arguments->legs, 0.85, 1.15,
                            "length of the legs against the usual");
  add_demo_performer_option(*demo, "--skill", arguments->skill, 0, 1,
                            "from a first lesson (0) to an expert (1, the default): sets the three below");
  add_demo_performer_option(*demo, "--amplitude", arguments->amplitude, 0.5, 1.3,
                            "size of steps, hips, arms and blows; 1 for an expert");
  add_demo_performer_option(*demo, "--timing-error", arguments->timing_error, 0, 0.25,
                            "how early or late moves are begun, standard deviation in seconds");
  add_demo_performer_option(*demo, "--wander", arguments->wander, 0, 0.1,
                            "slow random drift of trunk and hands, rms in metres");
  demo->callback([&line, arguments] { run_demo(line, *arguments); });
}

}  // namespace abrazo::app
