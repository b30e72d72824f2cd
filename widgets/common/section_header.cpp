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

void SectionHeader::setKeys(std::vector<Key> keys) {
  m_keys = std::move(keys);
  update();
}

void SectionHeader::setColours(const Palette& palette) {
  m_colour = palette.secondary;
  update();
}

QString SectionHeader::nameOf(const Key& key, bool brief) const {
  return brief && !key.brief.isEmpty() ? key.brief : key.name;
}

int SectionHeader::widthOf(const QFontMetrics& metrics, bool brief) const {
  int wide = 0;
  for (const Key& key : m_keys) wide += metrics.horizontalAdvance(nameOf(key, brief)) + 20;
  return wide;
}

void SectionHeader::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(m_colour);
  QFont head = interface_font(11, QFont::DemiBold);
  head.setLetterSpacing(QFont::AbsoluteSpacing, 0.8);
  painter.setFont(head);
  painter.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignVCenter | Qt::AlignLeft, m_title.toUpper());

  const int room = width() - 24 - painter.fontMetrics().horizontalAdvance(m_title.toUpper());
  painter.setFont(interface_font(11));
  const bool brief = widthOf(painter.fontMetrics(), false) > room;
  if (brief && widthOf(painter.fontMetrics(), true) > room) return;
  int right = width() - 12;
  // NOLINTNEXTLINE(modernize-loop-convert): clang 14 does not compile gcc 12's std::views::reverse
  for (auto key = m_keys.rbegin(); key != m_keys.rend(); ++key) {
    const QString name = nameOf(*key, brief);
    const int text = painter.fontMetrics().horizontalAdvance(name);
    painter.setPen(m_colour);
    painter.drawText(QRect(right - text, 0, text + 2, height()), Qt::AlignVCenter, name);
    painter.fillRect(QRect(right - text - 12, height() / 2 - 4, 8, 8), key->colour);
    right -= text + 20;
  }
}

}  // namespace abrazo::widgets
