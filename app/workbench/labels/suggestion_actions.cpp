#include <QMenu>

#include "app/workbench/labels/suggestion_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"

namespace abrazo::app {

void add_suggestion_actions(MainWindow& window, AnnotationDesk& annotations) {
  auto* desk = new SuggestionDesk(window, annotations);
  QMenu* menu = menu_of(window, "Annotation");
  menu->addSeparator();
  add_action(window, menu, "Suggest labels", {QKeySequence("Ctrl+G")},
             [desk] { desk->suggest(true, false); });
  add_action(window, menu, "Suggest roles", {QKeySequence("Ctrl+Shift+G")},
             [desk] { desk->suggest(false, true); });
  add_action(window, menu, "Stop suggesting", {}, [desk] { desk->cancel(); });
  add_action(window, menu, "Go to the suggestions", {QKeySequence("Alt+Y")}, [desk] { desk->focusList(); });
  add_action(window, menu, "Accept suggestion", {QKeySequence("Y")}, [desk] { desk->acceptCurrent(); });
  add_action(window, menu, "Accept suggestion as…", {QKeySequence("Shift+Y")},
             [desk] { desk->editCurrent(); });
  add_action(window, menu, "Reject suggestion", {QKeySequence("Ctrl+Backspace")},
             [desk] { desk->rejectCurrent(); });
}

}  // namespace abrazo::app
