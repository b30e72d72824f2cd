#include "core/evaluation/report/suggestion_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/json_text.hpp"
#include "core/base/statistics.hpp"
#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_plot.hpp"
#include "core/evaluation/report/html_page.hpp"

namespace abrazo {

namespace {

using TakeResult = SuggestionAgreement::TakeResult;
using Trials = std::vector<SuggestionAgreement::Trial>;

constexpr int confidence_bins = 10;

/// The ways to label that are compared.
struct Way {
  const char *key, *name;
  LabelAgreement TakeResult::*figures;
};
constexpr std::array<Way, 3> ways = {{{"suggestions", "suggestions", &TakeResult::moves},
                                      {"nearest_pose", "nearest pose alone", &TakeResult::nearest_pose},
                                      {"majority", "most frequent label", &TakeResult::majority}}};

void add_agreement(JsonText& json, const LabelAgreement& figures) {
  json.begin_object();
  json.key("frames").value(static_cast<long long>(figures.frames));
  json.key("frame_share").value(figures.frame_share());
  json.key("frame_share_lenient").value(figures.lenient_frame_share());
  json.key("moves").value(figures.truths).key("proposed").value(figures.proposed);
  json.key("found").value(figures.found).key("found_lenient").value(figures.found_lenient);
  json.key("f1").value(figures.f1()).key("f1_lenient").value(figures.lenient_f1());
  json.key("boundary_median_frames").value(percentile(figures.boundary_errors, 0.5));
  json.key("boundary_mean_frames").value(mean(figures.boundary_errors));
  json.end_object();
}

void add_reliability(JsonText& json, const Trials& trials) {
  const auto bins = reliability(trials, confidence_bins);
  json.begin_object().key("calibration_error").value(calibration_error(bins)).key("bins").begin_array();
  for (const ReliabilityBin& bin : bins) {
    if (bin.count == 0) continue;
    json.begin_object().key("count").value(bin.count).key("confidence").value(bin.mean_confidence);
    json.key("right").value(bin.right).key("right_lenient").value(bin.right_lenient).end_object();
  }
  json.end_array().end_object();
}

std::vector<std::string> cells(const std::string& name, const LabelAgreement& figures) {
  return {name,
          percent_text(figures.frame_share()),
          percent_text(figures.lenient_frame_share()),
          number_text(figures.truths),
          number_text(figures.proposed),
          number_text(figures.found),
          fixed_text(figures.f1(), 3),
          fixed_text(figures.lenient_f1(), 3),
          figures.boundary_errors.empty() ? "\u2013" : number_text(percentile(figures.boundary_errors, 0.5)),
          figures.boundary_errors.empty() ? "\u2013" : number_text(mean(figures.boundary_errors))};
}

HtmlTable agreement_table(const std::string& caption, const std::string& of) {
  return HtmlTable(caption, {of, "frames that agree", "lenient", "moves", "suggested", "found",
                             "F1 at IoU 0.5", "lenient", "boundary error, median (frames)", "mean"});
}

std::string agreement_section(const SuggestionAgreement& agreement) {
  HtmlTable all = agreement_table("All takes, each labelled from the others.", "way");
  for (const Way& way : ways)
    all.row(cells(way.name, agreement.all(way.figures)),
            way.figures == &TakeResult::moves ? HtmlTable::Row::Own : HtmlTable::Row::Baseline);
  HtmlTable each = agreement_table("Suggestions, take by take.", "take");
  for (const TakeResult& take : agreement.takes) each.row(cells(take.take, take.moves));
  return all.html() + each.html() +
         html_definitions(
             {"Frames that agree: of the labelled frames, those with the same label. Found: a labelled move "
              "with a suggestion of its label that covers half of what the two cover together (IoU 0.5). F1: "
              "harmonic mean of found / moves and found / suggested. Boundary error: of the found moves' "
              "starts and ends. Lenient: what the annotation names as an alternative (alt=) counts as "
              "well."});
}

std::string label_section(const SuggestionAgreement& agreement) {
  HtmlTable table("Moves of each label.", {"label", "moves", "suggested", "found", "found, lenient"});
  std::vector<std::string> names;
  for (const auto& [label, count] : agreement.labels) {
    table.row({label, number_text(count.truths), number_text(count.proposed), number_text(count.found),
               number_text(count.found_lenient)});
    names.push_back(label);
  }
  HeatMap map{.title = "Frames of a label (rows) that were suggested as (columns), per cent of the row",
              .column_title = "suggested",
              .row_title = "annotated",
              .columns = names,
              .rows = names,
              .high = 100};
  for (const std::string& row : names) {
    long all = 0;
    for (const auto& [key, frames] : agreement.confusion) all += key.first == row ? frames : 0;
    std::vector<HeatCell> line;
    for (const std::string& column : names) {
      const auto found = agreement.confusion.find({row, column});
      const double share = found == agreement.confusion.end() || all == 0
                               ? 0
                               : 100.0 * static_cast<double>(found->second) / static_cast<double>(all);
      line.push_back({share, share < 0.5 ? "" : fixed_text(share, 0),
                      row + " as " + column + ": " + fixed_text(share, 1) + " %"});
    }
    map.cells.push_back(std::move(line));
  }
  return table.html() + html_figures({svg_heat_map(map)});
}

std::string confidence_section(const SuggestionAgreement& agreement) {
  LinePlot plot{.title = "How often a suggestion was right, by how sure it was",
                .x = {.title = "confidence (%)", .minimum = 0, .maximum = 100},
                .y = {.title = "right (%)", .minimum = 0, .maximum = 100}};
  HtmlTable table("Suggestions by their confidence.",
                  {"of", "confidence (%)", "suggestions", "right (%)", "right, lenient (%)"});
  for (const auto& [name, trials] : {std::pair<const char*, const Trials&>{"labels", agreement.move_trials},
                                     {"roles", agreement.role_trials}}) {
    PlotSeries series{.name = name};
    for (const ReliabilityBin& bin : reliability(trials, confidence_bins)) {
      if (bin.count == 0) continue;
      series.points.emplace_back(100 * bin.mean_confidence, 100 * bin.right);
      table.row({name, fixed_text(100 * bin.mean_confidence, 0), number_text(bin.count),
                 fixed_text(100 * bin.right, 0), fixed_text(100 * bin.right_lenient, 0)});
    }
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back({.name = "as sure as right", .points = {{0, 0}, {100, 100}}, .reference = true});
  const double of_labels = calibration_error(reliability(agreement.move_trials, confidence_bins));
  return html_finding(fmt::format("Confidence and share right differ by {} points on average.",
                                  number_text(100 * of_labels, 2))) +
         html_side_by_side({table.html(), html_figures({svg_line_plot(plot)})}) +
         html_definitions({"A label was right when a labelled move of it covers half of what the two cover "
                           "together, a role when most of the interval's frames have it."});
}

std::string role_section(const SuggestionAgreement& agreement) {
  HtmlTable table("Who is active, with the take's own roles unknown.",
                  {"take", "frames", "agree", "intervals", "suggested"});
  for (const TakeResult& take : agreement.takes)
    if (take.role_frames > 0)
      table.row({take.take, number_text(static_cast<double>(take.role_frames), 1),
                 percent_text(static_cast<double>(take.role_agreed) / static_cast<double>(take.role_frames)),
                 number_text(take.true_roles), number_text(take.proposed_roles)});
  return html_finding(percent_text(agreement.role_share()) +
                      " of the frames have the right active performer.") +
         table.html();
}

}  // namespace

std::string suggestion_json(const SuggestionAgreement& agreement, const std::string& library) {
  JsonText json;
  json.begin_object().key("library").value(library);
  for (const Way& way : ways) add_agreement(json.key(way.key), agreement.all(way.figures));
  json.key("roles").begin_object().key("frame_share").value(agreement.role_share()).end_object();
  add_reliability(json.key("label_confidence"), agreement.move_trials);
  add_reliability(json.key("role_confidence"), agreement.role_trials);
  json.key("labels").begin_object();
  for (const auto& [label, count] : agreement.labels) {
    json.key(label).begin_object().key("moves").value(count.truths).key("proposed").value(count.proposed);
    json.key("found").value(count.found).key("found_lenient").value(count.found_lenient).end_object();
  }
  json.end_object().key("confusion").begin_array();
  for (const auto& [key, frames] : agreement.confusion)
    json.begin_object()
        .key("label")
        .value(key.first)
        .key("suggested")
        .value(key.second)
        .key("frames")
        .value(static_cast<long long>(frames))
        .end_object();
  json.end_array().key("takes").begin_array();
  for (const TakeResult& take : agreement.takes) {
    json.begin_object().key("take").value(take.take);
    for (const Way& way : ways) add_agreement(json.key(way.key), take.*way.figures);
    json.key("role_frames").value(static_cast<long long>(take.role_frames));
    json.key("role_agreed").value(static_cast<long long>(take.role_agreed));
    json.key("role_intervals").value(take.true_roles).key("proposed_roles").value(take.proposed_roles);
    json.end_object();
  }
  return json.end_array().end_object().take();
}

std::string suggestion_html(const SuggestionAgreement& agreement, const std::string& library) {
  HtmlPage page;
  page.title = "Suggested labels and roles";
  page.subtitle = library + ": " + count_text(static_cast<int>(agreement.takes.size()), "take") +
                  ", each suggested from the others";
  const LabelAgreement all = agreement.all(&TakeResult::moves),
                       pose = agreement.all(&TakeResult::nearest_pose);
  page.head_html = html_tiles(
      {{"frames that agree", percent_text(all.frame_share()),
        "nearest pose alone " + percent_text(pose.frame_share())},
       {"F1 at IoU 0.5", fixed_text(all.f1(), 3), "nearest pose alone " + fixed_text(pose.f1(), 3)},
       {"frames with the right role", percent_text(agreement.role_share()), "by chance 50 %"}});
  page.sections = {{"agreement", "Agreement with the labels", "agreement", agreement_section(agreement)},
                   {"labels", "Label by label", "labels", label_section(agreement)},
                   {"confidence", "What confidences are worth", "confidence", confidence_section(agreement)},
                   {"roles", "Roles", "roles", role_section(agreement)}};
  return html_page(page);
}

std::string suggestion_summary(const SuggestionAgreement& agreement) {
  std::string text;
  for (const Way& way : ways) {
    const LabelAgreement figures = agreement.all(way.figures);
    text += fmt::format(
        "{:<22}{:5.1f} % of frames agree (lenient {:.1f} %), F1 {:.3f} ({:.3f}), {} of {} moves found\n",
        way.name, 100 * figures.frame_share(), 100 * figures.lenient_frame_share(), figures.f1(),
        figures.lenient_f1(), figures.found, figures.truths);
  }
  text +=
      fmt::format("{:<22}{:5.1f} % of frames have the right role\n", "roles", 100 * agreement.role_share());
  text += fmt::format("{:<22}{:5.1f} points off on average\n", "confidence",
                      100 * calibration_error(reliability(agreement.move_trials, confidence_bins)));
  return text;
}

}  // namespace abrazo
