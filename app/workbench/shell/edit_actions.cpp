#include <QAction>
#include <QMenu>
#include <QUndoStack>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/change_history.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"

namespace abrazo::app {

void add_edit_actions(MainWindow& window) {
  QMenu* menu = menu_of(window, "Edit");
  QAction* undo =
      add_action(window, menu, "Undo", {QKeySequence("Ctrl+Z")}, [&window] { window.undoStack().undo(); });
  QAction* redo = add_action(window, menu, "Redo", {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")},
                             [&window] { window.undoStack().redo(); });
  undo->setEnabled(false);
  redo->setEnabled(false);
  QObject::connect(&window.undoStack(), &QUndoStack::canUndoChanged, undo, &QAction::setEnabled);
  QObject::connect(&window.undoStack(), &QUndoStack::canRedoChanged, redo, &QAction::setEnabled);
  QObject::connect(&window.undoStack(), &QUndoStack::undoTextChanged, undo,
                   [undo](const QString& what) { undo->setText(what.isEmpty() ? "Undo" : "Undo " + what); });
  QObject::connect(&window.undoStack(), &QUndoStack::redoTextChanged, redo,
                   [redo](const QString& what) { redo->setText(what.isEmpty() ? "Redo" : "Redo " + what); });
  window.addPanel("history", "History", new ChangeHistory(window.undoStack()), Qt::RightDockWidgetArea,
                  false);
  menu->addSeparator();
  add_action(window, menu, "History", {}, [&window] { window.panels().want("history", true); });
}

}  // namespace abrazo::app
