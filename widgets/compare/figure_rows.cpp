#include "widgets/compare/figure_rows.hpp"

#include <cmath>
#include <cstdio>

namespace abrazo::widgets {
namespace {

constexpr std::size_t most_named = 4;  // settings that fit into a line

std::string number(double value, int decimals, bool with_sign = false) {
  char text[48];
  std::snprintf(text, sizeof text, with_sign ? "%+.*f" : "%.*f", decimals, value);
  return text;
}

/// A typographic minus is as wide as a digit, so that columns of differences stay in line.
std::string with_minus(std::string text) {
  if (!text.empty() && text[0] == '-') text.replace(0, 1, "−");
  return text;
}

std::string name_of(const SettingInfo& info) {
  return std::string(info.symbol.empty() ? info.title : info.symbol);
}

}  // namespace

FigureRow figure_row(RunFigure figure, const RunFigures& a, const RunFigures& b) {
  const RunFigureInfo& info = info_of(figure);
  const double in_a = info.scale * a[static_cast<std::size_t>(figure)];
  const double in_b = info.scale * b[static_cast<std::size_t>(figure)];
  const auto written = [&](double value) {
    return std::isfinite(value) ? number(value, info.decimals) : std::string("—");
  };
  FigureRow row{std::string(info.name), std::string(info.unit), std::string(info.help),
                written(in_a),          written(in_b),          {},
                Better::Neither};
  if (!std::isfinite(in_a) || !std::isfinite(in_b)) return row;
  if (row.a == row.b) {
    row.difference = "=";
    return row;
  }
  row.difference = with_minus(number(in_b - in_a, info.decimals, true));
  row.better = in_b < in_a ? Better::B : Better::A;
  return row;
}

std::vector<FigureRow> figure_rows(const RunFigures& a, const RunFigures& b) {
  std::vector<FigureRow> rows;
  for (std::size_t i = 0; i < run_figure_count; ++i)
    rows.push_back(figure_row(static_cast<RunFigure>(i), a, b));
  return rows;
}

std::vector<DifferingSetting> differing_settings(const Settings& own, const Settings& other) {
  std::vector<DifferingSetting> differing;
  for (const SettingInfo& info : all_settings()) {
    const std::string value = setting_text(own, info.key);
    if (value == setting_text(other, info.key)) continue;
    differing.push_back({name_of(info), value + (info.unit.empty() ? "" : " " + std::string(info.unit))});
  }
  return differing;
}

std::string settings_line(const Settings& own, const Settings& other) {
  for (const std::string_view name : preset_names)
    if (own == preset(name).value()) return "preset " + std::string(name);
  const auto differing = differing_settings(own, other);
  if (differing.empty()) return "same settings";
  std::string line;
  for (std::size_t i = 0; i < differing.size() && i < most_named; ++i)
    line += (i > 0 ? "   " : "") + differing[i].name + " " + differing[i].value;
  if (differing.size() > most_named)
    line += "   and " + std::to_string(differing.size() - most_named) + " more";
  return line;
}

}  // namespace abrazo::widgets
