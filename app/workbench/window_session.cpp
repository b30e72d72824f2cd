#include <QMetaMethod>
#include <algorithm>

#include "app/workbench/job.hpp"
#include "app/workbench/main_window.hpp"
#include "app/workbench/panel_area.hpp"
#include "app/workbench/status_figures.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {

void MainWindow::openDemo() {
  openMaterial(make_demo);
}

void MainWindow::openFiles(const QStringList& files) {
  const auto motions = std::count_if(files.begin(), files.end(),
                                     [](const QString& file) { return is_motion_file(file.toStdString()); });
  // Without anyone to ask, load_material refuses them.
  if (motions > 1 && isSignalConnected(QMetaMethod::fromSignal(&MainWindow::motionsOffered)))
    return emit motionsOffered(files);
  std::vector<std::string> names;
  for (const QString& file : files) names.push_back(file.toStdString());
  const Material open = m_session ? m_session->material() : Material{};
  openMaterial([names, open](const Progress& progress) { return load_material(names, open, progress); },
               files);
}

void MainWindow::openMaterial(MakeMaterial make, const QStringList& files) {
  const Settings wanted = m_settings->settings();
  Job::retire(std::move(m_job), this);
  m_job = std::make_unique<Job>(
      [this, make = std::move(make), wanted, files](const Progress& progress) -> Job::Finish {
        auto material = make(progress);
        if (!material)
          return [this, text = material.error().text()] { showFailure(QString::fromStdString(text)); };
        report(progress, 1, "Indexing the library");
        auto prepared = prepare_solver(std::move(material).value(), wanted);
        if (!prepared)
          return [this, text = prepared.error().text()] { showFailure(QString::fromStdString(text)); };
        // Shared only because std::function must be copyable.
        auto ready = std::make_shared<PreparedSolver>(std::move(prepared).value());
        return [this, ready, files] {
          start(ready);
          if (!files.isEmpty()) emit filesOpened(files);
        };
      });
  m_messages->showProgress("Opening", 0);
  connect(m_job.get(), &Job::progressed, m_messages,
          [this](double fraction, const QString& doing) { m_messages->showProgress(doing, fraction); });
  connect(m_job.get(), &Job::finished, m_messages, &widgets::MessageBar::endProgress);
}

void MainWindow::start(const std::shared_ptr<PreparedSolver>& prepared) {
  emit sessionEnding();
  m_ticker.setSources(nullptr, nullptr);
  m_plots->clear();
  m_session.reset();
  m_session = std::make_unique<LiveSession>(std::move(*prepared));
  m_session->push(SetSettings{m_settings->settings()});  // they may have changed while the worker ran
  const Material& material = m_session->material();
  m_scene->setLibrary(material.library);
  m_candidates->setLibrary(material.library);
  m_timeline->setLibrary(material.library);
  m_takes->setLibrary(material.library);
  const QString library = QString::fromStdString(material.library->name());
  const QString input = QString::fromStdString(material.input.name);
  m_panels->setHead("library", "Library · " + library);
  m_transport->setInput(QString("%1 %2 · %3 Hz")
                            .arg(material.recorded ? "recorded" : "clip", input)
                            .arg(material.input.fps, 0, 'f', 0));
  m_status->setInput(input, material.library->pair_count());
  setWindowTitle(input + " with " + library + " — Abrazo");
  m_ticker.setSources(&m_session->history(), &m_session->latest());
  QStringList warnings;
  for (const std::string& warning : material.warnings) warnings << QString::fromStdString(warning);
  m_messages->showWarnings(warnings);
  emit sessionStarted();
}

void MainWindow::startWith(const Settings& settings) {
  m_settings->showSettings(settings);
  if (m_session) m_session->push(SetSettings{settings});
}

void MainWindow::showFailure(const QString& message) {
  m_messages->showError(message);
  emit failed(message);
}

}  // namespace abrazo::app
