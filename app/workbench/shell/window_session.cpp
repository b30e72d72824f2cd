#include <fmt/format.h>

#include <QCloseEvent>
#include <QMetaMethod>
#include <algorithm>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job_progress.hpp"
#include "app/workbench/base/running_work.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "core/opening/generated_set.hpp"
#include "core/opening/joint_maps.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/plots/plot_panel.hpp"

namespace abrazo::app {
namespace {

std::vector<std::string> names_of(const QStringList& files) {
  std::vector<std::string> names;
  for (const QString& file : files) names.push_back(file.toStdString());
  return names;
}

QStringList files_of(const std::vector<FileToOpen>& files, FileKind kind) {
  QStringList names;
  for (const FileToOpen& file : files)
    if (file.kind == kind) names << QString::fromStdString(file.path);
  return names;
}

}  // namespace

void MainWindow::openDemo() {
  openMaterial(generated_dance);
}

void MainWindow::openFiles(const QStringList& all, const std::optional<MotionReading>& said) {
  const std::vector<FileToOpen> known = recognised(names_of(all));
  const auto has = [&known](FileKind kind) { return std::ranges::count(known, kind, &FileToOpen::kind); };
  const QStringList videos = files_of(known, FileKind::Video);
  const auto others = static_cast<qsizetype>(known.size()) - videos.size();
  if (has(FileKind::Labels) > 0 && has(FileKind::Labels) == others) {
    if (!videos.isEmpty()) emit videosOffered(videos);
    return emit labelsOffered(files_of(known, FileKind::Labels));
  }
  if (others == 0 && !videos.isEmpty()) {
    emit videosOffered(videos);
    return session() || m_job ? void() : openDemo();
  }
  // Without a user to ask, open_files refuses them.
  if (has(FileKind::Motion) > 1 && isSignalConnected(QMetaMethod::fromSignal(&MainWindow::motionsOffered)))
    return emit motionsOffered(all);
  OpeningWish wish{known,
                   session() ? session()->material() : Material{},
                   m_remembered.jointMapFolder().toStdString(),
                   m_remembered.autosaveFolder().toStdString(),
                   said,
                   m_remembered.importRuleFolder().toStdString(),
                   m_locate};
  std::erase_if(wish.files, [](const FileToOpen& file) { return file.kind == FileKind::Video; });
  const AsksToLeave asks = has(FileKind::Session) > 0 ? AsksToLeave::BeforeReading : AsksToLeave::BeforeStart;
  openMaterial([wish = std::move(wish)](const Progress& progress) { return open_files(wish, progress); }, all,
               asks);
}

bool MainWindow::isLeft() {
  const Job* const opening = m_job.get();
  bool allowed = true;
  emit leaving(allowed);  // the answer, and saving, may take long
  return allowed && m_job.get() == opening && !m_isStopping;
}

/// A motion that the user opens takes the place of a stream; of those that were asked for at the start the
/// stream plays the user.
InputUse MainWindow::useOf(const Material& material) const {
  if (m_playsAsLive) return InputUse::ClipAsLive;
  const bool is_for_stream = m_wantsStream && !(material.is_input_asked && session());
  if (is_for_stream) return InputUse::Stream;
  return material.is_too_long_to_solve() ? InputUse::ClipAsLive : InputUse::Clip;
}

bool MainWindow::openMaterial(MakeMaterial make, const QStringList& files, AsksToLeave asks) {
  if (asks == AsksToLeave::BeforeReading && !isLeft()) return false;
  const Settings wanted = m_document->settings();
  const auto stays = session() ? session()->material().library_of_files() : nullptr;
  Job::retire(std::move(m_job), this);
  const auto open =
      [this, make = std::move(make), wanted, files, asks, stays,
       maps = m_remembered.jointMapFolder().toStdString()](const Progress& progress) -> Job::Finish {
    auto material = make(progress);
    if (!material && material.error().message == "cancelled") return {};
    if (!material)
      return [this, files, unmapped = motion_to_map(names_of(files), maps), why = words(material.error())] {
        // Without anyone to ask it is a failure like any other.
        if (unmapped && isSignalConnected(QMetaMethod::fromSignal(&MainWindow::mappingOffered)))
          return emit mappingOffered(files, unmapped);
        fail(why);
      };
    if (material->is_doubtful && isSignalConnected(QMetaMethod::fromSignal(&MainWindow::importOffered)))
      return [this, files] { emit importOffered(files); };
    report(progress, 1, "Indexing the library");
    auto prepared = prepare_solver(std::move(material).value(), wanted);
    if (!prepared) return [this, why = words(prepared.error())] { fail(why); };
    // Shared only because std::function must be copyable.
    auto ready = std::make_shared<PreparedSolver>(std::move(prepared).value());
    return [this, ready, files, asks, stays] {
      if (asks == AsksToLeave::BeforeStart && !isLeft()) return;
      // Saving may have written the library that stays open, and what was saved of its takes.
      if (session() && stays == ready->material.library_of_files() &&
          !session()->material().library_file.empty())
        ready->material.library_file = session()->material().library_file;
      Material& opened = ready->material;
      opened.use = useOf(opened);
      if (opened.use == InputUse::ClipAsLive && !m_playsAsLive)
        opened.warnings.push_back(
            fmt::format("the clip has {} frames, more than are kept of a clip that is solved as a whole "
                        "({}): it is played as "
                        "live; open a part of it to see its frames at once",
                        opened.input.poses.size(), Material::most_frames_solved));
      start(std::move(*ready));
      if (!files.isEmpty()) emit filesOpened(files);
    };
  };
  // After cancellation the previous session continues, whatever the progress of the new one.
  m_job = std::make_unique<Job>([this, open](const Progress& progress) -> Job::Finish {
    return [this, finish = open(progress)] {
      if (finish && !m_job->wasCancelled()) finish();
    };
  });
  m_messages->showProgress("Opening", 0);
  show_progress(*m_job, *m_messages);
  return true;
}

void MainWindow::start(PreparedSolver prepared) {
  m_document->finishSession();
  m_ticker.setSources(nullptr, nullptr);
  m_plots->clear();
  m_document->openSession(std::move(prepared));
}

void MainWindow::endSession() {
  m_document->finishSession();
  m_ticker.setSources(nullptr, nullptr);
  m_document->endSession();
}

void MainWindow::fail(const QString& message) {
  m_messages->showErrorOf("open", message);
  emit failed(message);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!m_isStopping) {
    bool allowed = true;
    emit leaving(allowed);
    if (!allowed) return event->ignore();
    m_remembered.setGeometry(saveGeometry());
    emit closing();
    m_panels->setEnabled(false);  // nothing is there any more that a person could change
    endSession();
  }
  m_isStopping = RunningWork::any();
  if (!m_isStopping) return QMainWindow::closeEvent(event);
  event->ignore();
  m_messages->showProgress("Stopping…", 0);
  RunningWork::stopAll(this, [this] {
    m_messages->endProgress();
    close();
  });
}

}  // namespace abrazo::app
