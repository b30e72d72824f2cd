#include <fmt/format.h>

#include <cmath>

#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_plot.hpp"
#include "core/evaluation/report/html_sections.hpp"

namespace abrazo {

namespace {

constexpr std::size_t drawn_percent = 99;  ///< beyond it single steps would set the scale

std::string row_text(const MovementRow& row, double value) {
  const std::string number = number_text(row.scale * value);
  return std::isfinite(value) && !row.unit.empty() ? number + " " + std::string(row.unit) : number;
}

std::string movement_figures(const MovementTable& movement) {
  HtmlTable html("How the partner moves; mean over the takes, or the largest.",
                 {"figure", "captured", "synthesised"});
  for (const MovementRow& row : movement_rows())
    html.row({std::string(row.title), row.captured ? row_text(row, movement.all.*row.captured) : "",
              row_text(row, movement.all.*row.made)});
  return html.html();
}

std::string movement_per_take(const MovementTable& movement) {
  HtmlTable html("Take by take.", {"take", "joint error (cm)", "speed, p99 (m/s)", "captured",
                                   "acceleration, times the captured", "sliding (m/s)", "captured",
                                   "captured holds held", "changes (1/s)"});
  for (std::size_t t = 0; t < movement.takes.size(); ++t) {
    const MovementFigures& f = movement.per_take[t];
    html.row({movement.takes[t], number_text(100 * f.partner_error_m), number_text(f.speed_p99_m_s),
              number_text(f.captured_speed_p99_m_s), number_text(f.acceleration_ratio),
              number_text(f.slide_m_s), number_text(f.captured_slide_m_s),
              percent_text(f.captured_holds_held), number_text(f.changes_per_s)});
  }
  return html.html();
}

PlotSeries shares_below(std::string name, const Percentiles& percentiles) {
  PlotSeries series{.name = std::move(name)};
  for (std::size_t percent = 0; percent <= drawn_percent; ++percent)
    series.points.emplace_back(percentiles[percent], static_cast<double>(percent));
  return series;
}

/// Nothing when neither was measured.
std::string distribution_plot(const std::string& title, const std::string& unit, const Percentiles& captured,
                              const Percentiles& made) {
  LinePlot plot{.title = title,
                .x = {.title = unit, .minimum = 0},
                .y = {.title = "share below (%)", .minimum = 0, .maximum = 100}};
  if (!captured.empty()) plot.series.push_back(shares_below("captured partner", captured));
  if (!made.empty()) plot.series.push_back(shares_below("synthesised", made));
  return plot.series.empty() ? "" : svg_line_plot(plot);
}

std::string movement_finding(const MovementTable& movement) {
  const MovementFigures& f = movement.all;
  std::string text = fmt::format(
      "The partner moves at {} m/s in the 99th percentile, the captured one at {} m/s; its joints are "
      "accelerated {} times as hard. ",
      number_text(f.speed_p99_m_s), number_text(f.captured_speed_p99_m_s),
      number_text(f.acceleration_ratio, 2));
  if (std::isfinite(f.slide_m_s))
    text += fmt::format("Its landed feet slide at {} m/s ({}), {} of the time faster than 0.3 m/s ({}). ",
                        number_text(f.slide_m_s, 2), number_text(f.captured_slide_m_s, 2),
                        percent_text(f.slide_share_fast, 0), percent_text(f.captured_slide_share_fast, 0));
  if (std::isfinite(f.captured_holds_held))
    text += fmt::format("Of the holds of the capture {} are held. ", percent_text(f.captured_holds_held, 0));
  return text + fmt::format(
                    "The source changes {} times a second, and plays at its own pace in {} of the "
                    "steps between.",
                    number_text(f.changes_per_s, 2), percent_text(f.source_pace_share, 0));
}

std::vector<std::string> movement_definitions() {
  return {
      "Each figure is computed per take and averaged over the takes with equal weights; the largest "
      "steps are the largest of all takes. The captured partner is measured at the same steps. Speed: mean "
      "over the 25 joints of the displacement from step to step by the time between. Acceleration: change of "
      "the joints' velocities from one step to the next by the time between, root mean square over the "
      "joints.",
      "Sliding: horizontal speed of a toe base while it is less than 3 cm above its rest at both ends of the "
      "step. Rest: 5th percentile of the height of the same toe base in the whole captured take. Height of "
      "locked toe bases: above that rest, while the foot is locked.",
      "Hold: hand ends of the two bodies within 13 cm. Of the selected pair: |distance in the result \u2212 "
      "distance in the selected pair| while the selected pair holds. Of the capture: while the captured "
      "dancers hold; held within 20 cm in the result, recall within 13 cm. Precision: of the holds of the "
      "result (13 cm), those within 20 cm in the capture.",
      "Change of source: the selection reports it, or the pair is from another take or role, earlier, or "
      "more than 1/3 s later in the take than the one before. Pace: source time divided by elapsed time, at "
      "the other steps. Beyond what its own velocity explains: distance of the joints, on average, from "
      "where "
      "the velocities of the step before would have brought them."};
}

}  // namespace

std::optional<HtmlSection> movement_section(const Evaluation& evaluation) {
  if (!evaluation.result || evaluation.result->movement.takes.empty()) return std::nullopt;
  const MovementTable& movement = evaluation.result->movement;
  return HtmlSection{
      "movement", "How the partner moves", "Movement",
      html_finding(movement_finding(movement)) +
          html_side_by_side({movement_figures(movement), movement_per_take(movement)}) +
          html_figures(
              {distribution_plot("Speed of the partner", "mean over the joints (m/s)",
                                 movement.captured.speed_m_s, movement.made.speed_m_s),
               distribution_plot("Acceleration of the partner's joints", "root mean square (m/s\u00b2)",
                                 movement.captured.acceleration_m_s2, movement.made.acceleration_m_s2),
               distribution_plot("Sliding of landed feet", "speed of toe bases (m/s)",
                                 movement.captured.slide_m_s, movement.made.slide_m_s),
               distribution_plot("Pace of the source", "time in the take by time that passed", {},
                                 movement.pace)}) +
          html_definitions(movement_definitions())};
}

}  // namespace abrazo
