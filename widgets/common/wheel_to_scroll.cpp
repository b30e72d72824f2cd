#include "widgets/common/wheel_to_scroll.hpp"

#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QSlider>

namespace abrazo::widgets {
namespace {

bool has_a_value(const QObject* object) {
  return qobject_cast<const QComboBox*>(object) || qobject_cast<const QAbstractSpinBox*>(object) ||
         qobject_cast<const QSlider*>(object);
}

/// Not across windows: a popup belongs to no list.
bool is_in_a_list(const QWidget* widget) {
  while (widget && !widget->isWindow()) {
    widget = widget->parentWidget();
    if (qobject_cast<const QAbstractScrollArea*>(widget)) return true;
  }
  return false;
}

}  // namespace

WheelToScroll::WheelToScroll(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool WheelToScroll::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel || !has_a_value(watched)) return false;
  if (!is_in_a_list(qobject_cast<const QWidget*>(watched))) return false;
  event->ignore();  // the application offers it to the parents
  return true;
}

}  // namespace abrazo::widgets
