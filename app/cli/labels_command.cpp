#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "app/cli/text_lines.hpp"
#include "core/annotation/annotations.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/json_text.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/base/utc_time.hpp"
#include "core/base/version.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/library/takes/tier_kind.hpp"

namespace abrazo::app {

namespace {

/// Options of the subcommands of `labels`.
struct LabelWords {
  std::string file, output, vocabulary;
  TierReading reading;
  std::vector<std::string> tiers;
  bool seconds = false;
  bool json = false;
};

constexpr const char* problem_names[] = {"gap",          "unknown_value", "too_short",
                                         "out_of_range", "off_frame",     "empty_tier"};

Result<TierDocument> read(CommandLine& line, const LabelWords& words) {
  auto document = read_tiers(words.file, words.reading);
  if (!document) return document.error();
  for (const std::string& warning : document->warnings) warn(line, words.file + ": " + warning);
  return document;
}

double annotated_s(const Tier& tier) {
  double sum_s = 0;
  for (const TierInterval& one : tier.intervals) sum_s += one.end_s - one.start_s;
  return sum_s;
}

// ---- info ----

std::string info_json(const TierDocument& document) {
  JsonText json;
  json.begin_object().key("take").value(document.take).key("tiers").begin_array();
  for (const Tier& tier : document.tiers) {
    json.begin_object().key("name").value(tier.name);
    json.key("kind").value(text_of(tier.kind));
    json.key("intervals").value(static_cast<long long>(tier.intervals.size()));
    if (!tier.intervals.empty()) {
      json.key("start_s").value(tier.intervals.front().start_s);
      json.key("end_s").value(tier.intervals.back().end_s);
    }
    json.key("annotated_s").value(annotated_s(tier)).key("values").begin_object();
    for (const std::string& value : values_of(tier.intervals))
      json.key(value).value(
          static_cast<long long>(std::count_if(tier.intervals.begin(), tier.intervals.end(),
                                               [&](const TierInterval& one) { return one.value == value; })));
    json.end_object().key("vocabulary").begin_array();
    for (const VocabularyEntry& entry : tier.vocabulary) json.value(entry.value);
    json.end_array().end_object();
  }
  json.end_array().key("warnings").begin_array();
  for (const std::string& warning : document.warnings) json.value(warning);
  return json.end_array().end_object().take();
}

std::string info_text(const TierDocument& document) {
  TextLines text;
  for (const Tier& tier : document.tiers) {
    const std::string extent =
        tier.intervals.empty()
            ? std::string()
            : fmt::format(" from {:.3f} to {:.3f} s, {:.3f} s annotated", tier.intervals.front().start_s,
                          tier.intervals.back().end_s, annotated_s(tier));
    text.add("{} ({}): {} intervals{}", tier.name, text_of(tier.kind), tier.intervals.size(), extent);
    for (const std::string& value : values_of(tier.intervals)) {
      Tier only{tier.name, {}};
      for (const TierInterval& one : tier.intervals)
        if (one.value == value) only.intervals.push_back(one);
      text.add("  {:<20} {:4} {:9.3f} s", value.empty() ? "(nothing)" : value, only.intervals.size(),
               annotated_s(only));
    }
  }
  return document.tiers.empty() ? "no tiers\n" : text.take();
}

Status run_info(CommandLine& line, const LabelWords& words) {
  const auto document = read(line, words);
  if (!document) return document.error();
  if (words.json)
    answer_json(line, info_json(*document));
  else
    answer(line, info_text(*document));
  return Done{};
}

// ---- convert ----

/// The named tiers in the order of the names; all without names.
Result<std::vector<Tier>> chosen(std::vector<Tier> tiers, const LabelWords& words) {
  if (words.tiers.empty()) return tiers;
  std::vector<Tier> kept;
  for (const std::string& name : words.tiers) {
    const auto found =
        std::find_if(tiers.begin(), tiers.end(), [&](const Tier& tier) { return tier.name == name; });
    if (found == tiers.end()) {
      std::string names;
      for (const Tier& tier : tiers) names += (names.empty() ? "" : ", ") + printable_line(tier.name);
      return Error{"has no tier " + in_quotes(name) + "; it has " + names, words.file};
    }
    kept.push_back(*found);
  }
  return kept;
}

Status run_convert(CommandLine& line, const LabelWords& words) {
  if (const Status usable = check_output(words.output, {words.file}); !usable) return usable;
  auto document = read(line, words);
  if (!document) return document.error();
  const auto tiers = chosen(std::move(document->tiers), words);
  if (!tiers) return tiers.error();
  TierWriting writing;
  writing.fps = words.reading.fps;
  if (!words.seconds) writing.take = words.reading.take;
  writing.author = std::string("abrazo ") + version();
  writing.date = utc_now();
  const auto written = write_tiers(*tiers, words.output, writing);
  if (!written) return written.error();
  for (const std::string& warning : written->warnings) warn(line, words.output + ": " + warning);
  return write_whole_file(words.output, written->text);
}

// ---- check ----

/// Words for all tiers of moves: one a line, or the vocabularies of a label file.
Status set_vocabulary(const LabelWords& words, std::vector<Tier>& tiers) {
  std::vector<Tier> known;
  if (is_tier_file(words.vocabulary) && !words.vocabulary.ends_with(".txt")) {  // which is a plain list
    auto document = read_tiers(words.vocabulary, words.reading);
    if (!document) return document.error();
    known = std::move(document->tiers);
  } else {
    const auto text = read_whole_file(words.vocabulary);
    if (!text) return text.error();
    Tier lines{"", {}, {}, TierKind::Move};
    for (const std::string_view word : split_lines(*text))
      if (!trimmed(word).empty()) lines.vocabulary.push_back({std::string(trimmed(word))});
    known.push_back(std::move(lines));
  }
  bool any = false;
  for (Tier& tier : tiers)
    for (const Tier& source : known) {
      const bool fits = source.name == tier.name || (source.name.empty() && tier.kind == source.kind);
      if (!fits) continue;
      tier.vocabulary = source.vocabulary.empty() ? vocabulary_of(source.intervals) : source.vocabulary;
      any = true;
    }
  if (any) return Done{};
  return Error{"has no words for any tier of " + words.file + "; a label file needs a tier of the same name",
               words.vocabulary};
}

Annotations::Range range_of(const std::vector<Tier>& tiers) {
  Annotations::Range range{std::numeric_limits<double>::infinity(), 0};
  for (const Tier& tier : tiers)
    for (const TierInterval& one : tier.intervals) {
      range.first_s = std::min(range.first_s, one.start_s);
      range.last_s = std::max(range.last_s, one.end_s);
    }
  range.first_s = std::min(range.first_s, range.last_s);
  return range;
}

std::string problems_json(const Annotations& annotations, const std::vector<AnnotationProblem>& problems) {
  JsonText json;
  json.begin_object().key("problems").begin_array();
  for (const AnnotationProblem& problem : problems) {
    json.begin_object().key("kind").value(problem_names[static_cast<std::size_t>(problem.kind)]);
    json.key("tier").value(annotations.tier(problem.tier)->name);
    json.key("start_s").value(problem.start_s).key("end_s").value(problem.end_s);
    json.key("text").value(problem.text).end_object();
  }
  return json.end_array().end_object().take();
}

Status run_check(CommandLine& line, const LabelWords& words) {
  auto document = read(line, words);
  if (!document) return document.error();
  if (!words.vocabulary.empty())
    if (const Status set = set_vocabulary(words, document->tiers); !set) return set;
  const auto annotations = annotations_of(document->tiers);
  if (!annotations) return Error{annotations.error().text(), words.file};
  const auto problems = problems_of(*annotations, range_of(document->tiers), words.reading.fps);
  TextLines text;
  for (const AnnotationProblem& problem : problems) text.add("{}", problem.text);
  if (words.json)
    answer_json(line, problems_json(*annotations, problems));
  else
    answer(line, text.take());
  if (problems.empty()) return Done{};
  return Error{fmt::format("has {} {}", problems.size(), problems.size() == 1 ? "problem" : "problems"),
               words.file};
}

// ---- words ----

void add_file(CLI::App& command, LabelWords& words) {
  command.add_option("FILE", words.file, "labels: .eaf, .csv, .json, .TextGrid, or .txt of ELAN or Audacity")
      ->required()
      ->type_name("");
  command.add_option("--fps", words.reading.fps, "frame rate of the labelled motion")
      ->check(above_zero)
      ->type_name("N");
  command.add_option("--take", words.reading.take, "which take of a label file that has several")
      ->type_name("NAME");
}

void add(CommandLine& line, CLI::App& labels, const char* name, const char* text,
         Status (*run)(CommandLine&, const LabelWords&), void (*add_more)(CLI::App&, LabelWords&)) {
  const auto words = std::make_shared<LabelWords>();
  CLI::App* command = labels.add_subcommand(name, text);
  add_file(*command, *words);
  add_more(*command, *words);
  command->callback([&line, words, run] {
    if (const Status done = run(line, *words); !done) fail(line, done.error());
  });
}

void add_json(CLI::App& command, LabelWords& words) {
  command.add_flag("--json", words.json, "one JSON object on stdout");
}

void add_convert(CLI::App& command, LabelWords& words) {
  command
      .add_option(
          "-o,--output", words.output,
          ".eaf, .json, .TextGrid, .txt (Audacity) or .csv (in frames of --take at --fps, else in seconds)")
      ->required()
      ->type_name("FILE");
  command.add_option("--tier", words.tiers, "only this tier; may be given several times")
      ->type_name("NAME")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
  command.add_flag("--seconds", words.seconds, "CSV in seconds though a take is named");
}

void add_check(CLI::App& command, LabelWords& words) {
  command
      .add_option("--vocabulary", words.vocabulary,
                  "allowed values: a file with one move per line, or a label file with the same tiers")
      ->type_name("FILE");
  add_json(command, words);
}

}  // namespace

void add_labels_command(CommandLine& line) {
  CLI::App* labels = line.app.add_subcommand("labels", "show, check and convert label files");
  labels->require_subcommand(1);
  add(line, *labels, "info", "tiers, intervals and values of a label file", run_info, add_json);
  add(line, *labels, "convert", "write the labels of a file in another format", run_convert, add_convert);
  add(line, *labels, "check", "gaps, unknown labels, intervals off the frames; status 1 when there are any",
      run_check, add_check);
}

}  // namespace abrazo::app
