#include "widgets/stream/stream_head.hpp"

#include <QPainter>

#include "widgets/common/plain_text.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/stream/stream_sign.hpp"

namespace abrazo::widgets {

StreamHead::StreamHead(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName("State of the connection");
  show(headline_of(nullptr));
}

void StreamHead::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void StreamHead::show(const StreamHeadline& headline) {
  m_headline = headline;
  const QString words = QString::fromStdString(headline.word + ", " + headline.detail);
  if (words == accessibleDescription()) return;
  setToolTip(plain_tip(words));
  setAccessibleDescription(words);
  update();
}

void StreamHead::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  constexpr int left = 32;
  draw_sign(painter, {19, 14}, m_headline.mark, m_palette);
  const auto write = [&](const QRectF& line, const std::string& words, Qt::TextElideMode elide) {
    painter.drawText(
        line, Qt::AlignVCenter | Qt::AlignLeft,
        QFontMetricsF(painter.font()).elidedText(QString::fromStdString(words), elide, line.width()));
  };
  painter.setFont(interface_font(13, QFont::DemiBold));
  painter.setPen(m_headline.mark == StreamMark::Off ? m_palette.text : colour_of(m_headline.mark, m_palette));
  write(QRectF(left, 3, width() - left - 12, 22), m_headline.word, Qt::ElideRight);
  painter.setFont(interface_font(12));
  painter.setPen(m_palette.secondary);
  write(QRectF(left, 24, width() - left - 12, 19), m_headline.detail, Qt::ElideMiddle);
}

}  // namespace abrazo::widgets
