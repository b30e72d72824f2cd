#include <QDialog>
#include <QDir>
#include <QMenu>
#include <algorithm>
#include <thread>
#include <vector>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/range_words.hpp"
#include "app/workbench/compare/sweep_run.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/base/atomic_file.hpp"
#include "core/evaluation/sweep/sweep_report.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/sweep/sweep_form.hpp"
#include "widgets/sweep/sweep_panel.hpp"

namespace abrazo::app {
namespace {

using widgets::SweepPanel;

constexpr double usual_step_us = 800;       ///< until a step was measured
constexpr double share_of_measuring = 1.4;  ///< of a point's time, to that of its steps alone
constexpr double measured_s = 2;

/// Median time of the live solver's last steps.
double step_us(MainWindow& window) {
  const FrameHistory* history = window.ticker().history();
  const auto span = history ? history->span() : FrameHistory::Span{};
  if (span.frames < 20) return usual_step_us;
  std::vector<double> times;
  // Of those in memory: the estimate follows the form, and does not wait for the disk.
  for (const FrameSnapshotPtr& frame :
       history->range(std::max(span.memory_first_s, span.last_s - measured_s), span.last_s))
    times.push_back(frame->result.timing.total_us);
  if (times.empty()) return usual_step_us;
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

/// Estimated cost of the form's request, or why it is invalid.
void show_estimate(MainWindow& window, SweepPanel& panel, const SweepRun& run) {
  if (run.running()) return;
  const widgets::SweepRequest request = panel.form().request();
  const auto sweep = run.sweepOf(request, window.document().settings());
  if (!sweep) return panel.showEstimate(words(sweep.error()), false);
  const double steps = run.stepsOf(*sweep, request.takes);
  const double cores = std::max(1u, std::thread::hardware_concurrency());
  const double seconds = 1e-6 * steps * step_us(window) * share_of_measuring / cores;
  panel.showEstimate(
      QString("%1 cells, %2 thousand solved frames: %3. Everything else as in the settings now.")
          .arg(point_count(*sweep))
          .arg(steps / 1000, 0, 'f', 1)
          .arg(about(seconds)),
      true);
}

void adopt(MainWindow& window, const SweepRun& run, int point) {
  if (point < 0 || point >= run.grid().points()) return;
  Settings settings = window.document().settings();
  const auto [column, row] = run.grid().place_of(point);
  for (const auto& [side, index] : {std::pair(&run.grid().x(), column), std::pair(&run.grid().y(), row)})
    if (const Status set = set_setting(settings, side->key, side->values[static_cast<std::size_t>(index)]);
        !set)
      return window.messages().showError(words(set.error()));
  window.document().adopt(settings, "sweep: " + QString::fromStdString(run.grid().place_text(point)));
}

void export_report(MainWindow& window, QWidget* over, const SweepRun& run) {
  const QString file = widgets::choose_new_file(over, "Export the sweep",
                                                QDir(window.remembered().lastFolder()).filePath("sweep.html"),
                                                ".html", "Page (*.html);;JSON (*.json)");
  if (file.isEmpty()) return;
  const QString wrong = save_sweep(run.outcome(), file);
  wrong.isEmpty() ? window.messages().succeed("sweep", "Sweep written to " + file)
                  : window.messages().showErrorOf("sweep", wrong);
}

void connect_run(MainWindow& window, SweepPanel& panel, SweepRun& run) {
  QObject::connect(&panel, &SweepPanel::edited, &run, [&] { show_estimate(window, panel, run); });
  QObject::connect(&panel, &SweepPanel::startRequested, &run, [&](const widgets::SweepRequest& request) {
    const auto sweep = run.sweepOf(request, window.document().settings());
    if (!sweep) return panel.showEstimate(words(sweep.error()), false);
    panel.setRunning(true);
    run.start(*sweep, request.takes);
  });
  QObject::connect(&panel, &SweepPanel::cancelRequested, &run, [&] { run.cancel(); });
  QObject::connect(&panel, &SweepPanel::adoptRequested, &run, [&](int point) { adopt(window, run, point); });
  QObject::connect(&panel, &SweepPanel::exportRequested, &run, [&] { export_report(window, &panel, run); });
  QObject::connect(&panel, &SweepPanel::metricChosen, &run,
                   [&](const QString& name) { run.setMetric(name.toStdString()); });
  QObject::connect(&run, &SweepRun::gridChanged, &panel, [&] { panel.showGrid(run.grid()); });
  QObject::connect(&run, &SweepRun::progressed, &panel, &SweepPanel::showProgress);
  QObject::connect(&run, &SweepRun::ended, &panel, [&](const QString& words) {
    panel.setRunning(false);
    panel.showEstimate(words, true);
  });
  tell_progress(run, window.messages());
}

}  // namespace

QString save_sweep(const SweepOutcome& outcome, const QString& file) {
  if (!outcome.best) return "No cell has a value yet; wait for the first one";
  const bool json = file.endsWith(".json", Qt::CaseInsensitive);
  const Status written =
      write_whole_file(file.toStdString(), json ? sweep_json(outcome) : sweep_html(outcome));
  return written ? QString() : words(written.error());
}

void add_sweep_actions(MainWindow& window) {
  auto* dialog = new QDialog(&window);
  dialog->setObjectName("sweep");
  dialog->setWindowTitle("Sweep two settings");
  dialog->resize(720, 700);
  auto* column = widgets::column_in(dialog);
  auto* panel = new SweepPanel(dialog);
  column->addWidget(panel);
  auto* run = new SweepRun(&window);
  window.colour(panel);
  panel->form().setMetrics(metric_names(), "partner.mean_joint_error_m");
  connect_run(window, *panel, *run);
  QObject::connect(&window.document(), &Document::began, run, [&window, panel, run] {
    const auto& library = window.session()->material().library;
    std::vector<std::string> takes;
    for (const LibraryTake& take : library->takes()) takes.push_back(take.name);
    run->setLibrary(library);
    panel->form().setTakes(takes);
  });
  QObject::connect(&window.document(), &Document::changed, panel, [=, &window] {
    if (dialog->isVisible() && !run->running()) panel->form().setSettings(window.document().settings());
  });
  const auto open = [=, &window](const QString& key) {
    if (!run->running()) panel->form().setSettings(window.document().settings());
    if (!key.isEmpty() && !run->running()) panel->form().setColumns(key.toStdString());
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
  };
  QMenu* menu = menu_of(window, "Solve");
  add_action(window, menu, "Sweep two settings\u2026", {}, [open] { open({}); });
  QObject::connect(&window.settings(), &widgets::SettingsPanel::sweepRequested, dialog, open);
}

}  // namespace abrazo::app
