#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/document/session_places.hpp"
#include "app/workbench/project/autosave.hpp"
#include "app/workbench/project/history_desk.hpp"
#include "app/workbench/project/leftovers.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/takes/leftover_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::LeftoverBar;

void choose_session(MainWindow& window) {
  const QStringList files = widgets::choose_files(
      &window, "Open session", sessions_folder(),
      "Sessions, with their library if it is elsewhere (*.abrazo *.h5 *.json);;All files (*)");
  if (!files.isEmpty()) window.openFiles(files);
}

bool is_history(const MainWindow& window, const QString& file) {
  return QFileInfo(file).absolutePath().startsWith(
      QFileInfo(window.remembered().historyFolder()).absoluteFilePath() + "/");
}

/// A history that a crash left behind becomes a session like others.
void open_leftover(MainWindow& window, const QString& file) {
  if (!is_history(window, file)) return window.openFiles({file});
  const QString adopted = HistoryDesk::adopt(file);
  if (adopted.isEmpty())
    return window.messages().showError(file + ": cannot be moved to " + sessions_folder() +
                                       "; check the space there, or open it by File > Open session");
  window.messages().showInformation("The history is now " + adopted);
  window.openFiles({adopted});
}

bool is_autosave(const MainWindow& window, const QString& file) {
  return QFileInfo(file).absolutePath() == QFileInfo(window.remembered().autosaveFolder()).absoluteFilePath();
}

/// What does not go to the trash is deleted for good.
bool may_discard(MainWindow& window, const widgets::LeftoverSession& session) {
  if (!is_history(window, session.file) && !is_autosave(window, session.file)) return true;
  QMessageBox box(QMessageBox::Question, "Abrazo", "Delete this for good?", QMessageBox::Cancel, &window);
  box.setInformativeText(session.words + ". It cannot be brought back. Open makes it a session.");
  const QAbstractButton* sure = box.addButton("Delete", QMessageBox::DestructiveRole);
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  return box.clickedButton() == sure;
}

void discard(MainWindow& window, const QString& file) {
  if (is_history(window, file)) {
    HistoryDesk::discard(file);
    return window.messages().showInformation("The history was discarded");
  }
  if (is_autosave(window, file)) {
    Autosave::remove(file);
    return window.messages().showInformation("The changes that were not saved were discarded");
  }
  const Status discarded = discard_session(file);
  discarded ? window.messages().showInformation(file + " was moved to the trash")
            : window.messages().showError(words(discarded.error()));
}

}  // namespace

void offer_leftovers(MainWindow& window, LeftoverBar& shown) {
  const LeftoverFiles files = leftover_files(window.remembered());
  if (files.empty()) return;
  LeftoverBar* bar = &shown;
  new Job(
      [files, bar](const Progress&) -> Job::Finish {
        return [found = described(files), bar] { bar->offer(found); };
      },
      bar);
}

LeftoverBar& add_session_actions(MainWindow& window) {
  QMenu* menu = menu_of(window, "File");
  add_action(window, menu, "Open session…", {}, [&window] { choose_session(window); });
  QAction* open = menu->actions().back();
  menu->removeAction(open);
  menu->insertAction(menu->actions().value(1), open);  // below Open

  auto* bar = new LeftoverBar;
  window.colour(bar);
  window.addAboveMessages(bar);
  bar->confirmDiscard = [&window](const widgets::LeftoverSession& session) {
    return may_discard(window, session);
  };
  QObject::connect(bar, &LeftoverBar::openRequested, &window,
                   [&window](const QString& file) { open_leftover(window, file); });
  QObject::connect(bar, &LeftoverBar::discardRequested, &window,
                   [&window](const QString& file) { discard(window, file); });
  return *bar;
}

}  // namespace abrazo::app
