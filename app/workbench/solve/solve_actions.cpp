#include <QAction>
#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"

namespace abrazo::app {

void add_solve_actions(MainWindow& window) {
  QMenu* menu = window.menu("Solve");
  for (const std::string_view name : preset_names) {
    const QString preset = QString::fromUtf8(name.data(), static_cast<int>(name.size()));
    add_action(window, menu, "Preset " + preset, {},
               [&window, preset] { window.document().choosePreset(preset); });
  }
  menu->addSeparator();
  QAction* hold = add_action(window, menu, "Hold the input still", {}, [] {});
  hold->setCheckable(true);
  QObject::connect(hold, &QAction::toggled, &window, [&window](bool on) {
    if (window.session()) window.session()->push(PauseInput{on});
  });
  QObject::connect(&window, &MainWindow::sessionStarted, hold, [hold] { hold->setChecked(false); });
  add_action(window, menu, "Restart the solver", {}, [&window] {
    if (window.session()) window.session()->push(ResetSolver{});
  });
}

}  // namespace abrazo::app
