#pragma once

#include <QByteArray>
#include <QColor>
#include <QImage>
#include <QSize>
#include <vector>

#include "widgets/plots/plot_pane.hpp"

namespace abrazo::widgets {

/// Export sheet: all panes, including those without room on the screen, in at least this size.
struct PlotSheet {
  const std::vector<PlotPane*>& panes;
  const SampleTable& table;
  PlotView view;
  QColor ground;
  QSize size;
};

/// @param scale pixels per point
QImage plot_picture(const PlotSheet& sheet, double scale);
QByteArray plot_svg(const PlotSheet& sheet);

}  // namespace abrazo::widgets
