#include <QAction>
#include <QMenu>

#include "app/workbench/project/history_desk.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"

namespace abrazo::app {

namespace {

/// On the library that is open, with everything else as at the first start.
void begin_anew(MainWindow& window) {
  if (!window.session()) return window.openDemo();
  if (!window.isLeft()) return;
  Document& document = window.document();
  document.controlRole(RoleControl::Hand);
  document.putSettings(preset("responsive").value());
  window.openMaterial([next = fresh_session(window.session()->material())](
                          const Progress&) { return Result<Material>(next); },
                      {}, MainWindow::AsksToLeave::Asked);
}

}  // namespace

ProjectDesk& add_project_actions(MainWindow& window, TakeDesk& takes) {
  auto* desk = new ProjectDesk(window, takes);
  QMenu* menu = menu_of(window, "File");
  QAction* fresh =
      add_action(window, menu, "New session", {QKeySequence("Ctrl+N")}, [&window] { begin_anew(window); });
  move_before(*menu, fresh, action_of(window, "file.open"));
  QAction* save = add_action(window, menu, "Save", {QKeySequence("Ctrl+S")}, [desk] { desk->save(); });
  QAction* save_as =
      add_action(window, menu, "Save as…", {QKeySequence("Ctrl+Shift+S")}, [desk] { desk->askSaveAs(); });
  for (QAction* action : {save, save_as})
    move_before(*menu, action, action_of(window, "file.generated_dance"));
  auto* history = new HistoryDesk(window, [desk] { return desk->hasTakes(); });
  QObject::connect(desk, &ProjectDesk::leftForNextStart, history, &HistoryDesk::leave);
  desk->unsavedHistory = [history] { return history->unsaved(true); };
  QObject::connect(desk, &ProjectDesk::losingHistory, history, &HistoryDesk::leaveSession);
  QObject::connect(desk, &ProjectDesk::historySaved, history, &HistoryDesk::noteSaved);
  add_action(window, menu_of(window, "Timeline"), "History on disk…", {}, [history] { history->askBound(); });
  return *desk;
}

}  // namespace abrazo::app
