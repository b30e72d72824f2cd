#include <QBoxLayout>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <algorithm>

#include "app/workbench/base/job.hpp"
#include "app/workbench/document/session_places.hpp"
#include "app/workbench/project/autosave.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/session/file/session_file.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/takes/leftover_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::LeftoverBar;
using widgets::LeftoverSession;

void choose_session(MainWindow& window) {
  const QStringList files = QFileDialog::getOpenFileNames(
      &window, "Open session", sessions_folder(),
      "Sessions, with their library if it is elsewhere (*.abrazo *.h5 *.json);;All files (*)");
  if (!files.isEmpty()) window.openFiles(files);
}

/// State of a recorded session beside its frames; the cursor is at its beginning.
void show_recorded(MainWindow& window, TakeDesk& takes) {
  const auto recorded = window.session()->material().recorded;
  if (!recorded) return;
  // First: a continued recording writes these.
  window.document().put(SubjectMarkers{"", recorded->markers()});
  takes.setOpened(QString::fromStdString(recorded->file), recorded->contents);
  if (!recorded->contents.settings.empty())
    window.document().putSettings(recorded->contents.settings.back().settings);
  window.ticker().tick();
  window.ticker().goToStart();
}

QString minutes(double seconds) {
  return seconds < 90 ? QString("%1 s").arg(seconds, 0, 'f', 0)
                      : QString("%1 min").arg(seconds / 60, 0, 'f', 0);
}

/// Those that can be opened and that no program is writing.
std::vector<LeftoverSession> leftovers(const QStringList& files) {
  std::vector<LeftoverSession> found;
  for (const QString& file : files) {
    const auto session = SessionFile::open(file.toStdString());
    if (!session || (*session)->is_being_recorded()) continue;
    const SessionContents& contents = (*session)->contents();
    const auto is_closed = [](const SessionRun& run) { return run.finished; };
    if (std::ranges::all_of(contents.runs, is_closed)) continue;
    const std::size_t takes = contents.takes.size();
    const QDateTime begun =
        contents.runs.empty()
            ? QFileInfo(file).lastModified()
            : QDateTime::fromString(QString::fromStdString(contents.runs.front().begun_at), Qt::ISODate);
    found.push_back({file, QString("Session of %1 was not closed; %2, %3 take%4")
                               .arg(begun.toLocalTime().toString("d MMM HH:mm"),
                                    minutes(contents.last_s - contents.first_s))
                               .arg(takes)
                               .arg(takes == 1 ? "" : "s")});
  }
  return found;
}

void discard(MainWindow& window, const QString& file) {
  if (QFileInfo(file).absolutePath() == QFileInfo(window.remembered().autosaveFolder()).absoluteFilePath()) {
    Autosave::remove(file);
    return window.messages().showInformation("The changes that were not saved were discarded");
  }
  discard_session(file) ? window.messages().showInformation(file + " was discarded")
                        : window.messages().showError(file + ": cannot be removed; check its owner");
}

/// Changes that were kept for programs that are gone; what cannot be read is offered, too, to be thrown away.
std::vector<LeftoverSession> unsaved(const QStringList& files) {
  std::vector<LeftoverSession> found;
  for (const QString& file : files) {
    const QString words = words_of_autosave(file);
    found.push_back({file, words.isEmpty() ? "Changes that were not saved cannot be read" : words,
                     session_of_autosave(file)});
  }
  return found;
}

}  // namespace

void offer_leftovers(MainWindow& window, LeftoverBar& shown) {
  const QStringList files = unclosed_sessions(sessions_folder());
  const QStringList kept = Autosave::leftBehind(window.remembered().autosaveFolder());
  if ((files + kept).isEmpty()) return;
  LeftoverBar* bar = &shown;
  new Job(
      [files, kept, bar](const Progress&) -> Job::Finish {
        // Unsaved work opens together with its recording.
        auto found = unsaved(kept);
        for (LeftoverSession& session : leftovers(files))
          if (std::ranges::none_of(found, [&](const auto& one) { return one.belongsTo == session.file; }))
            found.push_back(std::move(session));
        return [found, bar] { bar->offer(found); };
      },
      bar);
}

LeftoverBar& add_session_actions(MainWindow& window, TakeDesk& takes) {
  QMenu* menu = window.menu("File");
  add_action(window, menu, "Open session…", {}, [&window] { choose_session(window); });
  QAction* open = menu->actions().back();
  menu->removeAction(open);
  menu->insertAction(menu->actions().value(1), open);  // below Open

  auto* bar = new LeftoverBar(window.messages().parentWidget());
  bar->setColours(window.colours());
  if (auto* column = qobject_cast<QBoxLayout*>(window.messages().parentWidget()->layout()))
    column->insertWidget(1, bar);
  QObject::connect(&window, &MainWindow::coloursChanged, bar, &LeftoverBar::setColours);
  QObject::connect(bar, &LeftoverBar::openRequested, &window,
                   [&window](const QString& file) { window.openFiles({file}); });
  QObject::connect(bar, &LeftoverBar::discardRequested, &window,
                   [&window](const QString& file) { discard(window, file); });
  QObject::connect(&window, &MainWindow::sessionStarted, bar,
                   [&window, &takes] { show_recorded(window, takes); });
  return *bar;
}

}  // namespace abrazo::app
