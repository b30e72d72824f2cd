#include "widgets/stream/latency_table.hpp"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QToolTip>
#include <array>

#include "widgets/common/latency_sample.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr int table_row_height = 19, table_head_height = 22;
constexpr double table_margin = 12, column_width = 50, swatch = 8;

}  // namespace

LatencyTable::LatencyTable(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setAccessibleName("Latency by stage");
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  show(latency_rows({}, nullptr), {});
}

QSize LatencyTable::sizeHint() const {
  return {330, table_head_height + table_row_height * static_cast<int>(m_rows.size()) + 8};
}

void LatencyTable::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void LatencyTable::show(std::vector<LatencyRow> rows, const QString& over) {
  const bool resized = rows.size() != m_rows.size();
  m_rows = std::move(rows);
  m_over = over;
  setAccessibleDescription(text());
  if (resized) updateGeometry();
  update();
}

QString LatencyTable::text() const {
  QString text = "stage [ms]\tthis frame\tp50\tp95\tp99\n";
  for (const LatencyRow& row : m_rows)
    text += QStringList{widgets::text(row.name), widgets::text(latency_text(row.here)),
                        widgets::text(latency_text(row.p50)), widgets::text(latency_text(row.p95)),
                        widgets::text(latency_text(row.p99))}
                .join('\t') +
            "\n";
  return text;
}

void LatencyTable::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const auto right = [&](int column) { return width() - table_margin - (3 - column) * column_width; };
  const auto write = [&](int column, double y, double height, const QString& text) {
    draw_tabular(painter, QRectF(0, y, right(column), height), Qt::AlignRight, text);
  };
  painter.setFont(interface_font(11));
  painter.setPen(m_palette.secondary);
  painter.drawText(QRectF(table_margin, 0, 130, table_head_height), Qt::AlignVCenter | Qt::AlignLeft,
                   m_over.isEmpty() ? "ms" : "ms, " + m_over);
  const std::array<const char*, 4> heads = {"here", "p50", "p95", "p99"};
  for (int column = 0; column < 4; ++column)
    write(column, 0, table_head_height, heads[static_cast<std::size_t>(column)]);
  painter.setFont(interface_font(12));
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const LatencyRow& row = m_rows[i];
    const double y = table_head_height + table_row_height * static_cast<double>(i);
    const bool is_stage = i >= 1 && i <= latency_stage_count;
    if (is_stage)
      painter.fillRect(QRectF(table_margin, y + (table_row_height - swatch) / 2, swatch, swatch),
                       latency_colour(static_cast<LatencyStage>(i - 1), m_palette));
    const bool is_sum = i > latency_stage_count;
    painter.setFont(interface_font(12, is_sum ? QFont::DemiBold : QFont::Normal));
    painter.setPen(m_palette.text);
    painter.drawText(QRectF(table_margin + 14, y, 120, table_row_height), Qt::AlignVCenter | Qt::AlignLeft,
                     widgets::text(row.name));
    write(0, y, table_row_height, widgets::text(latency_text(row.here)));
    painter.setPen(is_sum ? m_palette.text : m_palette.secondary);
    write(1, y, table_row_height, widgets::text(latency_text(row.p50)));
    write(2, y, table_row_height, widgets::text(latency_text(row.p95)));
    write(3, y, table_row_height, widgets::text(latency_text(row.p99)));
  }
}

bool LatencyTable::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int row = (help->y() - table_head_height) / table_row_height;
  if (help->y() >= table_head_height && row < static_cast<int>(m_rows.size()))
    QToolTip::showText(help->globalPos(), widgets::text(m_rows[static_cast<std::size_t>(row)].meaning), this);
  else
    QToolTip::hideText();
  return true;
}

void LatencyTable::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction("Copy", this, [this] { QGuiApplication::clipboard()->setText(text()); });
  menu.exec(event->globalPos());
}

}  // namespace abrazo::widgets
