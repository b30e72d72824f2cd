#pragma once

#include "widgets/common/palette.hpp"
#include "widgets/plots/plot_series.hpp"

class QCustomPlot;

namespace abrazo::widgets {

/// Colour of a curve: series of a character have its colour. Series of one group and unit have different
/// colours.
QColor colour_of(Series series, const Palette& palette);

/// Sums are dashed, to distinguish them from their parts.
bool is_dashed(Series series);

/// Sets background, axes and grid of a plot over time.
void set_frame_colours(QCustomPlot& plot, const Palette& palette);

}  // namespace abrazo::widgets
