#include "widgets/compare/figure_table.hpp"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <array>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr int row_height = 20, head_height = 20;
constexpr double margin = 12;

/// Right ends of the columns of A, B, B − A and the unit.
std::array<double, 4> column_ends(double width) {
  const double unit = width - margin, difference = unit - 42, b = difference - 58, a = b - 58;
  return {a, b, difference, unit};
}

}  // namespace

FigureTable::FigureTable(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setAccessibleName("Figures of A and B");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  showRows({});
}

QSize FigureTable::sizeHint() const {
  return {300, head_height + row_height * static_cast<int>(m_rows.size())};
}

void FigureTable::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void FigureTable::showRows(std::vector<FigureRow> rows) {
  if (rows == m_rows) return;
  const bool resized = rows.size() != m_rows.size();
  m_rows = std::move(rows);
  setAccessibleDescription(text());
  if (resized) updateGeometry();
  update();
}

QString FigureTable::text() const {
  QString text = "figure\tA\tB\tB-A\tunit\n";
  for (const FigureRow& row : m_rows)
    text += QStringList{widgets::text(row.name), widgets::text(row.a), widgets::text(row.b),
                        widgets::text(row.difference), widgets::text(row.unit)}
                .join('\t') +
            "\n";
  return text;
}

void FigureTable::paintEvent(QPaintEvent*) {
  if (m_rows.empty()) return;
  QPainter painter(this);
  painter.setFont(interface_font(11));
  painter.setPen(m_palette.secondary);
  const auto ends = column_ends(width());
  const std::array<const char*, 3> heads = {"A", "B", "B − A"};
  for (std::size_t i = 0; i < heads.size(); ++i)
    draw_tabular(painter, QRectF(0, 0, ends[i], head_height), Qt::AlignRight, heads[i]);
  painter.setFont(interface_font(12));
  for (std::size_t r = 0; r < m_rows.size(); ++r)
    paintRow(painter, m_rows[r],
             QRectF(0, head_height + row_height * static_cast<double>(r), width(), row_height));
}

void FigureTable::paintRow(QPainter& painter, const FigureRow& row, const QRectF& line) const {
  const auto ends = column_ends(width());
  const auto write = [&](double end, const QString& text, const QColor& colour) {
    painter.setPen(colour);
    draw_tabular(painter, QRectF(0, line.top(), end, line.height()), Qt::AlignRight, text);
  };
  painter.setPen(m_palette.secondary);
  const QRectF name(margin, line.top(), ends[0] - margin - 44, line.height());
  painter.drawText(
      name, Qt::AlignVCenter | Qt::AlignLeft,
      QFontMetricsF(painter.font()).elidedText(widgets::text(row.name), Qt::ElideRight, name.width()));
  const bool a = row.better == Better::A, b = row.better == Better::B;
  write(ends[0], (a ? "▾ " : "") + widgets::text(row.a), a ? m_palette.good : m_palette.text);
  write(ends[1], (b ? "▾ " : "") + widgets::text(row.b), b ? m_palette.good : m_palette.text);
  write(ends[2], widgets::text(row.difference), m_palette.secondary);
  painter.setPen(m_palette.secondary);
  draw_tabular(painter, QRectF(ends[2] + 6, line.top(), ends[3] - ends[2] - 6, line.height()), Qt::AlignLeft,
               widgets::text(row.unit));
}

bool FigureTable::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int row = (help->y() - head_height) / row_height;
  if (help->y() >= head_height && row < static_cast<int>(m_rows.size()))
    QToolTip::showText(help->globalPos(), widgets::text(m_rows[static_cast<std::size_t>(row)].help), this);
  else
    QToolTip::hideText();
  return true;
}

}  // namespace abrazo::widgets
