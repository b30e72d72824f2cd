#pragma once

#include <QToolButton>

namespace abrazo::app {

/// The button beside a field that opens a file dialog for it.
/// @param name  of the field
inline QToolButton* choose_button(const QString& name, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName("chip");
  button->setText("…");
  button->setAccessibleName(name + ": choose");
  return button;
}

}  // namespace abrazo::app
