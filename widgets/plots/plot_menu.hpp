#pragma once

class QMenu;
class QPoint;

namespace abrazo::widgets {

class PlotPanel;

/// Menu of a pane: its series, position, panes to add, and export. Series of another unit are disabled, with
/// what to do instead.
void fill_pane_menu(QMenu& menu, PlotPanel& panel, int pane);
void show_pane_menu(PlotPanel& panel, int pane, const QPoint& global);

/// One entry per group of series for a new pane.
void fill_new_pane_menu(QMenu& menu, PlotPanel& panel);

}  // namespace abrazo::widgets
