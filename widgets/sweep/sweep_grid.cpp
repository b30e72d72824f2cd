#include "widgets/sweep/sweep_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace abrazo::widgets {
namespace {

using State = SweepCell::State;

bool is_better(SweepGoal goal, double a, double b) {
  if (goal == SweepGoal::Highest) return a > b;
  if (goal == SweepGoal::NearestZero) return std::abs(a) < std::abs(b);
  return a < b;
}

const char* goal_name(SweepGoal goal) {
  if (goal == SweepGoal::Highest) return "highest";
  return goal == SweepGoal::NearestZero ? "nearest to zero" : "lowest";
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string with_unit(const std::string& value, const std::string& unit) {
  return unit.empty() ? value : value + " " + unit;
}

struct UnitEnding {
  std::string_view ending, unit;
};
/// Longer endings first: "_m_per_s" ends with "_s" too.
constexpr std::array unit_endings = {
    UnitEnding{"_m_per_s", "m/s"},  UnitEnding{"_per_s", "1/s"}, UnitEnding{"_per_100", "per 100 steps"},
    UnitEnding{"_s", "s"},          UnitEnding{"_ms", "ms"},     UnitEnding{"_m", "m"},
    UnitEnding{"_asf", "ASF units"}};

}  // namespace

std::string metric_unit(std::string_view metric) {
  for (const std::string_view whose : {".synthesised", ".captured"})
    if (metric.ends_with(whose)) metric.remove_suffix(whose.size());
  if (metric.starts_with("solve_us.")) return metric.ends_with(".steps") ? "" : "\u00b5s";
  if (metric.starts_with("movement.acceleration_") && !metric.ends_with("_ratio")) return "m/s\u00b2";
  for (const auto& [ending, unit] : unit_endings)
    if (metric.ends_with(ending)) return std::string(unit);
  return {};
}

std::string metric_words(std::string_view metric) {
  const std::string unit = metric_unit(metric);
  std::string name(metric), whose;
  for (const std::string_view ending : {".synthesised", ".captured"})
    if (name.ends_with(ending)) {
      whose = ending;
      name.erase(name.size() - ending.size());
    }
  for (const auto& [ending, of_ending] : unit_endings)
    if (name.ends_with(ending)) {
      name.erase(name.size() - ending.size());
      break;
    }
  name += whose;
  std::string words;
  for (const char c : name) words += c == '_' ? " " : c == '.' ? ": " : std::string(1, c);
  return unit.empty() ? words : words + " [" + unit + "]";
}

std::array<double, 3> sweep_colour(double fraction) {
  constexpr std::array<std::array<double, 3>, 9> anchors = {{{68, 1, 84},
                                                             {71, 45, 123},
                                                             {59, 82, 139},
                                                             {44, 114, 142},
                                                             {33, 145, 140},
                                                             {40, 174, 128},
                                                             {94, 201, 98},
                                                             {173, 220, 48},
                                                             {253, 231, 37}}};
  const double place = std::clamp(fraction, 0.0, 1.0) * (anchors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
  const double part = place - static_cast<double>(below);
  std::array<double, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = ((1 - part) * anchors[below][c] + part * anchors[below + 1][c]) / 255;
  return colour;
}

SweepGrid::SweepGrid(SweepSide x, SweepSide y, std::string metric, SweepGoal goal)
    : x_(std::move(x)),
      y_(std::move(y)),
      metric_(std::move(metric)),
      goal_(goal),
      cells_(x_.values.size() * y_.values.size()) {}

void SweepGrid::set_metric(std::string metric, SweepGoal goal) {
  metric_ = std::move(metric);
  goal_ = goal;
  for (SweepCell& cell : cells_)
    if (cell.state != State::Failed) cell = {};
}

int SweepGrid::count(State state) const {
  return static_cast<int>(std::count_if(cells_.begin(), cells_.end(),
                                        [state](const SweepCell& cell) { return cell.state == state; }));
}

std::optional<int> SweepGrid::best() const {
  std::optional<int> best;
  for (int point = 0; point < points(); ++point)
    if (cell(point).state == State::Measured &&
        (!best || is_better(goal_, cell(point).value, cell(*best).value)))
      best = point;
  return best;
}

std::optional<std::pair<double, double>> SweepGrid::range() const {
  std::optional<std::pair<double, double>> range;
  for (const SweepCell& cell : cells_) {
    if (cell.state != State::Measured) continue;
    if (!range) range = {cell.value, cell.value};
    range = {std::min(range->first, cell.value), std::max(range->second, cell.value)};
  }
  return range;
}

double SweepGrid::fraction_of(double value) const {
  const auto all = range();
  if (!all || !(all->second > all->first)) return 0.5;
  return std::clamp((value - all->first) / (all->second - all->first), 0.0, 1.0);
}

int SweepGrid::moved(int point, int right, int up) const {
  const auto [column, row] = place_of(point);
  return point_at(std::clamp(column + right, 0, columns() - 1), std::clamp(row + up, 0, rows() - 1));
}

std::string SweepGrid::place_text(int point) const {
  const auto [column, row] = place_of(point);
  return x_.title + " " + with_unit(x_.values[static_cast<std::size_t>(column)], x_.unit) + ", " + y_.title +
         " " + with_unit(y_.values[static_cast<std::size_t>(row)], y_.unit);
}

std::string SweepGrid::value_text(int point) const {
  const SweepCell& here = cell(point);
  switch (here.state) {
    case State::Measured:
      return with_unit(number(here.value), metric_unit(metric_));
    case State::Undefined:
      return "no value: " + metric_words(metric_) + " is not defined here";
    case State::Failed:
      return "failed: " + here.explanation;
    case State::Waiting:
      break;
  }
  return "not evaluated yet";
}

std::string SweepGrid::best_text() const {
  const auto where = best();
  if (!where) return {};
  const int left = count(State::Waiting);
  std::string text = left > 0 ? "Best so far (" : "Best (";
  text += std::string(goal_name(goal_)) + "): " + place_text(*where) + ": " + value_text(*where) + ".";
  const auto all = range();
  const std::string unit = metric_unit(metric_);
  if (all->second > all->first)
    text += " Range " + number(all->first) + " to " + with_unit(number(all->second), unit) + ".";
  const int equals = static_cast<int>(std::count_if(cells_.begin(), cells_.end(), [&](const SweepCell& c) {
    return c.state == State::Measured && c.value == cell(*where).value;
  }));
  if (equals > 1) text += " " + std::to_string(equals) + " cells have this same value.";
  return text;
}

}  // namespace abrazo::widgets
