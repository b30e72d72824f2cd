#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_frame.hpp"
#include "core/evaluation/plots/svg_plot.hpp"

namespace abrazo {

namespace {

using Anchor = SvgCanvas::Anchor;

constexpr double bar_height = 13, bar_pitch = 15, group_gap = 11, line_pitch = 14, number_width = 44;

struct Bar {
  const BarSeries* series;
  std::string colour;
  double value;
};

/// The bars of a group that have a value; the others take no room.
std::vector<Bar> bars_of(const BarPlot& plot, std::size_t group) {
  std::vector<Bar> bars;
  int own = 0;
  for (const BarSeries& series : plot.series) {
    const std::string colour = series_colour(own, series.reference);
    if (!series.reference) ++own;
    if (group < series.values.size() && series.values[group] && std::isfinite(*series.values[group]))
      bars.push_back({&series, colour, *series.values[group]});
  }
  return bars;
}

/// A name in at most two lines, broken where their lengths differ least.
std::vector<std::string> name_lines(const std::string& name, double width) {
  if (text_width(name, plot_text_size) <= width) return {name};
  std::size_t best = std::string::npos;
  const auto longer = [&](std::size_t at) { return std::max(at, name.size() - at); };
  for (std::size_t at = name.find(' '); at != std::string::npos; at = name.find(' ', at + 1))
    if (best == std::string::npos || longer(at) < longer(best)) best = at;
  if (best == std::string::npos) return {fitted(name, width, plot_text_size)};
  return {fitted(name.substr(0, best), width, plot_text_size),
          fitted(name.substr(best + 1), width, plot_text_size)};
}

struct Group {
  std::string name;
  std::vector<std::string> lines;  ///< of its name
  std::vector<Bar> bars;
  double height() const {
    return std::max(bar_pitch * static_cast<double>(bars.size()),
                    line_pitch * static_cast<double>(lines.size()));
  }
};

double name_width(const BarPlot& plot) {
  double width = 0;
  for (const std::string& group : plot.groups) width = std::max(width, text_width(group, plot_text_size));
  return std::min(width, 0.36 * plot_width);
}

std::vector<Group> groups_of(const BarPlot& plot) {
  std::vector<Group> groups;
  for (std::size_t g = 0; g < plot.groups.size(); ++g)
    groups.push_back({plot.groups[g], name_lines(plot.groups[g], name_width(plot)), bars_of(plot, g)});
  return groups;
}

std::vector<LegendEntry> legend_of(const BarPlot& plot) {
  std::vector<LegendEntry> legend;
  int own = 0;
  if (plot.series.size() > 1 || !plot.lines.empty())
    for (const BarSeries& series : plot.series) {
      legend.push_back({series.name, series_colour(own, series.reference)});
      if (!series.reference) ++own;
    }
  for (const BarLine& line : plot.lines)
    legend.push_back({line.name, std::string(reference_colour), -1, true});
  return legend;
}

AxisScale scale_of(const BarPlot& plot, const std::vector<Group>& groups, const PlotArea& area) {
  double low = 0, high = 0;
  for (const Group& group : groups)
    for (const Bar& bar : group.bars) low = std::min(low, bar.value), high = std::max(high, bar.value);
  for (const BarLine& line : plot.lines) low = std::min(low, line.value), high = std::max(high, line.value);
  return {plot.value, low, high, area.left, area.right, 5};
}

void draw_group(SvgCanvas& canvas, const BarPlot& plot, const Group& group, double y, double names_right,
                const AxisScale& scale) {
  double line_y = y + group.height() / 2 - line_pitch * (static_cast<double>(group.lines.size()) / 2 - 0.75);
  for (const std::string& line : group.lines) {
    canvas.text(names_right, line_y, line, {.anchor = Anchor::End, .size = plot_text_size});
    line_y += line_pitch;
  }
  const double zero = scale.at(0);
  y += (group.height() - bar_pitch * static_cast<double>(group.bars.size())) / 2;
  for (const Bar& bar : group.bars) {
    const double end = scale.at(bar.value);
    const std::string number = small_number(bar.value, 0.001, plot.significant_digits);
    canvas.rectangle(std::min(zero, end), y, std::abs(end - zero), bar_height, "fill:" + bar.colour,
                     fmt::format("{}\n{}: {}", group.name, bar.series->name, number));
    canvas.text(std::max(zero, end) + 4, y + bar_height - 2.5, number,
                {.colour = muted_colour, .size = plot_text_size - 1});
    y += bar_pitch;
  }
}

}  // namespace

std::string svg_bar_plot(const BarPlot& plot) {
  const std::vector<Group> groups = groups_of(plot);
  if (std::all_of(groups.begin(), groups.end(), [](const Group& group) { return group.bars.empty(); }))
    return {};
  const std::vector<LegendEntry> legend = legend_of(plot);
  SvgCanvas trial(plot_width, 0, "");  // a canvas needs its height first
  const double top = draw_head(trial, plot.title, legend);
  double bottom = top;
  for (const Group& group : groups) bottom += group.height() + group_gap;
  const PlotArea area{plot_margin + 8 + name_width(plot), top, plot_width - number_width, bottom};
  const AxisScale scale = scale_of(plot, groups, area);

  SvgCanvas canvas(plot_width, bottom + 46, plot.title);
  draw_head(canvas, plot.title, legend);
  draw_horizontal_axis(canvas, area, scale, plot.value.title, true);
  for (const BarLine& line : plot.lines)
    canvas.line(scale.at(line.value), top, scale.at(line.value), bottom, reference_colour, 1.5,
                reference_dashes);
  double y = top + group_gap / 2;
  for (const Group& group : groups) {
    draw_group(canvas, plot, group, y, area.left - 8, scale);
    y += group.height() + group_gap;
  }
  canvas.line(scale.at(0), top, scale.at(0), bottom, muted_colour);
  return canvas.finish();
}

}  // namespace abrazo
