#include <QAction>
#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"

namespace abrazo::app {
namespace {

void add_panel_actions(MainWindow& window, QMenu* menu) {
  menu->addMenu(&window.panelMenu());
  QAction* left = add_action(window, menu, "Panels at the left", {QKeySequence("F8")}, [] {});
  QAction* right = add_action(window, menu, "Panels at the right", {QKeySequence("F9")}, [] {});
  for (QAction* action : {left, right}) action->setCheckable(true);
  // triggered, not toggled: a window that gets small hides panels without a request
  QObject::connect(left, &QAction::triggered, &window, &MainWindow::showLeft);
  QObject::connect(right, &QAction::triggered, &window, &MainWindow::showRight);
  QObject::connect(&window, &MainWindow::panelsArranged, menu, [left, right](const PanelPlan& plan) {
    left->setChecked(plan.left);
    right->setChecked(plan.right);
  });
}

}  // namespace

void add_view_actions(MainWindow& window) {
  QMenu* menu = menu_of(window, "View");
  menu->addSeparator();
  add_panel_actions(window, menu);
  QAction* light = add_action(window, menu, "Light colours", {}, [] {});
  light->setCheckable(true);
  light->setChecked(!window.colours().dark);
  QObject::connect(light, &QAction::toggled, &window, [&window](bool on) {
    window.setTheme(on ? widgets::Theme::Light : widgets::Theme::Dark);
    window.remembered().setTheme(on ? "light" : "dark");
  });
  add_action(window, menu, "Full screen", {QKeySequence("F11")},
             [&window] { window.isFullScreen() ? window.showNormal() : window.showFullScreen(); });
}

}  // namespace abrazo::app
