#include "core/evaluation/report/report_html.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/base/xml_text.hpp"
#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/report/html_page.hpp"
#include "core/evaluation/report/html_paper.hpp"
#include "core/evaluation/report/html_sections.hpp"

namespace abrazo {

namespace {

std::string fact(std::string_view name, const std::string& text) {
  return "<dt>" + xml_text(name) + "</dt><dd>" + xml_text(text) + "</dd>\n";
}

/// The tables of takes name all.
std::string some_takes(const std::vector<std::string>& takes) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t t = 0; t < takes.size() && t < most; ++t) text += (t > 0 ? ", " : "") + takes[t];
  return takes.size() > most ? fmt::format("{} and {} more", text, takes.size() - most) : text;
}

std::string settings_text(const Settings& settings) {
  const PresetDifference nearest = nearest_preset(settings);
  std::string text = "preset " + nearest.preset;
  for (std::size_t i = 0; i < nearest.keys.size(); ++i)
    text += fmt::format("{}{} {}", i == 0 ? ", but " : ", ", nearest.keys[i],
                        setting_text(settings, nearest.keys[i]));
  return text;
}

std::string facts(const Evaluation& evaluation) {
  std::string inner =
      fact("library", fmt::format("{}, {} pairs{}", evaluation.data, number_text(evaluation.library_pairs, 1),
                                  evaluation.both_roles ? ", either performer active in every frame" : ""));
  inner += fact("answered",
                fmt::format("{} {}: {}", count_text(static_cast<int>(evaluation.takes.size()), "take"),
                            evaluation.users.empty() ? "of the library, each by the others"
                                                     : "of " + evaluation.users + ", by the whole library",
                            some_takes(evaluation.takes)));
  inner += fact("settings", settings_text(evaluation.settings));
  inner += fact("step rate", evaluation.step_rate_hz > 0 ? plain_number(evaluation.step_rate_hz) + " Hz"
                                                         : "each take's own, at most 120 Hz");
  inner += fact("took", evaluation.seconds < 120 ? number_text(evaluation.seconds, 2) + " s"
                                                 : number_text(evaluation.seconds / 60, 2) + " min");
  if (!evaluation.remarks.empty())
    inner += fact("remarks", count_text(static_cast<int>(evaluation.remarks.size()), "remark") +
                                 " at the end of the page");
  return "<dl class=\"facts\">\n" + inner + "</dl>\n";
}

std::string paper_rates(const Style& style) {
  if (style.fight && !style.dance) return "paper 92.31 % (fight)";
  if (style.dance && !style.fight) return "paper 96.30 % (expert), 85.00 and 83.87 % (beginners)";
  return "paper 96.30 % (dance), 92.31 % (fight)";
}

std::string paper_zmp_ratio(const Style& style) {
  if (style.fight && !style.dance) return "paper 0.99 (2.21 / 2.24)";
  if (style.dance && !style.fight) return "paper 1.03 (0.72 / 0.70)";
  return "paper 1.03 (dance), 0.99 (fight)";
}

void add_result_tiles(const Evaluation& evaluation, std::vector<HtmlTile>& tiles) {
  const UserResult& result = *evaluation.result;
  const Style style = style_of(evaluation);
  if (evaluation.has_moves && result.moves.all.total > 0)
    tiles.push_back({"successful moves", percent_text(result.moves.all.rate()), paper_rates(style)});
  if (evaluation.has_zmp && result.zmp.original_m > 0)
    tiles.push_back({"ZMP error, synthesised / original",
                     number_text(result.zmp.synthesised_m / result.zmp.original_m, 3),
                     paper_zmp_ratio(style)});
  tiles.push_back(
      {"partner's joint error, mean", number_text(100 * result.partner.mean_joint_error_m) + " cm",
       "median " + number_text(100 * result.partner.median_joint_error_m) + " cm; not in the paper"});
  if (const MovementFigures& f = result.movement.all; !result.movement.takes.empty())
    tiles.push_back({"partner's speed, 99th percentile", number_text(f.speed_p99_m_s) + " m/s",
                     "captured " + number_text(f.captured_speed_p99_m_s) + " m/s; accelerated " +
                         number_text(f.acceleration_ratio, 2) + " times as hard"});
  if (evaluation.has_contact && result.contact.holds.holds > 0)
    tiles.push_back({"change of hand holds, mean",
                     number_text(100 * result.contact.holds.change_mean_m) + " cm",
                     percent_text(result.contact.holds.kept) + " kept; not in the paper"});
  if (result.solve.steps > 0)
    tiles.push_back({"one whole step", number_text(result.solve.p50_us / 1000) + " ms",
                     "99th percentile " + number_text(result.solve.p99_us / 1000) +
                         " ms; paper 67 ms (15 frames a second)"});
}

std::vector<HtmlTile> tiles(const Evaluation& evaluation) {
  std::vector<HtmlTile> tiles;
  if (!evaluation.selection.empty())
    if (const SelectionRow* row = row_for(evaluation.selection.back(), 10))
      tiles.push_back({fmt::format("best pair in the 10 nearest, {} Hz",
                                   plain_number(evaluation.selection.back().rate_hz)),
                       percent_text(row->recall_best), "paper 95.07 %"});
  for (const TimingRow& row : evaluation.timing)
    if (row.pairs == 30000)
      tiles.push_back(
          {"selection among 30\u202f000 pairs", number_text(row.knn_us / 1000) + " ms", "paper 15.0 ms"});
  if (evaluation.result) add_result_tiles(evaluation, tiles);
  return tiles;
}

}  // namespace

std::string report_html(const Evaluation& evaluation) {
  HtmlPage page;
  page.title = "Evaluation on " + evaluation.data;
  page.subtitle =
      "The experiments of Ho, Chan, Komura and Leung, Interactive Partner Control in Close Interactions for "
      "Real-Time Applications (2013), section 4, and what goes beyond them";
  page.head_html = facts(evaluation) + html_tiles(tiles(evaluation));
  for (const auto section : {selection_section, timing_section, moves_section, zmp_section, movement_section,
                             contact_section, published_section, bodies_section, robustness_section})
    if (auto made = section(evaluation)) page.sections.push_back(std::move(*made));
  page.sections.push_back(settings_section(evaluation.settings));
  if (!evaluation.remarks.empty())
    page.sections.push_back({"remarks", "Remarks", "Remarks",
                             html_notes("What a reader of these figures should know", evaluation.remarks)});
  return html_page(page);
}

}  // namespace abrazo
