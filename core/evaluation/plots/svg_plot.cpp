#include "core/evaluation/plots/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/evaluation/plots/html_text.hpp"
#include "core/evaluation/plots/svg_frame.hpp"

namespace abrazo {

namespace {

constexpr double line_plot_height = 320;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value) { low = std::min(low, value), high = std::max(high, value); }
  bool empty() const { return !(low <= high); }
};

std::vector<LegendEntry> legend_of(const std::vector<PlotSeries>& series) {
  std::vector<LegendEntry> legend;
  int own = 0, shape = 0;
  for (const PlotSeries& one : series) {
    legend.push_back({one.name, series_colour(own, one.reference), shape++, one.reference});
    if (!one.reference) ++own;
  }
  return legend;
}

double largest_tick_width(const std::vector<double>& ticks) {
  double width = 0;
  for (const double tick : ticks) width = std::max(width, text_width(plain_number(tick), plot_text_size));
  return width;
}

void draw_series(SvgCanvas& canvas, const LinePlot& plot, const PlotSeries& series, const LegendEntry& look,
                 const AxisScale& x, const AxisScale& y) {
  std::string points;
  for (const auto& [px, py] : series.points)
    points += coordinate(x.at(px)) + "," + coordinate(y.at(py)) + " ";
  canvas.polyline(points, look.colour, look.dashed ? reference_dashes : "");
  for (const auto& [px, py] : series.points)
    canvas.marker(x.at(px), y.at(py), look.shape, look.colour,
                  fmt::format("{}\n{}: {}\n{}: {}", series.name, plot.x.title, number_text(px, 4),
                              plot.y.title, number_text(py, 4)));
}

}  // namespace

std::string svg_line_plot(const LinePlot& plot) {
  Range xs, ys;
  for (const PlotSeries& series : plot.series)
    for (const auto& [x, y] : series.points) xs.include(x), ys.include(y);
  if (xs.empty()) return {};
  SvgCanvas canvas(plot_width, line_plot_height, plot.title);
  const std::vector<LegendEntry> legend = legend_of(plot.series);
  const double top = draw_head(canvas, plot.title, legend);
  const double bottom = line_plot_height - 46;
  const AxisScale y(plot.y, ys.low, ys.high, bottom, top, 5);
  const PlotArea area{plot_margin + 24 + largest_tick_width(y.ticks()) + 6, top, plot_width - 18, bottom};
  const AxisScale x(plot.x, xs.low, xs.high, area.left, area.right, 7);
  draw_vertical_axis(canvas, area, y, plot.y.title);
  draw_horizontal_axis(canvas, area, x, plot.x.title, false);
  canvas.line(area.left, bottom, area.right, bottom, muted_colour);
  for (std::size_t s = 0; s < plot.series.size(); ++s)
    draw_series(canvas, plot, plot.series[s], legend[s], x, y);
  return canvas.finish();
}

}  // namespace abrazo
