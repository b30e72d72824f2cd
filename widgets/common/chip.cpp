#include "widgets/common/chip.hpp"

#include "widgets/common/parts.hpp"

namespace abrazo::widgets {

QToolButton* chip(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName("chip");
  button->setText(text);
  describe(*button, tip, tip);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

QToolButton* text_chip(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = chip(text, tip, parent);
  button->setAccessibleName(QString(text).remove("…"));
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace abrazo::widgets
