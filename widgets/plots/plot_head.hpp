#pragma once

#include <QRectF>
#include <optional>
#include <string>

#include "widgets/common/palette.hpp"
#include "widgets/plots/pane_arrangement.hpp"

class QPainter;

namespace abrazo::widgets {

/// Whether the window follows the live end.
enum class PlotMark { None, Following, Detached };

/// The header of a pane: title, legend with values, and the mark at the right.
struct PlotHead {
  const PaneSeries& series;
  const std::optional<SeriesValues>& values;
  const Palette& palette;
  PlotMark mark = PlotMark::None;
  std::string title = {};  ///< empty: that of the series
};

/// Without room for the values it shows the names; without room beside the title, below it.
void paint_plot_head(QPainter& painter, const QRectF& place, const PlotHead& head);

}  // namespace abrazo::widgets
