#include <QAction>
#include <QMainWindow>
#include <QMenu>

#include "app/workbench/document/document.hpp"
#include "app/workbench/shell/actions.hpp"

namespace abrazo::app {

void add_solve_actions(QMainWindow& window, Document& document) {
  QMenu* menu = menu_of(window, "Solve");
  for (const std::string_view name : preset_names) {
    const QString preset = QString::fromUtf8(name.data(), static_cast<int>(name.size()));
    add_action(window, menu, "Preset " + preset, {}, [&document, preset] { document.choosePreset(preset); });
  }
  menu->addSeparator();
  QAction* hold = add_action(window, menu, "Hold the input still", {}, [] {});
  hold->setCheckable(true);
  QObject::connect(hold, &QAction::toggled, &document, [&document](bool on) {
    if (document.session()) document.session()->push(PauseInput{on});
  });
  QObject::connect(&document, &Document::began, hold, [hold] { hold->setChecked(false); });
  add_action(window, menu, "Restart the solver", {}, [&document] {
    if (document.session()) document.session()->push(ResetSolver{});
  });
}

}  // namespace abrazo::app
