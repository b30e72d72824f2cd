#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_plot.hpp"
#include "core/evaluation/report/html_paper.hpp"
#include "core/evaluation/report/html_sections.hpp"

namespace abrazo {

namespace {

std::string interval_text(int part, int total) {
  const ShareInterval interval = share_interval(part, total);
  return fmt::format("{:.0f} \u2013 {:.0f}\u00a0%", 100 * interval.low, 100 * interval.high);
}

std::string rate_text(int part, int total) {
  return percent_text(total > 0 ? static_cast<double>(part) / total : not_known, 2);
}

std::string label_name(const std::string& label) {
  std::string name = label.empty() ? "(no label)" : label;
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

bool resembles(const paper::MoveRow& row, const Style& style) {
  const bool fight = row.experiment.starts_with("fighting");
  return fight ? style.fight : style.dance;
}

void own_row(HtmlTable& html, const std::string& name, const MoveCount& count) {
  html.row({name, std::to_string(count.total), std::to_string(count.successful),
            rate_text(count.successful, count.total), interval_text(count.successful, count.total),
            rate_text(count.lenient, count.total)});
}

std::string experiment_name(const Evaluation& evaluation) {
  if (evaluation.users.empty()) return evaluation.data + ", leave one take out";
  return evaluation.users + " answered by " + evaluation.data;
}

std::string success_table(const Evaluation& evaluation) {
  HtmlTable html("Success rates of the synthesised motions.",
                 {"experiment", "moves", "successful", "success rate", "95 % interval", "lenient"});
  for (const paper::MoveRow& row : paper::table_3)
    html.row(
        {"paper: " + std::string(row.experiment), std::to_string(row.total), std::to_string(row.successful),
         rate_text(row.successful, row.total), interval_text(row.successful, row.total), ""},
        HtmlTable::Row::Paper);
  const MoveTable& moves = evaluation.result->moves;
  own_row(html, experiment_name(evaluation), moves.all);
  for (const UserResult& user : evaluation.builds) own_row(html, user.user, user.moves.all);
  html.row({"by chance: always the library's most frequent move", std::to_string(moves.all.total), "",
            percent_text(moves.by_chance, 2), "", ""},
           HtmlTable::Row::Baseline);
  return html.html();
}

std::string counts_table(const std::string& caption, const std::string& what,
                         const std::map<std::string, MoveCount>& counts, bool labels) {
  HtmlTable html(caption, {what, "moves", "successful", "success rate", "95 % interval", "lenient"});
  for (const auto& [name, count] : counts) own_row(html, labels ? label_name(name) : name, count);
  return html.html();
}

std::string label_bars(const MoveTable& moves) {
  BarPlot plot{.title = "Success rate by label",
               .value = {.title = "moves (%)", .minimum = 0, .maximum = 100},
               .series = {{.name = "strict"}, {.name = "lenient"}}};
  for (const auto& [label, count] : moves.per_label) {
    if (count.total == 0) continue;
    plot.groups.push_back(fmt::format("{} ({})", label_name(label), count.total));
    plot.series[0].values.emplace_back(100 * count.rate());
    plot.series[1].values.emplace_back(100.0 * count.lenient / count.total);
  }
  if (moves.by_chance > 0) plot.lines.push_back({"by chance, all moves", 100 * moves.by_chance});
  return svg_bar_plot(plot);
}

std::string experiment_bars(const Evaluation& evaluation) {
  BarPlot plot{
      .title = "Success rate by experiment",
      .value = {.title = "moves (%)", .minimum = 0, .maximum = 100},
      .series = {{.name = "paper", .reference = true}, {.name = "here, strict"}, {.name = "here, lenient"}}};
  const auto add = [&](const std::string& name, std::optional<double> printed, const MoveCount* own) {
    plot.groups.push_back(name);
    plot.series[0].values.push_back(printed);
    const bool counted = own != nullptr && own->total > 0;
    plot.series[1].values.push_back(counted ? std::optional(100 * own->rate()) : std::nullopt);
    plot.series[2].values.push_back(counted ? std::optional(100.0 * own->lenient / own->total)
                                            : std::nullopt);
  };
  for (const paper::MoveRow& row : paper::table_3)
    add(std::string(row.experiment), 100.0 * row.successful / row.total, nullptr);
  add(experiment_name(evaluation), std::nullopt, &evaluation.result->moves.all);
  for (const UserResult& user : evaluation.builds) add(user.user, std::nullopt, &user.moves.all);
  return svg_bar_plot(plot);
}

int sum(const std::vector<int>& row) {
  return std::accumulate(row.begin(), row.end(), 0);
}

std::string confusion_map(const std::string& title, const MoveTable& moves,
                          const std::vector<std::vector<int>>& counts, bool as_share) {
  HeatMap map{.title = title,
              .column_title = "answered by pairs labelled",
              .row_title = "the user's move",
              .value_title = as_share ? "share of the row" : ""};
  std::vector<std::size_t> used_columns;
  for (std::size_t c = 0; c < moves.labels.size(); ++c) {
    used_columns.push_back(c);
    map.columns.push_back(label_name(moves.labels[c]));
  }
  for (std::size_t r = 0; r < counts.size() && r < moves.labels.size(); ++r) {
    const int total = sum(counts[r]);
    if (total == 0) continue;  // what is no move has columns only
    map.rows.push_back(label_name(moves.labels[r]));
    std::vector<HeatCell>& row = map.cells.emplace_back();
    for (const std::size_t c : used_columns) {
      const int count = counts[r][c];
      const double share = static_cast<double>(count) / total;
      row.push_back({.value = share,
                     .text = count == 0 ? std::string()
                             : as_share ? fmt::format("{:.0f}\u00a0%", 100 * share)
                                        : std::to_string(count),
                     .tooltip = fmt::format("{} answered by {}: {} of {}", map.rows.back(), map.columns[c],
                                            count, total)});
    }
  }
  return svg_heat_map(map);
}

struct Miss {
  std::string own, answer;
  int count = 0, total = 0;
};

Miss most_frequent_miss(const MoveTable& moves) {
  Miss most;
  for (std::size_t r = 0; r < moves.confusion.size(); ++r)
    for (std::size_t c = 0; c < moves.confusion[r].size(); ++c)
      if (r != c && moves.confusion[r][c] > most.count)
        most = {label_name(moves.labels[r]), label_name(moves.labels[c]), moves.confusion[r][c],
                sum(moves.confusion[r])};
  return most;
}

std::string beside(const MoveCount& count, const paper::MoveRow& row) {
  const ShareInterval own = share_interval(count.successful, count.total);
  const ShareInterval printed = share_interval(row.successful, row.total);
  const bool overlap = own.low <= printed.high && printed.low <= own.high;
  return fmt::format("{} here against {} printed for {}: the 95 % intervals of so few moves ({} and {}) {}.",
                     rate_text(count.successful, count.total), rate_text(row.successful, row.total),
                     row.experiment, interval_text(count.successful, count.total),
                     interval_text(row.successful, row.total),
                     overlap ? "overlap" : "do not overlap, so the difference is not one of counting");
}

std::vector<std::string> move_notes(const Evaluation& evaluation) {
  const MoveTable& moves = evaluation.result->moves;
  const Style style = style_of(evaluation);
  std::vector<std::string> notes;
  for (const paper::MoveRow& row : paper::table_3)
    if (resembles(row, style) && row.experiment.find("leave one out") != std::string_view::npos)
      notes.push_back(beside(moves.all, row));
  notes.emplace_back(
      "The labels are not the paper's: it publishes neither label files nor definitions. What counts as one "
      "move, where it begins, and which of two similar labels it has, changes these rates.");
  if (moves.all.lenient > moves.all.successful)
    notes.push_back(fmt::format(
        "{} of the {} that failed have the label that their annotation names as an alternative (lenient).",
        count_text(moves.all.lenient - moves.all.successful, "move"),
        moves.all.total - moves.all.successful));
  if (const Miss miss = most_frequent_miss(moves); miss.count > 0)
    notes.push_back(fmt::format("The most frequent miss: {} answered as {}, {} of {}.", miss.own, miss.answer,
                                miss.count, count_text(miss.total, "move")));
  const auto worst =
      std::min_element(moves.per_label.begin(), moves.per_label.end(),
                       [](const auto& a, const auto& b) { return a.second.rate() < b.second.rate(); });
  if (worst != moves.per_label.end() && worst->second.rate() < moves.all.rate())
    notes.push_back(fmt::format("The label with the lowest rate is {} ({} of {}).{}",
                                label_name(worst->first), worst->second.successful, worst->second.total,
                                worst->second.total == 1 && evaluation.users.empty()
                                    ? " It is the only one among the takes answered; where no other take has "
                                      "one, none is left to be found."
                                    : ""));
  return notes;
}

std::string move_finding(const Evaluation& evaluation) {
  const MoveTable& moves = evaluation.result->moves;
  if (moves.all.total == 0)
    return "No take that was answered has labelled moves, so there is no success rate.";
  return fmt::format(
      "{} of {} are successful, {} ({} with the annotators' alternatives). {} of the steps within moves come "
      "from a pair with the move's label. Answering always with the most frequent move would give {}.",
      moves.all.successful, count_text(moves.all.total, "move"),
      rate_text(moves.all.successful, moves.all.total), rate_text(moves.all.lenient, moves.all.total),
      percent_text(moves.step_accuracy), percent_text(moves.by_chance));
}

std::vector<std::string> move_definitions(const Evaluation& evaluation) {
  std::vector<std::string> texts = {
      std::string("Success rate = successful moves / all moves (Eq. 12). A move is a labelled interval of a "
                  "take; frames labelled \u201cother\u201d or \u201cguard\u201d are none. ") +
          (evaluation.users.empty()
               ? "Each take is answered by the library of the other takes, its own frames left out. "
               : "Takes of the users are answered by the whole library. ") +
          "Every step has the label of the library pair that was selected for it. A move is successful when "
          "more of its steps have its own label than any other (with equal numbers its own counts). Lenient: "
          "the label may also be the alternative that the annotation names. 95 % interval: Wilson's, for "
          "independent moves.",
      "Failed steps do not count. By chance: the share of moves that have the move label most frequent among "
      "the library's pairs."};
  if (evaluation.both_roles)
    texts.emplace_back(
        "Either performer may be the active one in every frame. Who attacks is part of the move: an attack "
        "of the user that is answered as an attack of the partner is a miss.");
  if (!evaluation.builds.empty())
    texts.emplace_back(
        "Other builds: the captured user with other bone lengths (directions of bones kept, the path scaled "
        "with the legs) is retargeted to the library's body and answered as before. Retargeting undoes such "
        "lengths wherever the limbs can reach, so equal figures say that it is exact; people of that size "
        "would also move differently.");
  return texts;
}

}  // namespace

std::optional<HtmlSection> moves_section(const Evaluation& evaluation) {
  if (!evaluation.result || !evaluation.has_moves) return std::nullopt;
  const MoveTable& moves = evaluation.result->moves;
  std::string content = html_finding(move_finding(evaluation)) + success_table(evaluation);
  if (moves.all.total > 0)
    content +=
        html_figures({experiment_bars(evaluation), label_bars(moves)}) +
        html_notes("Beside the paper", move_notes(evaluation)) +
        html_figures({confusion_map("Moves: label of most steps", moves, moves.confusion, false),
                      confusion_map("Steps within moves", moves, moves.steps, true)}) +
        html_side_by_side({counts_table("By label of the user's move.", "label", moves.per_label, true),
                           counts_table("By take.", "take", moves.per_take, false)});
  return HtmlSection{"table-3", "Table III \u2014 success rates of the moves (4.2 \u2013 4.4)",
                     "III \u00b7 moves", content + html_definitions(move_definitions(evaluation))};
}

}  // namespace abrazo
