#include "widgets/scene/pick/pick_card.hpp"

#include <QPainter>
#include <algorithm>

#include "widgets/common/qt_versions.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int line_height = 18, margin = 9;

QFont title_font() {
  return interface_font(13, QFont::DemiBold);
}

/// Between words; a word that is too wide stays whole.
QStringList broken(const QString& line, double width_px) {
  const QFont font = interface_font(13);
  QStringList rows;
  for (const QString& word : line.split(' ')) {
    const QString longer = rows.isEmpty() ? word : rows.back() + ' ' + word;
    if (rows.isEmpty() || tabular_width(font, longer) > width_px)
      rows << word;
    else
      rows.back() = longer;
  }
  return rows;
}

}  // namespace

PickCard::PickCard(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void PickCard::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void PickCard::show(const PickText& text) {
  m_text = text;
  lay();
  setVisible(true);
  raise();
}

void PickCard::setMostWidth(int width_px) {
  if (width_px == m_mostWidth) return;
  m_mostWidth = width_px;
  if (!isHidden()) lay();
}

void PickCard::lay() {
  constexpr int beside_text = 2 * margin + 2;
  const int room = m_mostWidth - beside_text;
  m_title =
      QFontMetrics(title_font()).elidedText(QString::fromStdString(m_text.title), Qt::ElideMiddle, room);
  m_lines.clear();
  double wide = tabular_width(title_font(), m_title);
  for (const std::string& line : m_text.lines)
    for (const QString& row : broken(QString::fromStdString(line), room)) {
      m_lines << row;
      wide = std::max(wide, tabular_width(interface_font(13), row));
    }
  // Grows immediately and never shrinks while it is open: running numbers must not shake it.
  const int width = std::max(static_cast<int>(wide) + beside_text, isVisible() ? this->width() : 0);
  resize(std::min(width, m_mostWidth), wholeHeight());
  update();
}

int PickCard::wholeHeight() const {
  return line_height * (static_cast<int>(m_lines.size()) + 1) + 2 * margin;
}

void PickCard::limit(int height_px) {
  constexpr int least_px = 2 * line_height + 2 * margin;
  const int rows = (std::max(height_px, least_px) - 2 * margin) / line_height;
  resize(width(), std::min(rows * line_height + 2 * margin, wholeHeight()));
}

void PickCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor back = m_palette.panel;
  back.setAlphaF(colour_part(0.94));
  painter.setBrush(back);
  painter.setPen(m_palette.border);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  painter.setPen(m_palette.text);
  painter.setFont(title_font());
  QRectF line(margin, margin, width() - 2 * margin, line_height);
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, m_title);
  painter.setFont(interface_font(13));
  painter.setPen(mixed(m_palette.text, m_palette.secondary, 0.6));
  for (const QString& text : m_lines) {
    line.translate(0, line_height);
    if (line.bottom() > height() - margin) return;
    draw_tabular(painter, line, Qt::AlignLeft, text);
  }
}

}  // namespace abrazo::widgets
