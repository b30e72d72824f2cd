#include "widgets/settings/toggle.hpp"

#include <QKeyEvent>
#include <QPainter>

namespace abrazo::widgets {

Toggle::Toggle(QWidget* parent) : QAbstractButton(parent), m_palette(palette_of(Theme::Dark)) {
  setCheckable(true);
  setFixedSize(sizeHint());
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
}

void Toggle::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void Toggle::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor off = m_palette.dark ? m_palette.border.lighter(140) : m_palette.border.darker(110);
  painter.setPen(hasFocus() ? QPen(m_palette.text, 1.5) : QPen(Qt::NoPen));
  painter.setBrush(isOn() ? m_palette.accent : off);
  painter.drawRoundedRect(QRectF(3, 3, 28, 14), 7, 7);
  painter.setPen(Qt::NoPen);
  painter.setBrush(m_palette.dark ? m_palette.text : QColor(Qt::white));
  painter.drawEllipse(QPointF(isOn() ? 24 : 10, 10), 5, 5);
}

bool Toggle::event(QEvent* event) {
  // The blank key is the transport's elsewhere.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space)
    event->accept();
  return QAbstractButton::event(event);
}

}  // namespace abrazo::widgets
