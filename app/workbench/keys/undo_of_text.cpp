#include "app/workbench/keys/undo_of_text.hpp"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QUndoStack>

namespace abrazo::app {

UndoOfText::UndoOfText(QWidget& window, QUndoStack& steps) : QObject(&window), m_window(window) {
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* focused) { watch(focused); });
  connect(&steps, &QUndoStack::indexChanged, this, [this] { m_typed = false; });
}

void UndoOfText::watch(QWidget* focused) {
  if (m_watched) m_watched->removeEventFilter(this), m_watched->disconnect(this);
  m_watched.clear();
  m_typed = false;
  // A dialog keeps its own.
  const QWidget* place = focused ? focused->window() : nullptr;
  if (place != &m_window && !qobject_cast<const QDockWidget*>(place)) return;
  const auto type = [this] { m_typed = true; };
  if (auto* line = qobject_cast<QLineEdit*>(focused))
    connect(line, &QLineEdit::textEdited, this, type);
  else if (auto* text = qobject_cast<QPlainTextEdit*>(focused))
    connect(text, &QPlainTextEdit::textChanged, this, type);
  else if (!qobject_cast<QAbstractSpinBox*>(focused))
    return;
  m_watched = focused;
  focused->installEventFilter(this);
}

bool UndoOfText::eventFilter(QObject* watched, QEvent* event) {
  // A number field emits no signal for its text. Its accepted value becomes an undo step afterwards.
  if (event->type() == QEvent::KeyPress && qobject_cast<QAbstractSpinBox*>(watched))
    m_typed = m_typed || !static_cast<QKeyEvent*>(event)->text().isEmpty();
  if (event->type() != QEvent::ShortcutOverride || m_typed) return QObject::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) return false;
  event->ignore();  // the field would take it
  return true;
}

}  // namespace abrazo::app
