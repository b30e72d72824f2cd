#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/solve/meaning_desk.hpp"

namespace abrazo::app {

void add_meaning_actions(MainWindow& window) {
  auto* desk = new MeaningDesk(window);
  QMenu* menu = window.menu("Live");
  add_action(window, menu, "I mean this move, or cancel it", {QKeySequence("W")}, [desk] { desk->toggle(); });
  add_action(window, menu, "Mean another move as well…", {QKeySequence("Shift+W")},
             [desk] { desk->offer(); });
}

}  // namespace abrazo::app
