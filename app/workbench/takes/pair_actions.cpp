#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/takes/pair_desk.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "widgets/takes/take_panel.hpp"

namespace abrazo::app {
namespace {

void save_library(MainWindow& window, PairDesk& desk) {
  if (!window.session()) return;
  const QString name = QString::fromStdString(window.session()->material().library->name());
  const QString last = window.remembered().lastFolder();
  const QDir folder(last.isEmpty() ? QDir::homePath() : last);
  QString file = QFileDialog::getSaveFileName(&window, "Save library", folder.filePath(name + ".h5"),
                                              "Libraries (*.h5)");
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) file += ".h5";
  desk.save(file);
}

}  // namespace

void add_pair_actions(MainWindow& window, TakeDesk& takes, PairSources sources) {
  auto* desk = new PairDesk(window, takes, std::move(sources));
  QObject::connect(&takes.panel(), &widgets::TakePanel::pairRequested, desk, &PairDesk::toggle);
  add_action(window, window.menu("Live"), "Record a pair for the library", {}, [desk] { desk->toggle(); });
  add_action(window, window.menu("Library"), "Save library…", {},
             [&window, desk] { save_library(window, *desk); });
}

}  // namespace abrazo::app
