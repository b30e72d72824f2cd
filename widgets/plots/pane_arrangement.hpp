#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "widgets/plots/plot_series.hpp"

namespace abrazo::widgets {

/// The series of each pane, in order. A pane has one vertical axis, so its series share a unit.
using PaneSeries = std::vector<Series>;
using PaneArrangement = std::vector<PaneSeries>;

inline constexpr std::size_t most_panes = 8;

/// Energies, residuals, cost terms.
PaneArrangement default_arrangement();

/// A pane accepts series of its unit; an empty one accepts any.
bool can_join(const PaneSeries& pane, Series series);

/// Whether two panes show the same quantity: they have one scale, so that their curves can be compared.
bool share_scale(const PaneSeries& a, const PaneSeries& b);

/// Why not, and what to do instead; empty if it can join.
std::string why_not(const PaneSeries& pane, Series series);

/// "Residuals [mm]"; for several groups the first with an ellipsis.
std::string title_of(const PaneSeries& pane);

/// The names of the groups, in order, and their series.
std::vector<std::string_view> series_groups();
PaneSeries series_of_group(std::string_view group);
/// Initial series of a new pane for a group: the most informative ones.
PaneSeries usual_series(std::string_view group);

/// Stored form: keys separated by commas, panes by semicolons. Unknown series (of another version) and those
/// that do not fit their pane are left out; the default if nothing is left.
std::string text_of(const PaneArrangement& panes);
PaneArrangement arrangement_of(std::string_view text);

/// Layout of the panes in the available room.
struct PaneGrid {
  int rows = 1, columns = 1;  ///< that have room
  int all_rows = 1;           ///< more than `rows`: the others are reached by scrolling
  bool collapsed = false;     ///< only headers with values
};
PaneGrid plan_panes(int panes, int width_px, int height_px);

}  // namespace abrazo::widgets
