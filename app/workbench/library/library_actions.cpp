#include <QAction>
#include <QMenu>

#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/library/library_desk.hpp"
#include "app/workbench/library/mapping_desk.hpp"
#include "app/workbench/library/retarget_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/library/take_list.hpp"

namespace abrazo::app {
namespace {

void open_library(MainWindow& window) {
  const QStringList files = ask_files(&window, window.remembered(), "Open a library",
                                      "Libraries and manifests (*.h5 *.hdf5 *.json)");
  if (!files.isEmpty()) window.openFiles(files);
}

}  // namespace

void add_library_actions(MainWindow& window) {
  new MappingDesk(window);
  auto* desk = new LibraryDesk(window);
  widgets::TakeList& takes = window.takes();
  QMenu* menu = menu_of(window, "Library");
  add_action(window, menu, "Build library…", {QKeySequence("Ctrl+B")}, [desk] { desk->offer({}); });
  add_action(window, menu, "Open library or manifest…", {}, [&window] { open_library(window); });
  menu->addSeparator();
  add_action(window, menu, "Find a take or move", {QKeySequence("Ctrl+F")}, [&takes] { takes.find(); });
  add_action(window, menu, "Go to the shown take", {QKeySequence("Alt+T")}, [&takes] { takes.goToSource(); });
  QAction* play = add_action(window, menu, "Play the take as recorded", {QKeySequence("Shift+Space")},
                             [&takes] { takes.togglePlay(); });
  QAction* dance =
      add_action(window, menu, "Dance with this take", {QKeySequence("Ctrl+D")}, [&takes] { takes.dance(); });
  QAction* exclude =
      add_action(window, menu, "Exclude the take, or use it again", {}, [&takes] { takes.toggleVeto(); });
  menu->addSeparator();
  auto* retarget = new RetargetDesk(window);
  add_action(window, menu, "Retarget take…", {}, [retarget] { retarget->open(); });
  for (QAction* action : {play, dance, exclude}) {
    action->setEnabled(false);
    QObject::connect(&window.document(), &Document::began, action, [action] { action->setEnabled(true); });
  }
}

}  // namespace abrazo::app
