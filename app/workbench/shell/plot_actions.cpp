#include <QAction>
#include <QBuffer>
#include <QCursor>
#include <QDateTime>
#include <QMenu>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "core/base/atomic_file.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/plots/plot_menu.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::PlotExport;
using widgets::PlotPanel;

constexpr double picture_scale = 2;  // pixels a point
constexpr double plot_zoom_step = 0.7;

QString ending_of(PlotExport what) {
  return what == PlotExport::Csv ? "csv" : what == PlotExport::Png ? "png" : "svg";
}

std::string content_of(PlotPanel& plots, PlotExport what) {
  if (what == PlotExport::Csv) return plots.csv();
  if (what == PlotExport::Svg) return plots.svg().toStdString();
  QByteArray content;
  QBuffer buffer(&content);
  plots.picture(picture_scale).save(&buffer, "PNG");
  return content.toStdString();
}

void choose_export(MainWindow& window, PlotExport what) {
  const QString ending = ending_of(what);
  const QString name = "plots-" + QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss") + "." + ending;
  const QString file = ask_new_file(&window, window.remembered(), "Export plots", name, "." + ending,
                                    QString("%1 (*.%2);;All files (*)").arg(ending.toUpper(), ending));
  if (file.isEmpty()) return;
  const QString trouble = save_plots(window, what, file);
  trouble.isEmpty() ? window.messages().succeed("plots", "Plots written to " + file)
                    : window.messages().showErrorOf("plots", trouble);
}

void add_panes(MainWindow& window, QMenu* menu) {
  PlotPanel& plots = window.plots();
  add_action(window, menu, "Add plot…", {}, [&window, &plots] {
    window.panels().want("plots", true);
    auto* choice = new QMenu(&window);
    choice->setAttribute(Qt::WA_DeleteOnClose);
    widgets::fill_new_pane_menu(*choice, plots);
    choice->popup(QCursor::pos());
  });
  add_action(window, menu, "Default plots", {}, [&plots] { plots.restoreUsual(); });
}

/// Going back to the live end also moves the plots there, even if only they had been moved away.
void follow_with(MainWindow& window) {
  PlotPanel& plots = window.plots();
  QObject::connect(&plots, &PlotPanel::followRequested, &window.ticker(), &FrameTicker::follow);
  QObject::connect(&window.transport(), &widgets::TransportBar::followRequested, &plots, &PlotPanel::attach);
  for (QAction* action : window.actions())
    if (action->shortcuts().contains(QKeySequence("End")))
      QObject::connect(action, &QAction::triggered, &plots, &PlotPanel::attach);
}

}  // namespace

QString save_plots(MainWindow& window, widgets::PlotExport what, const QString& file) {
  const Status written = write_whole_file(file.toStdString(), content_of(window.plots(), what));
  return written ? QString() : words(written.error());
}

void add_plot_actions(MainWindow& window) {
  QMenu* menu = menu_of(window, "Plots");
  PlotPanel& plots = window.plots();
  plots.setArrangement(widgets::arrangement_of(window.remembered().plots().toStdString()));
  QObject::connect(&plots, &PlotPanel::arrangementChanged, &window, [&window, &plots] {
    window.remembered().setPlots(QString::fromStdString(widgets::text_of(plots.arrangement())));
  });
  QObject::connect(&plots, &PlotPanel::exportRequested, &window,
                   [&window](PlotExport what) { choose_export(window, what); });
  follow_with(window);
  add_panes(window, menu);
  menu->addSeparator();
  add_action(window, menu, "Shorter time in the plots", {}, [&plots] { plots.zoom(plot_zoom_step); });
  add_action(window, menu, "Longer time in the plots", {}, [&plots] { plots.zoom(1 / plot_zoom_step); });
  add_action(window, menu, "Plots follow again", {}, [&plots] { plots.attach(); });
  menu->addSeparator();
  for (const auto& [name, what] : {std::pair{"Export plot samples (CSV)…", PlotExport::Csv},
                                   {"Export plot picture (PNG)…", PlotExport::Png},
                                   {"Export plot drawing (SVG)…", PlotExport::Svg}})
    add_action(window, menu, name, {}, [&window, what = what] { choose_export(window, what); });
}

}  // namespace abrazo::app
