#include "widgets/compare/run_card.hpp"

#include <QPainter>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr std::size_t shown_figures = 3;
constexpr double card_margin = 12, mark = 18, gap = 10;

}  // namespace

RunCard::RunCard(const QString& letter, QWidget* parent)
    : QWidget(parent), m_palette(palette_of(Theme::Dark)), m_letter(letter) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  describe();
}

void RunCard::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void RunCard::showRun(const QString& origin, const QString& settings) {
  if (origin == m_origin && settings == m_settings) return;
  m_origin = origin;
  m_settings = settings;
  describe();
}

void RunCard::showFigures(const std::vector<FigureRow>& figures) {
  if (figures == m_figures) return;
  m_figures = figures;
  updateGeometry();  // without figures it is one line high
  describe();
}

void RunCard::describe() {
  QString words = m_origin + ", " + m_settings;
  for (std::size_t i = 0; i < m_figures.size() && i < shown_figures; ++i) {
    const FigureRow& row = m_figures[i];
    words +=
        QString(", %1 %2 %3")
            .arg(QString::fromStdString(row.name), QString::fromStdString(m_letter == "A" ? row.a : row.b),
                 QString::fromStdString(row.unit));
  }
  setAccessibleName("Run " + m_letter);
  setAccessibleDescription(words);
  setToolTip(words);
  update();
}

void RunCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF badge(card_margin, 4.5, mark, mark);
  painter.setPen(QPen(m_letter == "A" ? m_palette.warning : m_palette.text, 1.2,
                      m_letter == "A" ? Qt::DashLine : Qt::SolidLine));
  painter.drawRoundedRect(badge, 4, 4);
  painter.setPen(m_palette.text);
  painter.setFont(interface_font(11, QFont::DemiBold));
  painter.drawText(badge, Qt::AlignCenter, m_letter);
  const double left = badge.right() + 8;
  const QRectF upper(left, 3, width() - left - card_margin, 21),
      lower(left, 24, width() - left - card_margin, 20);
  painter.setFont(interface_font(12));
  painter.setPen(m_palette.secondary);
  const double origin = std::min(tabular_width(painter.font(), m_origin) + gap, upper.width());
  draw_tabular(painter, upper, Qt::AlignRight, m_origin);
  painter.setPen(m_palette.text);
  const QRectF room = upper.adjusted(0, 0, -origin, 0);
  painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                   QFontMetricsF(painter.font()).elidedText(m_settings, Qt::ElideRight, room.width()));
  paintFigures(painter, lower);
}

void RunCard::paintFigures(QPainter& painter, QRectF line) const {
  const bool is_a = m_letter == "A";
  for (std::size_t i = 0; i < m_figures.size() && i < shown_figures; ++i) {
    const FigureRow& row = m_figures[i];
    const bool better = row.better == (is_a ? Better::A : Better::B);
    const QString name = QString::fromStdString(row.name).toLower() + " ";
    const QString value = QString::fromStdString(is_a ? row.a : row.b) + " " +
                          QString::fromStdString(row.unit) + (better ? " ▾" : "");
    const double name_width = tabular_width(painter.font(), name),
                 width = tabular_width(painter.font(), value);
    if (name_width + width > line.width()) return;  // the table below has them all
    painter.setPen(m_palette.secondary);
    draw_tabular(painter, line, Qt::AlignLeft, name);
    painter.setPen(better ? m_palette.good : m_palette.text);
    draw_tabular(painter, line.adjusted(name_width, 0, 0, 0), Qt::AlignLeft, value);
    line.adjust(name_width + width + gap, 0, 0, 0);
  }
}

}  // namespace abrazo::widgets
