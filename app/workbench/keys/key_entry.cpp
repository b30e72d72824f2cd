#include "app/workbench/keys/key_entry.hpp"

#include <QKeyEvent>
#include <QKeySequence>

namespace abrazo::app {

std::string pressed_key(const QKeyEvent& event) {
  const int key = event.key();
  if (key == 0 || key == Qt::Key_unknown || (key >= Qt::Key_Shift && key <= Qt::Key_ScrollLock) ||
      key == Qt::Key_AltGr)
    return {};
  Qt::KeyboardModifiers held = event.modifiers() & ~(Qt::KeypadModifier | Qt::GroupSwitchModifier);
  const bool is_sign = key > Qt::Key_Space && key < Qt::Key_Dead_Grave &&
                       !(key >= Qt::Key_A && key <= Qt::Key_Z) && !(key >= Qt::Key_0 && key <= Qt::Key_9) &&
                       key < Qt::Key_Escape;
  if (is_sign) held &= ~Qt::ShiftModifier;
  return QKeySequence(key | static_cast<int>(held)).toString(QKeySequence::PortableText).toStdString();
}

KeyEntry::KeyEntry(QWidget* parent) : QLineEdit(parent) {
  setPlaceholderText("Press a key");
  setAccessibleName("Press a key");
  setContextMenuPolicy(Qt::NoContextMenu);
  setFixedWidth(170);
}

void KeyEntry::forget() {
  m_key.clear();
  clear();
}

bool KeyEntry::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void KeyEntry::keyPressEvent(QKeyEvent* event) {
  event->accept();
  const std::string key = pressed_key(*event);
  if (key.empty()) return;
  m_key = key;
  setText(QKeySequence(QString::fromStdString(key), QKeySequence::PortableText)
              .toString(QKeySequence::NativeText));
  emit pressed();
}

}  // namespace abrazo::app
