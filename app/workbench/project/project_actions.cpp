#include <QAction>
#include <QMenu>

#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/takes/take_panel.hpp"

namespace abrazo::app {
namespace {

/// From the end of the menu to before another entry.
void move_before(QMenu& menu, QAction* action, const QString& words) {
  for (QAction* each : menu.actions())
    if (each->text() == words && each != action) {
      menu.removeAction(action);
      menu.insertAction(each, action);
      return;
    }
}

}  // namespace

void add_project_actions(MainWindow& window) {
  auto* desk = new ProjectDesk(window);
  QMenu* menu = window.menu("File");
  QAction* fresh =
      add_action(window, menu, "New session", {QKeySequence("Ctrl+N")}, [&window] { window.openDemo(); });
  move_before(*menu, fresh, "Open…");
  QAction* save = add_action(window, menu, "Save", {QKeySequence("Ctrl+S")}, [desk] { desk->save(); });
  QAction* save_as =
      add_action(window, menu, "Save as…", {QKeySequence("Ctrl+Shift+S")}, [desk] { desk->askSaveAs(); });
  for (QAction* action : {save, save_as}) move_before(*menu, action, "Generated dance");
  if (auto* panel = window.findChild<widgets::TakePanel*>())
    QObject::connect(panel, &widgets::TakePanel::saveAsRequested, desk, &ProjectDesk::askSaveAs);
}

}  // namespace abrazo::app
