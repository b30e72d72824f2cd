#include "core/evaluation/sweep/sweep_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/json_text.hpp"
#include "core/base/text.hpp"
#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_plot.hpp"
#include "core/evaluation/report/html_page.hpp"
#include "core/evaluation/report/html_sections.hpp"
#include "core/evaluation/report/report_json.hpp"
#include "core/evaluation/sweep/sweep_file.hpp"

namespace abrazo {

namespace {

constexpr std::size_t listed_points = 12;

/// What else is worth seeing beside the metric: a setting that wins one figure often loses another.
struct Companion {
  std::string_view metric, title;
};
constexpr std::array<Companion, 7> companions = {{{"moves.rate", "success rate"},
                                                  {"partner.mean_joint_error_m", "joint error (m)"},
                                                  {"partner.lag_ms", "lag (ms)"},
                                                  {"partner.displacement_p99_m", "displacement, p99 (m)"},
                                                  {"contact.hold_change_mean_m", "hold change (m)"},
                                                  {"zmp.ratio", "ZMP error, synthesised / original"},
                                                  {"solve_us.p99", "step, p99 (\u00b5s)"}}};

/// For a narrow column; the path itself where there is no other name.
std::string metric_title(std::string_view metric) {
  const auto known = std::find_if(companions.begin(), companions.end(),
                                  [metric](const Companion& c) { return c.metric == metric; });
  return std::string(known == companions.end() ? metric : known->title);
}

std::optional<double> figure(const Figures& figures, std::string_view name) {
  const auto found = figures.find(std::string(name));
  return found == figures.end() ? std::nullopt : std::optional(found->second);
}

const std::string& x_value(const Sweep& sweep, int point) {
  return sweep.x.values[static_cast<std::size_t>(grid_place(sweep, point).first)];
}
const std::string& y_value(const Sweep& sweep, int point) {
  return sweep.y.values[static_cast<std::size_t>(grid_place(sweep, point).second)];
}

std::string_view goal_name(std::string_view metric) {
  switch (goal_of(metric)) {
    case FigureGoal::Highest:
      return "highest";
    case FigureGoal::NearestZero:
      return "nearest to zero";
    case FigureGoal::Lowest:
    case FigureGoal::None:
      break;
  }
  return "lowest";
}

/// Points from the best to the worst; those without a value are left out.
std::vector<int> ranked(const Sweep& sweep, const std::vector<Figures>& points) {
  std::vector<int> order;
  for (int point = 0; point < static_cast<int>(points.size()); ++point)
    if (figure(points[static_cast<std::size_t>(point)], sweep.metric)) order.push_back(point);
  const auto value = [&](int point) {
    return *figure(points[static_cast<std::size_t>(point)], sweep.metric);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return is_better(goal_of(sweep.metric), value(a), value(b)); });
  return order;
}

std::string axis_title(const SweepAxis& axis) {
  const SettingInfo& info = *find_setting(axis.key);
  std::string title = axis.key;
  if (!info.symbol.empty()) title += ", " + std::string(info.symbol);
  if (!info.unit.empty()) title += " (" + std::string(info.unit) + ")";
  return title;
}

/// Rows from the last value of y at the top to the first at the bottom, as in a plot.
std::string heat_map(const SweepOutcome& outcome) {
  const Sweep& sweep = outcome.sweep;
  const int rows = static_cast<int>(sweep.y.values.size());
  HeatMap map{.title = sweep.metric,
              .column_title = axis_title(sweep.x),
              .row_title = axis_title(sweep.y),
              .value_title = sweep.metric,
              .columns = sweep.x.values,
              .rows = {sweep.y.values.rbegin(), sweep.y.values.rend()},
              .cells = std::vector<std::vector<HeatCell>>(static_cast<std::size_t>(rows)),
              .colours = HeatMap::Colours::Viridis};
  const std::vector<int> order = ranked(sweep, outcome.points);
  const auto value = [&](int point) {
    return *figure(outcome.points[static_cast<std::size_t>(point)], sweep.metric);
  };
  const auto [low, high] =
      std::minmax_element(order.begin(), order.end(), [&](int a, int b) { return value(a) < value(b); });
  map.low = value(*low);
  map.high = value(*high);
  for (int point = 0; point < point_count(sweep); ++point) {
    const auto here = figure(outcome.points[static_cast<std::size_t>(point)], sweep.metric);
    const std::size_t row = static_cast<std::size_t>(rows - 1 - grid_place(sweep, point).second);
    map.cells[row].push_back(
        {.value = here,
         .text = number_text(here.value_or(not_known)),
         .tooltip =
             fmt::format("{} {}, {} {}\n{}: {}", sweep.x.key, x_value(sweep, point), sweep.y.key,
                         y_value(sweep, point), sweep.metric, number_text(here.value_or(not_known), 5))});
  }
  const auto [x, y] = grid_place(sweep, *outcome.best);
  map.marked = std::pair(rows - 1 - y, x);
  return svg_heat_map(map);
}

std::string best_table(const SweepOutcome& outcome) {
  const Sweep& sweep = outcome.sweep;
  std::vector<int> order = ranked(sweep, outcome.points);
  order.resize(std::min(order.size(), listed_points));
  std::vector<std::string> columns = {sweep.x.key, sweep.y.key, metric_title(sweep.metric)};
  for (const auto& [name, title] : companions)
    if (name != sweep.metric) columns.emplace_back(title);
  HtmlTable html(order.size() < outcome.points.size()
                     ? fmt::format("The {} best points and what else was measured there.", order.size())
                     : "All points, best first, and what else was measured there.",
                 columns);
  for (const int point : order) {
    const Figures& figures = outcome.points[static_cast<std::size_t>(point)];
    std::vector<std::string> cells = {x_value(sweep, point), y_value(sweep, point),
                                      number_text(*figure(figures, sweep.metric), 4)};
    for (const auto& [name, title] : companions)
      if (name != sweep.metric) cells.push_back(number_text(figure(figures, name).value_or(not_known)));
    html.row(cells);
  }
  return html.html();
}

/// At an end of the values, and the setting itself could go on.
bool at_edge(const SweepAxis& axis, int index) {
  const SettingInfo& info = *find_setting(axis.key);
  const auto value = parse_number(axis.values[static_cast<std::size_t>(index)]);
  const bool is_end = index == 0 || index + 1 == static_cast<int>(axis.values.size());
  return value && axis.values.size() > 1 && is_end && *value > info.minimum && *value < info.maximum;
}

std::vector<std::string> notes(const SweepOutcome& outcome) {
  const Sweep& sweep = outcome.sweep;
  const auto [x, y] = grid_place(sweep, *outcome.best);
  std::vector<std::string> texts;
  for (const auto& [axis, index] : {std::pair(&sweep.x, x), std::pair(&sweep.y, y)})
    if (at_edge(*axis, index))
      texts.push_back(fmt::format("The best point lies at the edge of {} ({}): a better one may lie beyond.",
                                  axis->key, axis->values[static_cast<std::size_t>(index)]));
  const std::vector<int> order = ranked(sweep, outcome.points);
  const auto value = [&](int point) {
    return *figure(outcome.points[static_cast<std::size_t>(point)], sweep.metric);
  };
  const auto equals = std::count_if(order.begin(), order.end(),
                                    [&](int point) { return value(point) == value(*outcome.best); });
  if (equals > 1)
    texts.push_back(fmt::format("{} points have this same value; the first of them is marked.", equals));
  texts.emplace_back(
      "The best of many points is flattered by chance: try it on takes that the sweep has not seen.");
  return texts;
}

std::string finding(const SweepOutcome& outcome) {
  const Sweep& sweep = outcome.sweep;
  const std::vector<int> order = ranked(sweep, outcome.points);
  const auto value = [&](int point) {
    return *figure(outcome.points[static_cast<std::size_t>(point)], sweep.metric);
  };
  return fmt::format("{} is best ({}) at {} {} and {} {}: {}. Over the {} it reaches from there to {}.",
                     sweep.metric, goal_name(sweep.metric), sweep.x.key, x_value(sweep, *outcome.best),
                     sweep.y.key, y_value(sweep, *outcome.best), number_text(value(*outcome.best), 4),
                     count_text(static_cast<int>(outcome.points.size()), "point"),
                     number_text(value(order.back()), 4));
}

}  // namespace

