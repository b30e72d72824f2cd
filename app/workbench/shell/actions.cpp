#include "app/workbench/shell/actions.hpp"

#include <QAction>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include "app/workbench/base/action_id.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::app {

namespace {

template <typename Bar>
QMenu* menu_in(Bar& bar, const QString& title) {
  for (QAction* action : bar.actions())
    if (action->menu() && action->text() == title) return action->menu();
  return bar.addMenu(title);
}

/// The menu that has this one, or the bar: more than nine titles there are not taken in at a glance.
QString menu_above(const QString& title) {
  return title == "Play" || title == "Lanes"    ? "Timeline"
         : title == "Compare"                   ? "Solve"
         : title == "Plots" || title == "Video" ? "View"
                                                : "";
}

}  // namespace

QMenu* menu_of(QMainWindow& window, const QString& title) {
  const QString above = menu_above(title);
  return above.isEmpty() ? menu_in(*window.menuBar(), title) : menu_in(*menu_of(window, above), title);
}

QHBoxLayout& title_row(QMainWindow& window) {
  QMenuBar& bar = *window.menuBar();
  if (QWidget* holder = bar.cornerWidget(Qt::TopRightCorner))
    return *qobject_cast<QHBoxLayout*>(holder->layout());
  auto* holder = new QWidget(&window);
  QHBoxLayout* row = widgets::row_in(holder, {0, 0, 12, 0});
  bar.setCornerWidget(holder, Qt::TopRightCorner);
  return *row;
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
