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

/// The line above a pane's curves: title, the key with its values, and at the right the mark.
struct PlotHead {
  const PaneSeries& series;
  const std::optional<SeriesValues>& values;
  const Palette& palette;
  PlotMark mark = PlotMark::None;
  std::string title = {};  ///< empty: that of the series
};

/// Where there is no room for the values the names stay, and at last the names without the title.
void paint_plot_head(QPainter& painter, const QRectF& place, const PlotHead& head);

}  // namespace abrazo::widgets
