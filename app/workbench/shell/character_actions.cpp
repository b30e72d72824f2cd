#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/character_desk.hpp"
#include "app/workbench/shell/main_window.hpp"

namespace abrazo::app {

void add_character_actions(MainWindow& window) {
  auto* desk = new CharacterDesk(window);
  QMenu* menu = menu_of(window, "View")->addMenu("Characters");
  add_action(window, menu, "Character for the leader…", {}, [desk] { desk->choose(0); });
  add_action(window, menu, "Character for the follower…", {}, [desk] { desk->choose(1); });
  add_action(window, menu, "Capsules for both characters", {}, [desk] {
    for (const int body : {0, 1}) desk->wear(body, {});
  });
}

}  // namespace abrazo::app
