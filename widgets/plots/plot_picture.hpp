#pragma once

#include <QByteArray>
#include <QColor>
#include <QImage>
#include <QSize>
#include <vector>

#include "widgets/plots/plot_pane.hpp"

namespace abrazo::widgets {

/// What is exported: all panes, also those that have no room on the screen, in at least this size.
struct PlotSheet {
  const std::vector<PlotPane*>& panes;
  const SampleTable& table;
  PlotView view;
  QColor ground;
  QSize size;
};

/// @param scale  pixels a point
QImage plot_picture(const PlotSheet& sheet, double scale);
QByteArray plot_svg(const PlotSheet& sheet);

}  // namespace abrazo::widgets
