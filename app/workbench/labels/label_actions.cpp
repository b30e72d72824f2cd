#include <QMenu>

#include "app/workbench/labels/label_edits.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"

namespace abrazo::app {

void add_label_actions(MainWindow& window, LabelEdits& edits) {
  using Edge = LabelEdits::Edge;
  QMenu* menu = window.menu("Annotation");
  LabelEdits* on = &edits;
  add_action(window, menu, "New label…", {QKeySequence("N")}, [on] { on->draw(); });
  add_action(window, menu, "Edit label…", {QKeySequence("F2")}, [on] { on->ask(); });
  add_action(window, menu, "Extend label to the cursor", {QKeySequence("E")}, [on] { on->extend(); });
  add_action(window, menu, "Split label at the cursor", {QKeySequence("S")}, [on] { on->split(); });
  add_action(window, menu, "Merge label with the next", {QKeySequence("Shift+S")}, [on] { on->merge(); });
  add_action(window, menu, "Change of role here", {QKeySequence("Shift+U")}, [on] { on->exchangeRole(); });
  menu->addSeparator();
  add_action(window, menu, "Previous label", {QKeySequence("Ctrl+Up")}, [on] { on->step(-1); });
  add_action(window, menu, "Next label", {QKeySequence("Ctrl+Down")}, [on] { on->step(1); });
  QMenu* nudges = menu->addMenu("Nudge label");
  const std::tuple<const char*, const char*, Edge, int> ways[] = {
      {"Label a frame earlier", "Ctrl+Alt+Left", Edge::Both, -1},
      {"Label a frame later", "Ctrl+Alt+Right", Edge::Both, 1},
      {"Start of label a frame earlier", "Ctrl+Shift+Left", Edge::Start, -1},
      {"Start of label a frame later", "Ctrl+Shift+Right", Edge::Start, 1},
      {"End of label a frame earlier", "Alt+Shift+Left", Edge::End, -1},
      {"End of label a frame later", "Alt+Shift+Right", Edge::End, 1}};
  for (const auto& [name, key, edge, by] : ways)
    add_action(window, nudges, name, {QKeySequence(key)},
               [on, edge = edge, by = by] { on->nudge(edge, by); });
  QMenu* copy = menu->addMenu("Copy label to the tier");
  QObject::connect(copy, &QMenu::aboutToShow, on, [on, copy] {
    copy->clear();
    on->fillMenu(*copy);
  });
}

}  // namespace abrazo::app
