#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "widgets/plots/plot_series.hpp"

namespace abrazo::widgets {

/// Which series each pane draws, in order. A pane has one vertical axis, so its series share a unit.
using PaneSeries = std::vector<Series>;
using PaneArrangement = std::vector<PaneSeries>;

inline constexpr std::size_t most_panes = 8;

/// Energies, residuals, cost terms.
PaneArrangement default_arrangement();

/// A pane takes a series of the unit it has; an empty one takes any.
bool can_join(const PaneSeries& pane, Series series);

/// Why not, and what to do instead; empty when it can.
std::string why_not(const PaneSeries& pane, Series series);

/// "Residuals [mm]"; of several groups the first with an ellipsis.
std::string title_of(const PaneSeries& pane);

/// The names of the groups, in order, and what each has.
std::vector<std::string_view> series_groups();
PaneSeries series_of_group(std::string_view group);
/// What a new pane for a group starts with: those that say most together.
PaneSeries usual_series(std::string_view group);

/// As it is remembered: keys with commas, panes with semicolons. What is not known (of another version) or
/// does not fit in its pane is left out; the default when nothing is left.
std::string text_of(const PaneArrangement& panes);
PaneArrangement arrangement_of(std::string_view text);

/// How the panes stand in the room there is.
struct PaneGrid {
  int rows = 1, columns = 1;
  int shown = 0;           ///< the rest has no room
  bool collapsed = false;  ///< only the heads with their values
};
PaneGrid plan_panes(int panes, int width_px, int height_px);

}  // namespace abrazo::widgets
