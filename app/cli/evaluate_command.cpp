#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

#include "app/cli/command_line.hpp"
#include "app/cli/evaluation_data.hpp"
#include "app/cli/report_folder.hpp"
#include "app/cli/settings_options.hpp"
#include "core/base/atomic_file.hpp"
#include "core/evaluation/report/report_html.hpp"
#include "core/evaluation/report/report_json.hpp"
#include "core/evaluation/run/evaluation_source.hpp"

namespace abrazo::app {

namespace {

struct EvaluateArguments {
  std::vector<std::string> parts;
  EvaluationSource source;
  std::string report;
  SettingsOptions settings;
  EvaluationOptions options;
  bool no_variants = false, json = false;
};

/// The most important figures.
std::string summary(const Evaluation& evaluation, const std::filesystem::path& folder) {
  std::string text;
  const auto line = [&](std::string_view what, const std::string& value) {
    text += fmt::format("{:<36}{}\n", what, value);
  };
  line("takes answered", fmt::format("{}, from {} pairs", evaluation.takes.size(), evaluation.library_pairs));
  for (const SelectionTable& table : evaluation.selection)
    for (const SelectionRow& row : table.rows)
      if (row.k == 10)
        line(fmt::format("recall at k = 10, {:.3g} Hz library", table.rate_hz),
             fmt::format("{:.1f} % best, {:.1f} % either of the best two", 100 * row.recall_best,
                         100 * row.recall_best2));
  for (const TimingRow& row : evaluation.timing)
    line(fmt::format("one selection of {} pairs", row.pairs),
         fmt::format("{:.3f} ms; comparing with all {:.2f} ms", row.knn_us / 1000, row.brute_us / 1000));
  if (const auto& result = evaluation.result; result) {
    if (evaluation.has_moves && result->moves.all.total == 0)
      line("successful moves", "none: the takes have no labelled moves");
    else if (evaluation.has_moves)
      line("successful moves",
           fmt::format("{} of {}, {:.1f} % (lenient {:.1f} %)", result->moves.all.successful,
                       result->moves.all.total, 100 * result->moves.all.rate(),
                       100 * result->moves.all.lenient_rate()));
    if (evaluation.has_zmp)
      line("ZMP error, original / synthesised",
           fmt::format("{:.2f} / {:.2f} cm", 100 * result->zmp.original_m, 100 * result->zmp.synthesised_m));
    if (evaluation.has_contact)
      line("holds, mean distance change",
           fmt::format("{:.1f} mm over {}", 1000 * result->contact.holds.change_mean_m,
                       result->contact.holds.holds));
    if (result->published)
      line("MPJPE, nearest neighbour's",
           fmt::format("{:.0f} mm, {:.0f} mm; {}", 1000 * result->published->made.mpjpe_m,
                       1000 * result->published->nearest.mpjpe_m,
                       std::isfinite(result->published->made.fid_cd)
                           ? fmt::format("FID_cd {:.1f}, {:.1f}", result->published->made.fid_cd,
                                         result->published->nearest.fid_cd)
                           : "no FID_cd: no take has the 2 s of its clips"));
    line("partner from the captured one",
         fmt::format("{:.3f} m mean, {:.3f} m median", result->partner.mean_joint_error_m,
                     result->partner.median_joint_error_m));
    line("whole step, p50 / p99",
         fmt::format("{:.3f} / {:.3f} ms", result->solve.p50_us / 1000, result->solve.p99_us / 1000));
  }
  if (evaluation.bodies)
    for (const BodyRow& row : evaluation.bodies->rows)
      line("bodies: " + row.bodies,
           fmt::format("F1 within 25 cm {:.3f}, holds change by {:.1f} mm",
                       row.methods.front().within_25cm.f1, 1000 * row.methods.front().hold_change_mean_m));
  line("report", fmt::format("{} ({:.0f} s)", (folder / "report.html").string(), evaluation.seconds));
  return text;
}

Status run_evaluate(CommandLine& line, const EvaluateArguments& arguments) {
  const auto settings = arguments.settings.read();
  if (!settings) return settings.error();
  EvaluationOptions options = arguments.options;
  auto parts = evaluation_parts(arguments.parts);
  if (!parts) return parts.error();
  options.parts = std::move(*parts);
  options.settings = *settings;
  options.variants = !arguments.no_variants;
  options.hold_out = arguments.source.hold_out;
  const auto manifests = read_manifests(arguments.source);
  if (!manifests) return manifests.error();
  ReportFolder report_folder(arguments.report);
  if (const Status made = report_folder.make(); !made) return made;

  const Progress progress = terminal_progress(line);
  const auto data = read_takes(line, *manifests, arguments.source.both_roles, part(progress, 0, 0.1));
  if (!data) return data.error();
  const auto evaluation = evaluate(*data, options, part(progress, 0.1, 1));
  if (!evaluation) return evaluation.error();

  const std::filesystem::path folder = arguments.report;
  const std::string json = report_json(*evaluation);
  if (const Status written = write_whole_file(folder / "report.html", report_html(*evaluation)); !written)
    return written;
  if (const Status written = write_whole_file(folder / "report.json", json + "\n"); !written) return written;
  if (arguments.json)
    answer_json(line, json);
  else if (!line.quiet)
    answer(line, summary(*evaluation, folder));
  return Done{};
}

}  // namespace

void add_evaluate_command(CommandLine& line) {
  const auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* command = line.app.add_subcommand(
      "evaluate", "The paper's four tables and further metrics, on your own takes: report.json, report.html");
  command
      ->add_option(
          "parts", arguments->parts,
          "selection (Table I), timing (Table II), moves (Table III), zmp (Table IV), contact (holds, "
          "penetration, sliding, partner error, robustness), published (figures of the recent literature), "
          "bodies (recorded pairs on other bodies), or all")
      ->required()
      ->check(CLI::IsMember({"selection", "timing", "moves", "zmp", "contact", "published", "bodies", "all"}))
      ->type_name("PART");
  add_evaluation_source(*command, arguments->source);
  command
      ->add_option("--report", arguments->report,
                   "folder for report.json and report.html; created if missing")
      ->required()
      ->type_name("DIR");
  command->add_flag("--no-variants", arguments->no_variants,
                    "leave out users of other builds (moves) and disturbed input (contact)");
  command->add_option("--queries", arguments->options.queries, "poses drawn for the recall of the search")
      ->check(CLI::Range(10, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--largest-library", arguments->options.largest_library,
                   "pairs up to which searches are timed; a million take some 2 GB of memory")
      ->check(CLI::Range(7'500, 10'000'000))
      ->type_name("PAIRS")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "report.json on stdout as well");
  arguments->settings.add_to(*command);
  command->callback([&line, arguments] {
    if (const Status done = run_evaluate(line, *arguments); !done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