std::string settings_options(const Settings& settings) {
  const PresetDifference nearest = nearest_preset(settings);
  std::string text = "--preset " + nearest.preset;
  for (const std::string& key : nearest.keys) text += " --" + key + " " + setting_text(settings, key);
  return text;
}

std::optional<int> best_point(const Sweep& sweep, const std::vector<Figures>& points) {
  const std::vector<int> order = ranked(sweep, points);
  return order.empty() ? std::nullopt : std::optional(order.front());
}

std::string sweep_json(const SweepOutcome& outcome) {
  const Sweep& sweep = outcome.sweep;
  JsonText json;
  json.begin_object();
  write_sweep_head(json, sweep);
  json.key("goal").value(goal_name(sweep.metric));
  const auto [best_x, best_y] = grid_place(sweep, *outcome.best);
  json.key("best").begin_object().key("x").value(best_x).key("y").value(best_y);
  json.key("value").value(*figure(outcome.points[static_cast<std::size_t>(*outcome.best)], sweep.metric));
  json.key("options").value(settings_options(settings_at(sweep, *outcome.best))).end_object();
  json.key("points").begin_array();
  for (int point = 0; point < point_count(sweep); ++point)
    write_sweep_point(json, sweep, point, outcome.points[static_cast<std::size_t>(point)]);
  json.end_array();
  return finished_with_settings(json, sweep.settings) + "\n";
}

std::string sweep_html(const SweepOutcome& outcome) {
  const Sweep& sweep = outcome.sweep;
  HtmlPage page;
  page.title = fmt::format("{} over {} and {}", sweep.metric, sweep.x.key, sweep.y.key);
  page.subtitle = fmt::format("A sweep on {}: {}, everything else as in the settings below", sweep.data,
                              count_text(static_cast<int>(outcome.points.size()), "point"));
  page.sections.push_back(
      {"grid", "The grid", "Grid",
       html_finding(finding(outcome)) +
           html_side_by_side(
               {html_figures({heat_map(outcome)}), html_notes("Before adopting it", notes(outcome))}) +
           html_definitions(
               {fmt::format("Each point is an evaluation of all takes with its two settings; {} is the "
                            "figure of that path in report.json. Lengths in metres, times in the unit named.",
                            sweep.metric)})});
  page.sections.push_back({"best", "The best points", "Best points", best_table(outcome)});
  page.sections.push_back({"adopt", "How to use the best point", "How to use it",
                           html_finding("As options of abrazo evaluate, synth and live:") +
                               html_code(settings_options(settings_at(sweep, *outcome.best)))});
  page.sections.push_back(settings_section(sweep.settings, {sweep.x.key, sweep.y.key}));
  return html_page(page);
}

}  // namespace abrazo
