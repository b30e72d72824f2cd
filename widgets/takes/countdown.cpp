#include "widgets/takes/countdown.hpp"

#include <QPainter>
#include <algorithm>

#include "widgets/common/qt_versions.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {

Countdown::Countdown(QWidget* over) : QWidget(over), m_palette(palette_of(Theme::Dark)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setObjectName("countdown");
  hide();
}

void Countdown::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void Countdown::showCount(int seconds, const QString& take) {
  if (seconds == m_count && take == m_take) return;
  m_count = seconds;
  m_take = take;
  setAccessibleName(seconds > 0 ? QString("%1 begins in %2 seconds").arg(take).arg(seconds) : QString());
  setVisible(seconds > 0);
  if (seconds == 0) return;
  const QSize whole = parentWidget()->size();
  const int side = std::min(240, std::min(whole.width(), whole.height()) - 16);
  setGeometry((whole.width() - side) / 2, (whole.height() - side) / 2, side, side);
  raise();
  update();
}

void Countdown::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = m_palette.window;
  ground.setAlphaF(colour_part(0.82));
  painter.setBrush(ground);
  painter.setPen(QPen(m_palette.live, 6));
  painter.drawEllipse(QRectF(rect()).adjusted(4, 4, -4, -4));
  painter.setPen(m_palette.text);
  painter.setFont(interface_font(height() / 2, QFont::Bold));
  painter.drawText(QRect(0, height() / 16, width(), height() * 3 / 4), Qt::AlignCenter,
                   QString::number(m_count));
  painter.setFont(interface_font(15, QFont::DemiBold));
  painter.setPen(m_palette.secondary);
  const QRect below(width() / 6, height() * 11 / 16, width() * 2 / 3, height() / 8);
  painter.drawText(below, Qt::AlignCenter,
                   painter.fontMetrics().elidedText(m_take, Qt::ElideRight, below.width()));
}

}  // namespace abrazo::widgets
