#include "app/workbench/keys/key_routing.hpp"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QToolButton>

#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

bool is_plain(const QKeyEvent& event) {
  return !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

bool is_digit(const QKeyEvent& event) {
  return is_plain(event) && !(event.modifiers() & Qt::ShiftModifier) && event.key() >= Qt::Key_0 &&
         event.key() <= Qt::Key_9;
}

/// A list to choose from goes to what begins with the letter, and to the next, previous, first and last.
bool is_of_a_choice(const QKeyEvent& event) {
  const bool writes = !event.text().isEmpty() && event.text().at(0).isPrint();
  const int key = event.key();
  return is_plain(event) && (writes || key == Qt::Key_Home || key == Qt::Key_End || key == Qt::Key_Up ||
                             key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown);
}

void click(QAbstractButton& button) {
  auto* tool = qobject_cast<QToolButton*>(&button);
  const bool opens = tool && tool->menu() && tool->popupMode() == QToolButton::InstantPopup;
  opens ? tool->showMenu() : button.click();
}

}  // namespace

KeyRouting::KeyRouting(MainWindow& window, Claims labels, std::function<bool()> annotates)
    : QObject(&window), m_window(window), m_labels(std::move(labels)), m_annotates(std::move(annotates)) {
  window.installEventFilter(this);
  for (QDockWidget* panel : window.panels().panels()) panel->installEventFilter(this);  // floating: no way up
}

bool KeyRouting::isKept(const QKeyEvent& event) const {
  const QWidget* focused = QApplication::focusWidget();
  if (qobject_cast<const QComboBox*>(focused)) return is_of_a_choice(event);
  return m_labels(event) || isOfAnotherTask(event) || (focused == &m_window.timeline() && is_digit(event));
}

/// A letter typed after a label was drawn, by somebody who thinks that its name is asked for, must not change
/// the user's role or the solver.
bool KeyRouting::isOfAnotherTask(const QKeyEvent& event) const {
  if (!is_plain(event) || event.key() < Qt::Key_A || event.key() > Qt::Key_Z || !m_annotates()) return false;
  const QKeySequence key(event.key() | static_cast<int>(event.modifiers() & Qt::ShiftModifier));
  for (const QAction* action : m_window.actions()) {
    if (!action->shortcuts().contains(key)) continue;
    const QString menu = action->objectName().section('.', 0, 0);
    const auto is_of = [&menu](const char* title) { return menu.startsWith(title); };
    if (is_of("solve") || is_of("live") || is_of("compare")) return true;
    return QApplication::focusWidget() == &m_window.timeline() && (is_of("view") || is_of("plots"));
  }
  return false;
}

/// Space plays wherever the focus is, so Return presses a button.
bool KeyRouting::press(const QKeyEvent& event) {
  QWidget* focused = QApplication::focusWidget();
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    auto* button = qobject_cast<QAbstractButton*>(focused);
    if (button && !event.isAutoRepeat()) click(*button);
    return button != nullptr;
  }
  if (isOfAnotherTask(event)) {
    m_window.messages().showInformation(event.text().toUpper() +
                                        " does nothing while you annotate. N or Return opens a label's "
                                        "value; click the scene for the other keys");
    return true;
  }
  if (focused != &m_window.timeline() || !is_digit(event)) return false;
  m_window.messages().showInformation(
      "No value of the active tier has this key (panel Annotation, Vocabulary). In the scene digits choose "
      "the view");
  return true;
}

bool KeyRouting::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isKept(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::KeyPress && press(*static_cast<QKeyEvent*>(event))) return true;
  return QObject::eventFilter(watched, event);
}

}  // namespace abrazo::app
