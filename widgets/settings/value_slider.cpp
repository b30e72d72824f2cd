#include "widgets/settings/value_slider.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace abrazo::widgets {
namespace {

constexpr double handle_radius = 6.5;

}  // namespace

ValueSlider::ValueSlider(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFixedHeight(20);
  setFocusPolicy(Qt::TabFocus);  // a click must not take the arrow keys from the transport
  setCursor(Qt::PointingHandCursor);
}

void ValueSlider::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void ValueSlider::setPlace(double place) {
  m_place = std::clamp(place, 0.0, 1.0);
  update();
}

void ValueSlider::setDefaultPlace(double place) {
  m_default = std::clamp(place, 0.0, 1.0);
  update();
}

double ValueSlider::xOf(double place) const {
  return handle_radius + place * (width() - 2 * handle_radius);
}

void ValueSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  constexpr double y = 8;
  const QColor filled = m_palette.dark ? m_palette.active : m_palette.accent;
  painter.setPen(Qt::NoPen);
  painter.setBrush(m_palette.dark ? m_palette.border.lighter(125) : m_palette.border);
  painter.drawRoundedRect(QRectF(0, y - 1.75, width(), 3.5), 1.75, 1.75);
  painter.setBrush(filled);
  painter.drawRoundedRect(QRectF(0, y - 1.75, xOf(m_place), 3.5), 1.75, 1.75);
  painter.setBrush(m_palette.secondary);
  painter.drawRect(QRectF(xOf(m_default) - 0.5, y + 7, 1, 4));
  painter.setPen(QPen(hasFocus() ? m_palette.text : filled, 2));
  painter.setBrush(m_palette.dark ? m_palette.text : QColor(Qt::white));
  painter.drawEllipse(QPointF(xOf(m_place), y), handle_radius - 1, handle_radius - 1);
}

void ValueSlider::dragTo(double x) {
  setPlace((x - handle_radius) / std::max(1.0, width() - 2 * handle_radius));
  emit moved(m_place, m_gesture);
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  ++m_gesture;
  m_dragging = true;
  dragTo(event->localPos().x());
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
  if (m_dragging) dragTo(event->localPos().x());
}

void ValueSlider::mouseReleaseEvent(QMouseEvent*) {
  m_dragging = false;
}

void ValueSlider::mouseDoubleClickEvent(QMouseEvent*) {
  m_dragging = false;
  emit resetRequested();
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() & Qt::ShiftModifier ? 0.1 : 0.01;
  double place = m_place;
  if (event->key() == Qt::Key_Left)
    place -= step;
  else if (event->key() == Qt::Key_Right)
    place += step;
  else
    return QWidget::keyPressEvent(event);
  setPlace(place);
  emit moved(m_place, ++m_gesture);
}

bool ValueSlider::event(QEvent* event) {
  // With the focus on a slider its arrow keys are its own, not the transport's.
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right) event->accept();
  }
  return QWidget::event(event);
}

Toggle::Toggle(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFixedSize(30, 18);
  setCursor(Qt::PointingHandCursor);
}

void Toggle::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void Toggle::setOn(bool on) {
  m_on = on;
  update();
}

void Toggle::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const QColor off = m_palette.dark ? m_palette.border.lighter(140) : m_palette.border.darker(110);
  painter.setBrush(m_on ? m_palette.accent : off);
  painter.drawRoundedRect(QRectF(1, 2, 28, 14), 7, 7);
  painter.setBrush(m_palette.dark ? m_palette.text : QColor(Qt::white));
  painter.drawEllipse(QPointF(m_on ? 22 : 8, 9), 5, 5);
}

void Toggle::mousePressEvent(QMouseEvent*) {
  setOn(!m_on);
  emit toggled(m_on);
}

}  // namespace abrazo::widgets
