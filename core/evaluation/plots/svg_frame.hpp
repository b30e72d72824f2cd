#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/evaluation/plots/svg_axis.hpp"
#include "core/evaluation/plots/svg_canvas.hpp"

namespace abrazo {

// Common parts of line and bar plots: title, legend and axes.

inline constexpr double plot_width = 480, plot_margin = 8, plot_text_size = 12;
inline constexpr std::string_view reference_dashes = "6 4";

struct LegendEntry {
  std::string name, colour;
  int shape = -1;  ///< of its markers; -1: a filled square, or only a dashed line
  bool dashed = false;
};

/// Where the data are drawn.
struct PlotArea {
  double left, top, right, bottom;
};

/// The n-th series of ours, or of others.
std::string series_colour(int own_index, bool reference);

/// Title and, below it, the legend, broken into rows. @return where the plot may begin
double draw_head(SvgCanvas& canvas, const std::string& title, const std::vector<LegendEntry>& legend);

void draw_vertical_axis(SvgCanvas& canvas, const PlotArea& area, const AxisScale& scale,
                        const std::string& title);

/// Below the area; numbers that would overlap are left out.
void draw_horizontal_axis(SvgCanvas& canvas, const PlotArea& area, const AxisScale& scale,
                          const std::string& title, bool grid);

}  // namespace abrazo
