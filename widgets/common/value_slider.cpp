#include "widgets/common/value_slider.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/common/qt_versions.hpp"

namespace abrazo::widgets {
namespace {

constexpr double handle_radius = 6.5;

/// Steps of a key; 0 for other keys.
int steps_of(const QKeyEvent& event) {
  const int many = event.modifiers() & Qt::ShiftModifier ? 10 : 1;
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
      return -many;
    case Qt::Key_Right:
    case Qt::Key_Up:
      return many;
    case Qt::Key_PageDown:
      return -10;
    case Qt::Key_PageUp:
      return 10;
    default:
      return 0;
  }
}

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

void ValueSlider::setMarkedPlace(std::optional<double> place) {
  if (place == m_marked) return;
  m_marked = place;
  update();
}

double ValueSlider::xOf(double place) const {
  return handle_radius + place * (width() - 2 * handle_radius);
}

void ValueSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  constexpr double y = 8;
  const QColor filled = !isEnabled()     ? mixed(m_palette.secondary, m_palette.panel, 0.5)
                        : m_palette.dark ? m_palette.active
                                         : m_palette.accent;
  painter.setPen(Qt::NoPen);
  painter.setBrush(m_palette.dark ? m_palette.border.lighter(125) : m_palette.border);
  painter.drawRoundedRect(QRectF(0, y - 1.75, width(), 3.5), 1.75, 1.75);
  painter.setBrush(filled);
  painter.drawRoundedRect(QRectF(0, y - 1.75, xOf(m_place), 3.5), 1.75, 1.75);
  painter.setBrush(m_palette.secondary);
  painter.drawRect(QRectF(xOf(m_default) - 0.5, y + 7, 1, 4));
  if (hasFocus()) {
    QColor halo = filled;
    halo.setAlphaF(colour_part(0.35));
    painter.setBrush(halo);
    painter.drawEllipse(QPointF(xOf(m_place), y), handle_radius + 1.5, handle_radius + 1.5);
  }
  painter.setPen(QPen(hasFocus() ? m_palette.text : filled, 2));
  painter.setBrush(!isEnabled() ? m_palette.panel : m_palette.dark ? m_palette.text : QColor(Qt::white));
  painter.drawEllipse(QPointF(xOf(m_place), y), handle_radius - 1, handle_radius - 1);
  if (!m_marked) return;
  // A triangle under the track, so that it differs from the tick by shape as well.
  const double x = xOf(*m_marked);
  painter.setPen(QPen(m_palette.panel, 1));
  painter.setBrush(m_palette.warning);
  painter.drawPolygon(QPolygonF({{x, y + 3.5}, {x + 4.5, y + 11}, {x - 4.5, y + 11}}));
}

void ValueSlider::dragTo(double x) {
  setPlace((x - m_grab - handle_radius) / std::max(1.0, width() - 2 * handle_radius));
  emit moved(m_place, m_gesture);
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  // Else the keys after it, as Undo, would be those of a field that was typed into before.
  if (auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget())) field->clearFocus();
  ++m_gesture;
  m_dragging = true;
  const double off = event->localPos().x() - xOf(m_place);
  const bool on_handle = std::abs(off) <= handle_radius;
  m_grab = on_handle ? off : 0;
  if (!on_handle) dragTo(event->localPos().x());
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
  if (m_dragging) dragTo(event->localPos().x());
}

void ValueSlider::mouseReleaseEvent(QMouseEvent*) {
  m_dragging = false;
}

void ValueSlider::mouseDoubleClickEvent(QMouseEvent*) {
  m_dragging = false;
  emit resetRequested(m_gesture);
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Backspace || event->key() == Qt::Key_Delete)
    return emit resetRequested(++m_gesture);
  const int steps = steps_of(*event);
  if (steps == 0) return QWidget::keyPressEvent(event);
  if (!event->isAutoRepeat()) ++m_gesture;
  emit stepped(steps, m_gesture);
}

bool ValueSlider::event(QEvent* event) {
  // With the focus on a slider its keys are its own, not the transport's.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool resets = key->key() == Qt::Key_Backspace || key->key() == Qt::Key_Delete;
    const bool plain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    if (plain && (resets || steps_of(*key) != 0)) event->accept();
  }
  return QWidget::event(event);
}

}  // namespace abrazo::widgets
