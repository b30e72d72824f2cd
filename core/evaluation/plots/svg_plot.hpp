#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/evaluation/plots/svg_axis.hpp"

// Plots as SVG elements for a page. Colours are CSS variables of the page (--ink, --muted, --grid,
// --paper, --series-1 .. --series-7, --reference) with values for a light page built in. Okabe and Ito's
// colours that can be distinguished with any colour vision; every point, bar and cell has a <title>.

namespace abrazo {

struct PlotSeries {
  std::string name;
  std::vector<std::pair<double, double>> points = {};  ///< ascending x
  bool reference = false;                              ///< published figures: grey and dashed
};

struct LinePlot {
  std::string title;
  PlotAxis x, y;
  std::vector<PlotSeries> series = {};
};

std::string svg_line_plot(const LinePlot& plot);

struct BarSeries {
  std::string name;
  std::vector<std::optional<double>> values = {};  ///< one for each group; nothing where not measured
  bool reference = false;
};

/// A line across all bars.
struct BarLine {
  std::string name;
  double value = 0;
};

/// Horizontal bars, groups from top to bottom: their names may be long.
struct BarPlot {
  std::string title;
  PlotAxis value;
  int significant_digits = 3;  ///< of the numbers at the bars
  std::vector<std::string> groups = {};
  std::vector<BarSeries> series = {};
  std::vector<BarLine> lines = {};
};

std::string svg_bar_plot(const BarPlot& plot);

struct HeatCell {
  std::optional<double> value = {};  ///< decides the colour; nothing: an empty cell
  std::string text, tooltip;
};

struct HeatMap {
  enum class Colours {
    Tint,    ///< from the page's own colour to --series-1: zero is inconspicuous
    Viridis  ///< for values of equal importance
  };
  std::string title;
  std::string column_title = {}, row_title = {},
              value_title = {};  ///< no colour scale is drawn without a value title
  std::vector<std::string> columns = {}, rows = {};
  std::vector<std::vector<HeatCell>> cells = {};  ///< [row][column]
  double low = 0, high = 1;                       ///< values of the first and last colour
  Colours colours = Colours::Tint;
  std::optional<std::pair<int, int>> marked = {};  ///< row and column of a cell with a frame
};

std::string svg_heat_map(const HeatMap& map);

/// "#rrggbb" of the viridis scale; 0 is dark, 1 light.
std::string viridis(double fraction);

}  // namespace abrazo
