#include "widgets/plots/plot_menu.hpp"

#include <QMenu>
#include <algorithm>

#include "widgets/common/utf8.hpp"
#include "widgets/plots/plot_pane.hpp"
#include "widgets/plots/plot_panel.hpp"

namespace abrazo::widgets {
namespace {

void add_series(QMenu& menu, PlotPanel& panel, int pane) {
  const PaneSeries shown = panel.pane(pane).series();
  bool some_refused = false;
  std::string_view group;
  for (const SeriesInfo& info : all_series()) {
    if (!group.empty() && info.group != group) menu.addSeparator();
    group = info.group;
    QAction* action = menu.addAction(text(info.name) + " [" + text(info.unit) + "]");
    const bool on = std::ranges::find(shown, info.series) != shown.end();
    const std::string refusal = why_not(shown, info.series);
    action->setCheckable(true);
    action->setChecked(on);
    action->setEnabled(refusal.empty() && !(on && shown.size() == 1));
    action->setToolTip(refusal.empty() ? text(info.meaning) : text(refusal));
    some_refused |= !refusal.empty();
    QObject::connect(action, &QAction::toggled, &panel, [&panel, pane, series = info.series](bool wanted) {
      panel.setShown(pane, series, wanted);
    });
  }
  if (!some_refused) return;
  menu.addSeparator();
  menu.addAction("Disabled: another unit; add a pane for it")->setEnabled(false);
}

void add_export(QMenu& menu, PlotPanel& panel) {
  const auto add = [&](const QString& name, PlotExport what) {
    menu.addAction(name, &panel, [&panel, what] { panel.askFor(what); });
  };
  add("Export samples (CSV)…", PlotExport::Csv);
  add("Export picture (PNG)…", PlotExport::Png);
  add("Export drawing (SVG)…", PlotExport::Svg);
}

}  // namespace

void fill_new_pane_menu(QMenu& menu, PlotPanel& panel) {
  for (const std::string_view group : series_groups())
    menu.addAction(text(group), &panel, [&panel, group] { panel.addPane(usual_series(group)); })
        ->setEnabled(panel.paneCount() < static_cast<int>(most_panes));
}

void fill_pane_menu(QMenu& menu, PlotPanel& panel, int pane) {
  menu.setToolTipsVisible(true);
  QMenu* series = menu.addMenu("Series of this pane");
  series->setToolTipsVisible(true);
  add_series(*series, panel, pane);
  fill_new_pane_menu(*menu.addMenu("Add a pane"), panel);
  menu.addSeparator();
  const auto move = [&](const QString& name, int by, bool possible) {
    menu.addAction(name, &panel, [&panel, pane, by] { panel.movePane(pane, by); })->setEnabled(possible);
  };
  const int arranged = static_cast<int>(panel.arrangement().size());
  if (pane == panel.selectionPane()) {
    menu.addAction("Same part of the other character", &panel,
                   [&panel] { panel.askFor(other_character(panel.selection())); });
    menu.addAction("Select nothing", &panel, [&panel, pane] { panel.removePane(pane); });
  } else {
    move("Move to the left", -1, pane > 0);
    move("Move to the right", 1, pane + 1 < arranged);
    menu.addAction("Remove this pane", &panel, [&panel, pane] { panel.removePane(pane); })
        ->setEnabled(arranged > 1);
  }
  menu.addAction("Default panes", &panel, &PlotPanel::restoreUsual);
  menu.addSeparator();
  add_export(menu, panel);
}

void show_pane_menu(PlotPanel& panel, int pane, const QPoint& global) {
  if (pane < 0 || pane >= panel.paneCount()) return;
  auto* menu = new QMenu(&panel);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  fill_pane_menu(*menu, panel, pane);
  menu->popup(global);
}

}  // namespace abrazo::widgets
