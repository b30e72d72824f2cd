#include "widgets/common/chip.hpp"

namespace abrazo::widgets {

QToolButton* chip(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName("chip");
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

}  // namespace abrazo::widgets
