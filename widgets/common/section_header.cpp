#include "widgets/common/section_header.hpp"

#include <QPainter>

#include "widgets/common/theme.hpp"

namespace abrazo::widgets {

SectionHeader::SectionHeader(const QString& title, QWidget* parent) : QWidget(parent), m_title(title) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFixedHeight(32);
  setColours(palette_of(Theme::Dark));
}

void SectionHeader::setTitle(const QString& title) {
  m_title = title;
  update();
}

void SectionHeader::setColours(const Palette& palette) {
  m_colour = palette.secondary;
  update();
}

void SectionHeader::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(m_colour);
  QFont head = interface_font(11, QFont::DemiBold);
  head.setLetterSpacing(QFont::AbsoluteSpacing, 0.8);
  painter.setFont(head);
  const QRect room = rect().adjusted(12, 0, -8, 0);
  painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                   painter.fontMetrics().elidedText(m_title.toUpper(), Qt::ElideRight, room.width()));
}

}  // namespace abrazo::widgets
