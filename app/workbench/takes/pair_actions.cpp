#include <QAction>
#include <QMenu>

#include "app/workbench/base/file_dialogs.hpp"
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
  const QString file =
      ask_new_file(&window, window.remembered(), "Save library", name + ".h5", ".h5", "Libraries (*.h5)");
  if (!file.isEmpty()) desk.save(file);
}

}  // namespace

void add_pair_actions(MainWindow& window, TakeDesk& takes,
                      std::function<std::pair<QString, QString>()> performers) {
  auto* desk = new PairDesk(window, takes, std::move(performers));
  QObject::connect(&takes.panel(), &widgets::TakePanel::pairRequested, desk, &PairDesk::toggle);
  add_action(window, menu_of(window, "Live"), "Record a pair for the library", {},
             [desk] { desk->toggle(); });
  add_action(window, menu_of(window, "Library"), "Save library…", {},
             [&window, desk] { save_library(window, *desk); });
}

}  // namespace abrazo::app
