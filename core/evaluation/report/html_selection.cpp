#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/units.hpp"
#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_plot.hpp"
#include "core/evaluation/report/html_paper.hpp"
#include "core/evaluation/report/html_sections.hpp"

namespace abrazo {

namespace {

constexpr int paper_k = 10;
std::string points_text(double difference) {
  return number_text(100 * std::abs(difference), std::abs(difference) < 0.1 ? 2 : 3) + " points";
}

/// "3.1 points below", "as high as".
std::string compared(double ours, double theirs) {
  const double difference = ours - theirs;
  if (std::abs(difference) < 0.0005) return "as high as";
  return points_text(difference) + (difference > 0 ? " above" : " below");
}

std::string rate_name(const SelectionTable& table) {
  return plain_number(table.rate_hz) + " Hz";
}

std::vector<int> all_k(const std::vector<SelectionTable>& tables) {
  std::set<int> ks;
  for (const SelectionTable& table : tables)
    for (const SelectionRow& row : table.rows) ks.insert(row.k);
  return {ks.begin(), ks.end()};
}

std::string selection_table(const std::vector<SelectionTable>& tables) {
  std::vector<std::string> columns = {"k"};
  for (const SelectionTable& table : tables) columns.push_back("best found, " + rate_name(table));
  columns.emplace_back("best found, paper");
  for (const SelectionTable& table : tables) columns.push_back("one of best two, " + rate_name(table));
  columns.insert(columns.end(), {"one of best two, paper", "left over, " + rate_name(tables.front()),
                                 "time (ms), " + rate_name(tables.front()), "time (ms), paper"});
  HtmlTable html(
      "Share of queries in which the k nearest hold the best pair, or one of the best two; by how much the "
      "best of the k is farther than the best of all (left over); and the time of one selection.",
      columns);
  for (const int k : all_k(tables)) {
    std::vector<std::string> cells = {std::to_string(k)};
    const paper::SelectionRow* printed = paper::selection_row(k);
    for (const bool two : {false, true}) {
      for (const SelectionTable& table : tables) {
        const SelectionRow* row = row_for(table, k);
        cells.push_back(percent_text(!row ? not_known : two ? row->recall_best2 : row->recall_best, 2));
      }
      cells.push_back(percent_text(!printed ? not_known
                                   : two    ? printed->recall_best2
                                            : printed->recall_best,
                                   2));
    }
    const SelectionRow* full = row_for(tables.front(), k);
    cells.push_back(percent_text(full ? full->pose_excess : not_known, 2));
    cells.push_back(number_text(full ? full->query_us / us_per_ms : not_known));
    cells.push_back(fixed_text(printed ? printed->time_ms : not_known, 1));
    html.row(cells);
  }
  return html.html();
}

std::string recall_plot(const std::vector<SelectionTable>& tables, bool two) {
  LinePlot plot{.title = two ? "One of the best two pairs is among the k" : "The best pair is among the k",
                .x = {.title = "k, nearest neighbours looked at", .minimum = 0, .maximum = 50},
                .y = {.title = "share of queries (%)", .maximum = 100}};
  for (const SelectionTable& table : tables) {
    PlotSeries series{.name = "here, " + rate_name(table)};
    for (const SelectionRow& row : table.rows) {
      series.points.emplace_back(row.k, 100 * (two ? row.recall_best2 : row.recall_best));
      plot.x.maximum = std::max<double>(*plot.x.maximum, row.k);
    }
    plot.series.push_back(std::move(series));
  }
  PlotSeries printed{.name = "paper", .reference = true};
  for (const paper::SelectionRow& row : paper::table_1)
    printed.points.emplace_back(row.k, 100 * (two ? row.recall_best2 : row.recall_best));
  plot.series.push_back(std::move(printed));
  return svg_line_plot(plot);
}

std::string selection_finding(const std::vector<SelectionTable>& tables) {
  const double printed = paper::selection_row(paper_k)->recall_best;
  std::string text;
  for (const SelectionTable& table : tables)
    if (const SelectionRow* row = row_for(table, paper_k))
      text += fmt::format(
          "{} {} pairs a second the best pair is among the {} nearest in {} of {} queries, {} the {} of the "
          "paper. ",
          text.empty() ? "With" : "With the library thinned to", plain_number(table.rate_hz), paper_k,
          percent_text(row->recall_best), number_text(table.queries, 1), compared(row->recall_best, printed),
          percent_text(printed, 2));
  return text;
}

std::vector<std::string> selection_notes(const std::vector<SelectionTable>& tables) {
  std::vector<std::string> notes;
  const SelectionRow* full = row_for(tables.front(), paper_k);
  const SelectionRow* thinned = tables.size() > 1 ? row_for(tables.back(), paper_k) : nullptr;
  if (full && thinned) {
    const double gain = thinned->recall_best - full->recall_best;
    if (gain > 0.005)
      notes.push_back(
          fmt::format("Near duplicates take places in the list of k. At {} frames are {} ms apart and all "
                      "but equal, so the {} nearest are few moments, each several times. Thinning the "
                      "library to {}, and nothing else, raises the share by {}.",
                      rate_name(tables.front()), number_text(1000 / tables.front().rate_hz, 2), paper_k,
                      rate_name(tables.back()), points_text(gain)));
    else
      notes.push_back(
          fmt::format("Thinning the library to {} changes the share by {}{}: near duplicates do not explain "
                      "what is missed here.",
                      rate_name(tables.back()), gain < 0 ? "\u2212" : "+", points_text(gain)));
  }
  if (full)
    notes.push_back(
        fmt::format("What the misses cost: the best of the {} is on average {} farther from the query (rms "
                    "over the joints) than the best of all.",
                    paper_k, percent_text(full->pose_excess)));
  return notes;
}

}  // namespace

const SelectionRow* row_for(const SelectionTable& table, int k) {
  const auto found =
      std::find_if(table.rows.begin(), table.rows.end(), [k](const SelectionRow& row) { return row.k == k; });
  return found == table.rows.end() ? nullptr : &*found;
}

std::optional<HtmlSection> selection_section(const Evaluation& evaluation) {
  const std::vector<SelectionTable>& tables = evaluation.selection;
  if (tables.empty()) return std::nullopt;
  const std::string where =
      evaluation.users.empty()
          ? "Each is a frame of a take and searched in the other takes"
          : "Each is a frame of " + evaluation.users + " and searched in the whole library";
  std::string pairs;
  for (const SelectionTable& table : tables)
    pairs += fmt::format("{}{} pairs at {}", pairs.empty() ? "" : ", ", number_text(table.pairs, 1),
                         rate_name(table));
  return HtmlSection{
      "table-1", "Table I \u2014 accuracy of the pose selection (4.1)", "I \u00b7 selection",
      html_finding(selection_finding(tables)) + selection_table(tables) +
          html_figures({recall_plot(tables, false), recall_plot(tables, true)}) +
          html_notes("Beside the paper", selection_notes(tables)) +
          html_definitions(
              {fmt::format("Queries: {} poses drawn at random. {} ({} on average). The paper drew 1000 poses "
                           "of novice users, dance and fight together, who are not in its library.",
                           number_text(tables.front().queries, 1), where, pairs),
               "M_A: the k nearest by Euclidean distance of the 15 features (head, hands and feet of the "
               "normalised active pose), exact kd-tree. M_B: all pairs, compared by the first term of Eq. 7, "
               "the sum over 25 joints of squared distances of normalised poses. A single pose has no past, "
               "so the temporal terms are left out. Best and second best are M_B's. Left over: square root "
               "of the cost of the best among the k over that of the best of all, minus 1, mean over the "
               "queries.",
               "Time: median of one search with Eq. 7 over the k, one core."})};
}

namespace {

double power_of_growth(const TimingRow& first, const TimingRow& last, double TimingRow::*time) {
  return std::log(last.*time / first.*time) /
         std::log(static_cast<double>(last.pairs) / static_cast<double>(first.pairs));
}

std::string timing_table(const std::vector<TimingRow>& rows) {
  HtmlTable html(
      "Time of one selection. M_A: 10 nearest neighbours and Eq. 7 over them; M_B: Eq. 7 over all pairs.",
      {"pairs", "of them generated", "M_A (ms)", "M_B (ms)", "M_B / M_A", "M_A, paper (ms)",
       "M_B, paper (ms)", "M_B / M_A, paper"});
  for (const TimingRow& row : rows) {
    const paper::TimingRow* printed = paper::timing_row(row.pairs);
    html.row({number_text(row.pairs, 1), number_text(row.generated, 1), number_text(row.knn_us / us_per_ms),
              number_text(row.brute_us / us_per_ms), number_text(row.brute_us / row.knn_us, 2),
              fixed_text(printed ? printed->knn_ms : not_known, 1),
              fixed_text(printed ? printed->brute_ms : not_known, 1),
              number_text(printed ? printed->brute_ms / printed->knn_ms : not_known, 2)});
  }
  return html.html();
}

std::string timing_plot(const std::vector<TimingRow>& rows) {
  PlotSeries knn{.name = "k nearest, here"}, brute{.name = "all pairs, here"};
  for (const TimingRow& row : rows) {
    if (row.knn_us > 0) knn.points.emplace_back(row.pairs, row.knn_us / us_per_ms);
    if (row.brute_us > 0) brute.points.emplace_back(row.pairs, row.brute_us / us_per_ms);
  }
  PlotSeries paper_knn{.name = "k nearest, paper", .reference = true};
  PlotSeries paper_brute{.name = "all pairs, paper", .reference = true};
  for (const paper::TimingRow& row : paper::table_2) {
    paper_knn.points.emplace_back(row.pairs, row.knn_ms);
    paper_brute.points.emplace_back(row.pairs, row.brute_ms);
  }
  return svg_line_plot({.title = "Time of one selection",
                        .x = {.title = "pairs in the library", .logarithmic = true},
                        .y = {.title = "time (ms)", .logarithmic = true},
                        .series = {knn, brute, paper_knn, paper_brute}});
}

std::string timing_finding(const std::vector<TimingRow>& rows) {
  const TimingRow& last = rows.back();
  std::string text =
      fmt::format("With {} pairs the search takes {} ms, comparing with every pair {} ms: {} times as long.",
                  number_text(last.pairs, 1), number_text(last.knn_us / us_per_ms),
                  number_text(last.brute_us / us_per_ms), number_text(last.brute_us / last.knn_us, 2));
  if (rows.size() > 1)
    text += fmt::format(
        " From {} to {} pairs M_A grows like the number of pairs to the power of {}, M_B to the power of {}.",
        number_text(rows.front().pairs, 1), number_text(last.pairs, 1),
        number_text(power_of_growth(rows.front(), last, &TimingRow::knn_us), 2),
        number_text(power_of_growth(rows.front(), last, &TimingRow::brute_us), 2));
  return text;
}

std::vector<std::string> timing_notes(const std::vector<TimingRow>& rows) {
  std::vector<std::string> notes;
  for (const TimingRow& row : rows)
    if (const paper::TimingRow* printed = paper::timing_row(row.pairs); printed && row.pairs == 30000)
      notes.push_back(
          fmt::format("At {} pairs M_A is {} times and M_B {} times as fast as printed. The paper measured "
                      "on a Core 2 Duo of 2.4 GHz; how much of the factor is the machine and how much the "
                      "code, these figures do not tell.",
                      number_text(row.pairs, 1), number_text(printed->knn_ms * us_per_ms / row.knn_us, 2),
                      number_text(printed->brute_ms * us_per_ms / row.brute_us, 2)));
  const paper::TimingRow &small = paper::table_2.front(), &large = paper::table_2.back();
  notes.push_back(
      fmt::format("In the paper M_A takes {} ms for {} pairs and {} ms for {}: most of it does not depend on "
                  "the library. So its advantage over M_B there is {} to {} times.",
                  number_text(small.knn_ms), number_text(small.pairs, 1), number_text(large.knn_ms),
                  number_text(large.pairs, 1), number_text(small.brute_ms / small.knn_ms, 2),
                  number_text(large.brute_ms / large.knn_ms, 2)));
  return notes;
}

}  // namespace

std::optional<HtmlSection> timing_section(const Evaluation& evaluation) {
  if (evaluation.timing.empty()) return std::nullopt;
  const std::vector<TimingRow>& rows = evaluation.timing;
  return HtmlSection{
      "table-2", "Table II \u2014 computation time of the two searches (4.1)", "II \u00b7 time",
      html_finding(timing_finding(rows)) + timing_table(rows) +
          html_side_by_side(
              {html_figures({timing_plot(rows)}), html_notes("Beside the paper", timing_notes(rows))}) +
          html_definitions({"Median over the queries, one core. M_A: exact kd-tree in the 15 features, 10 "
                            "neighbours, Eq. 7 with all its terms over them. M_B: Eq. 7 with all its terms "
                            "over every pair. Where the takes have fewer pairs, generated dances of other "
                            "couples fill the library; they count in the second column."})};
}

}  // namespace abrazo
