#pragma once

class QMenu;
class QPoint;

namespace abrazo::widgets {

class PlotPanel;

/// The series a pane can show, its place, panes to add, and export. Series of another unit are there, greyed,
/// with what to do instead.
void fill_pane_menu(QMenu& menu, PlotPanel& panel, int pane);
void show_pane_menu(PlotPanel& panel, int pane, const QPoint& global);

/// One entry for each group of series that a new pane can show.
void fill_new_pane_menu(QMenu& menu, PlotPanel& panel);

}  // namespace abrazo::widgets
