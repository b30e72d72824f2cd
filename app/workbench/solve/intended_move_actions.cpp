#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/solve/intended_move_desk.hpp"

namespace abrazo::app {

void add_intended_move_actions(MainWindow& window) {
  auto* desk = new IntendedMoveDesk(window);
  QMenu* menu = menu_of(window, "Live");
  add_action(window, menu, "Declare the intended move, or cancel it", {QKeySequence("W")},
             [desk] { desk->toggle(); });
  add_action(window, menu, "Declare another intended move…", {QKeySequence("Shift+W")},
             [desk] { desk->offer(); });
}

}  // namespace abrazo::app
