#include "app/workbench/shell/actions.hpp"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include "app/workbench/base/action_id.hpp"

namespace abrazo::app {

QMenu* menu_of(QMainWindow& window, const QString& title) {
  for (QAction* action : window.menuBar()->actions())
    if (action->text() == title) return action->menu();
  return window.menuBar()->addMenu(title);
}

QString menu_path(const QAction& action) {
  for (const QWidget* widget : action.associatedWidgets())
    if (const auto* menu = qobject_cast<const QMenu*>(widget)) {
      const QString above = menu_path(*menu->menuAction());
      return above.isEmpty() ? menu->title() : above + " > " + menu->title();
    }
  return {};
}

QAction* add_action(QMainWindow& window, QMenu* menu, const QString& text,
                    std::initializer_list<QKeySequence> keys, std::function<void()> act) {
  auto* action = new QAction(text, &window);
  action->setShortcuts(QList<QKeySequence>(keys));
  action->setShortcutContext(Qt::WindowShortcut);
  QObject::connect(action, &QAction::triggered, &window, std::move(act));
  menu->addAction(action);
  action->setObjectName(
      QString::fromStdString(action_id(menu_path(*action).toStdString(), text.toStdString())));
  window.addAction(action);
  return action;
}

QAction* action_of(const QMainWindow& window, const QString& id) {
  for (QAction* action : window.actions())
    if (action->objectName() == id) return action;
  return nullptr;
}

void move_before(QMenu& menu, QAction* action, QAction* other) {
  if (!other) return;
  menu.removeAction(action);
  menu.insertAction(other, action);
}

}  // namespace abrazo::app
