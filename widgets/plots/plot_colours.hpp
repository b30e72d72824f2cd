#pragma once

#include "widgets/common/palette.hpp"
#include "widgets/plots/plot_series.hpp"

class QCustomPlot;

namespace abrazo::widgets {

/// Colour of a curve: what belongs to a character has that one's. Series that fit into one pane by their unit
/// and are of one group differ.
QColor colour_of(Series series, const Palette& palette);

/// Sums are dashed, so that they stand apart from their parts.
bool is_dashed(Series series);

/// Ground, axes and grid of a plot over time.
void set_frame_colours(QCustomPlot& plot, const Palette& palette);

}  // namespace abrazo::widgets
