#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>

#include "app/cli/command_line.hpp"
#include "app/cli/report_folder.hpp"
#include "app/cli/text_lines.hpp"
#include "core/annotation/suggestions.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/json_text.hpp"
#include "core/base/output_file.hpp"
#include "core/evaluation/report/suggestion_report.hpp"
#include "core/evaluation/tables/suggestion_agreement.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo::app {

namespace {

struct SuggestArguments {
  std::string source, take, output, report;
  bool agreement = false, json = false;
};

/// Of a manifest the library that suggestions need: as many frames a second as are looked at.
Result<MotionLibrary> read_source(CommandLine& line, const std::string& source, const Progress& progress) {
  if (std::filesystem::path(source).extension() != ".json") return read_library(source);
  const auto manifest = read_manifest(source);
  if (!manifest) return manifest.error();
  std::vector<std::string> warnings;
  auto library = build_library(*manifest, {.excluded_takes = {}, .rate_hz = 30}, progress, warnings);
  for (const std::string& warning : warnings) warn(line, warning);
  return library;
}

Tier tier_of(const std::string& name, TierKind kind, const std::vector<Suggestion>& suggestions) {
  Tier tier{.name = name, .intervals = {}, .kind = kind};
  for (const Suggestion& one : suggestions)
    tier.intervals.push_back(
        {one.start_s, one.end_s, one.value, one.reason, fmt::format("{:.2f}", one.confidence)});
  tier.vocabulary = vocabulary_of(tier.intervals);
  return tier;
}

std::string suggestions_json(const std::string& take, const SuggestedTiers& tiers) {
  JsonText json;
  json.begin_object().key("take").value(take);
  for (const auto& [name, list] :
       {std::pair<const char*, const std::vector<Suggestion>&>{"moves", tiers.moves},
        {"roles", tiers.roles}}) {
    json.key(name).begin_array();
    for (const Suggestion& one : list) {
      json.begin_object().key("start_s").value(one.start_s).key("end_s").value(one.end_s);
      json.key("value").value(one.value).key("confidence").value(one.confidence);
      json.key("reason").value(one.reason).end_object();
    }
    json.end_array();
  }
  return json.end_object().take();
}

std::string suggestions_text(const SuggestedTiers& tiers) {
  TextLines text;
  for (const auto* list : {&tiers.roles, &tiers.moves})
    for (const Suggestion& one : *list)
      text.add("{:8.2f} {:8.2f} s  {:<18} {:3.0f} %  {}", one.start_s, one.end_s, one.value,
               100 * one.confidence, one.reason);
  return tiers.roles.empty() && tiers.moves.empty() ? "nothing to suggest\n" : text.take();
}

Status write_tier_file(CommandLine& line, const SuggestArguments& arguments, const SuggestedTiers& tiers,
                       double fps) {
  std::vector<Tier> written;
  if (!tiers.roles.empty()) written.push_back(tier_of("role", TierKind::Role, tiers.roles));
  if (!tiers.moves.empty()) written.push_back(tier_of("move", TierKind::Move, tiers.moves));
  const auto file = write_tiers(written, arguments.output, {.fps = fps, .take = ""});
  if (!file) return file.error();
  for (const std::string& warning : file->warnings) warn(line, arguments.output + ": " + warning);
  return write_whole_file(arguments.output, file->text);
}

Status propose(CommandLine& line, const SuggestArguments& arguments) {
  if (!arguments.output.empty()) {
    if (!is_tier_file(arguments.output))
      return Error{fmt::format("is none of the label formats {}", fmt::join(tier_file_extensions(), ", ")),
                   arguments.output};
    if (const Status usable = check_output(arguments.output, {arguments.source}); !usable) return usable;
  }
  const Progress progress = terminal_progress(line);
  const auto library = read_source(line, arguments.source, part(progress, 0, 0.4));
  if (!library) return library.error();
  const int take = library->find_take(arguments.take);
  if (take < 0) {
    std::string names;
    for (const LibraryTake& of : library->takes())
      names += (names.empty() ? "" : ", ") + printable_line(of.name);
    return Error{fmt::format("has no take \"{}\"; it has {}", arguments.take, names), arguments.source};
  }
  const auto tiers = suggest_annotations(*library, {.take = arguments.take}, part(progress, 0.4, 1));
  if (!tiers) return tiers.error();
  if (!arguments.output.empty()) {
    const double fps = library->takes()[static_cast<std::size_t>(take)].fps;
    if (const Status written = write_tier_file(line, arguments, *tiers, fps); !written) return written;
  }
  clear_progress(line);
  if (arguments.json)
    answer_json(line, suggestions_json(arguments.take, *tiers));
  else if (!line.quiet)
    answer(line, suggestions_text(*tiers));
  return Done{};
}

Status measure(CommandLine& line, const SuggestArguments& arguments) {
  ReportFolder folder(arguments.report);
  if (!arguments.report.empty())
    if (const Status made = folder.make(); !made) return made;
  const Progress progress = terminal_progress(line);
  const auto library = read_source(line, arguments.source, part(progress, 0, 0.1));
  if (!library) return library.error();
  const auto agreement = measure_suggestions(*library, part(progress, 0.1, 1));
  if (!agreement) return agreement.error();
  const std::string json = suggestion_json(*agreement, library->name()) + "\n";
  if (!arguments.report.empty()) {
    const std::filesystem::path path = arguments.report;
    const std::string html = suggestion_html(*agreement, library->name());
    if (const Status written = write_whole_file(path / "agreement.html", html); !written) return written;
    if (const Status written = write_whole_file(path / "agreement.json", json); !written) return written;
  }
  clear_progress(line);
  if (arguments.json)
    answer_json(line, json);
  else if (!line.quiet)
    answer(line, suggestion_summary(*agreement));
  return Done{};
}

}  // namespace

void add_suggest_command(CommandLine& line) {
  const auto arguments = std::make_shared<SuggestArguments>();
  CLI::App* command = line.app.add_subcommand(
      "suggest",
      "Proposes labels and roles for a take from the library's other takes, or measures how well that agrees "
      "with the labels there are");
  command->add_option("source", arguments->source, "a manifest (.json) or a library (.h5)")
      ->required()
      ->type_name("MANIFEST_OR_LIB");
  CLI::Option* take =
      command->add_option("--take", arguments->take, "the take to label; its own labels are ignored")
          ->type_name("TAKE");
  command
      ->add_option(
          "-o,--output", arguments->output,
          "label file of the suggestions (.eaf, .csv, .json, .TextGrid, .txt): detail has the reason, "
          "confidence the share of such suggestions that were right")
      ->type_name("OUT")
      ->needs(take);
  CLI::Option* agreement =
      command
          ->add_flag("--agreement", arguments->agreement,
                     "suggest every labelled take from the others, and compare with its labels")
          ->excludes(take);
  command->add_option("--report", arguments->report, "folder for agreement.html and agreement.json")
      ->type_name("DIR")
      ->needs(agreement);
  command->add_flag("--json", arguments->json, "one JSON object on stdout");
  command->callback([&line, arguments] {
    if (!arguments->agreement && arguments->take.empty())
      throw CLI::RequiredError("--take TAKE or --agreement");
    const Status done = arguments->agreement ? measure(line, *arguments) : propose(line, *arguments);
    if (!done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
