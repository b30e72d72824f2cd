#include "widgets/sweep/heat_map.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStaticText>
#include <QToolTip>
#include <algorithm>
#include <functional>

#include "widgets/common/qt_versions.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/typeset.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

using State = SweepCell::State;
constexpr double left_margin = 76, right_margin = 16, top_margin = 14, name_height = 20, title_height = 20,
                 legend_height = 46;

QColor colour_at(double fraction) {
  const auto [red, green, blue] = sweep_colour(fraction);
  return QColor::fromRgbF(colour_part(red), colour_part(green), colour_part(blue));
}

QColor ink_on(const QColor& colour) {
  return contrast(Qt::white, colour) > contrast(QColor(20, 20, 24), colour) ? QColor(Qt::white)
                                                                            : QColor(20, 20, 24);
}

/// With its index set low, in the middle of a rectangle.
void draw_title(QPainter& painter, const QRectF& rect, const SweepSide& side) {
  QStaticText title(
      text(typeset(side.title) + escaped_html(side.unit.empty() ? "" : " [" + side.unit + "]")));
  title.setTextFormat(Qt::RichText);
  title.prepare({}, painter.font());
  painter.drawStaticText(rect.center() - QPointF(title.size().width(), title.size().height()) / 2, title);
}

}  // namespace

HeatMap::HeatMap(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName("Heat map of the sweep");
}

void HeatMap::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void HeatMap::showGrid(const SweepGrid& grid) {
  const bool same_size = grid.columns() == m_grid.columns() && grid.rows() == m_grid.rows();
  m_grid = grid;
  if (!same_size) m_selected = m_hovered = -1;
  describe();
  update();
}

void HeatMap::select(int point) {
  if (point == m_selected || point >= m_grid.points()) return;
  m_selected = point;
  describe();
  update();
  emit selectionChanged(point);
}

void HeatMap::describe() {
  QString words = text(m_grid.best_text());
  if (m_selected >= 0)
    words = text(m_grid.place_text(m_selected) + ": " + m_grid.value_text(m_selected)) + ". " + words;
  setAccessibleDescription(words);
}

QRectF HeatMap::area() const {
  return QRectF(rect()).adjusted(left_margin, top_margin, -right_margin,
                                 -(name_height + title_height + legend_height));
}

QRectF HeatMap::cellRect(int point) const {
  const auto [column, row] = m_grid.place_of(point);
  const QRectF all = area();
  const double width = all.width() / m_grid.columns(), height = all.height() / m_grid.rows();
  return {all.left() + column * width, all.bottom() - (row + 1) * height, width, height};
}

int HeatMap::pointAt(const QPointF& place) const {
  if (m_grid.empty() || !area().contains(place)) return -1;
  for (int point = 0; point < m_grid.points(); ++point)
    if (cellRect(point).contains(place)) return point;
  return -1;
}

void HeatMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), m_palette.panel);
  painter.setFont(interface_font(12));
  if (m_grid.empty()) {
    painter.setPen(m_palette.secondary);
    painter.drawText(
        rect().adjusted(20, 0, -20, 0), Qt::AlignCenter | Qt::TextWordWrap,
        "Choose two settings and start: each cell is an evaluation of the takes with its two values.");
    return;
  }
  for (int point = 0; point < m_grid.points(); ++point) drawCell(painter, point);
  drawNames(painter);
  drawMarks(painter);
  drawLegend(painter);
}

void HeatMap::drawHatching(QPainter& painter, const QRectF& rect, bool crossed) const {
  painter.save();
  painter.setClipRect(rect);
  painter.setPen(QPen(crossed ? m_palette.warning : m_palette.secondary, 1));
  for (double x = rect.left() - rect.height(); x < rect.right(); x += 7) {
    painter.drawLine(QPointF(x, rect.bottom()), QPointF(x + rect.height(), rect.top()));
    if (crossed) painter.drawLine(QPointF(x, rect.top()), QPointF(x + rect.height(), rect.bottom()));
  }
  painter.restore();
}

void HeatMap::drawCell(QPainter& painter, int point) const {
  const SweepCell& cell = m_grid.cell(point);
  const QRectF rect = cellRect(point).adjusted(0.75, 0.75, -0.75, -0.75);
  if (cell.state != State::Measured) {
    painter.fillRect(rect, m_palette.window);
    if (cell.state != State::Waiting) drawHatching(painter, rect, cell.state == State::Failed);
    return;
  }
  const QColor colour = colour_at(m_grid.fraction_of(cell.value));
  painter.fillRect(rect, colour);
  const QString number = QString::number(cell.value, 'g', 3);
  if (tabular_width(painter.font(), number) > rect.width() - 6 || rect.height() < 16) return;
  painter.setPen(ink_on(colour));
  draw_tabular(painter, rect, Qt::AlignCenter, number);
}

void HeatMap::drawNames(QPainter& painter) const {
  const QRectF all = area();
  painter.setPen(m_palette.text);
  for (int column = 0; column < m_grid.columns(); ++column) {
    const QRectF cell = cellRect(m_grid.point_at(column, 0));
    painter.drawText(
        QRectF(cell.left(), all.bottom() + 2, cell.width(), name_height), Qt::AlignHCenter | Qt::AlignVCenter,
        painter.fontMetrics().elidedText(text(m_grid.x().values[static_cast<std::size_t>(column)]),
                                         Qt::ElideRight, static_cast<int>(cell.width())));
  }
  for (int row = 0; row < m_grid.rows(); ++row) {
    const QRectF cell = cellRect(m_grid.point_at(0, row));
    painter.drawText(QRectF(22, cell.top(), left_margin - 28, cell.height()),
                     Qt::AlignRight | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(m_grid.y().values[static_cast<std::size_t>(row)]),
                                                      Qt::ElideRight, static_cast<int>(left_margin - 28)));
  }
  painter.setPen(m_palette.secondary);
  draw_title(painter, QRectF(all.left(), all.bottom() + name_height, all.width(), title_height), m_grid.x());
  painter.save();
  painter.translate(4, all.bottom());
  painter.rotate(-90);
  draw_title(painter, QRectF(0, 0, all.height(), 18), m_grid.y());
  painter.restore();
}

void HeatMap::drawMarks(QPainter& painter) const {
  painter.setBrush(Qt::NoBrush);
  if (const auto best = m_grid.best()) {
    // A light ring in a dark one shows on every colour of the map.
    const QRectF cell = cellRect(*best);
    const double size = std::min({cell.width(), cell.height(), 64.0}) - 7;
    QRectF ring(0, 0, std::min(cell.width() - 7, std::max(size, 46.0)), size);
    ring.moveCenter(cell.center());
    painter.setPen(QPen(QColor(10, 10, 12), 4));
    painter.drawEllipse(ring);
    painter.setPen(QPen(Qt::white, 2));
    painter.drawEllipse(ring);
  }
  const auto frame = [&](int point, const QColor& colour, double width) {
    painter.setPen(QPen(QColor(10, 10, 12), width + 2));
    painter.drawRect(cellRect(point).adjusted(2, 2, -2, -2));
    painter.setPen(QPen(colour, width));
    painter.drawRect(cellRect(point).adjusted(2, 2, -2, -2));
  };
  if (m_hovered >= 0 && m_hovered != m_selected) frame(m_hovered, m_palette.secondary, 1);
  if (m_selected >= 0) frame(m_selected, hasFocus() ? m_palette.warning : QColor(Qt::white), 2);
}

void HeatMap::drawLegend(QPainter& painter) const {
  const QRectF all = area();
  const double y = height() - legend_height + 8, bar_width = std::min(220.0, all.width() * 0.45);
  const auto range = m_grid.range();
  if (range) {
    QLinearGradient colours(all.left(), 0, all.left() + bar_width, 0);
    for (int step = 0; step <= 16; ++step) colours.setColorAt(step / 16.0, colour_at(step / 16.0));
    painter.fillRect(QRectF(all.left(), y, bar_width, 9), colours);
    painter.setPen(m_palette.text);
    const QString unit = text(metric_unit(m_grid.metric()));
    painter.drawText(QRectF(all.left(), y + 11, bar_width, 18), Qt::AlignLeft | Qt::AlignVCenter,
                     QString::number(range->first, 'g', 4));
    painter.drawText(QRectF(all.left(), y + 11, bar_width, 18), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(range->second, 'g', 4) + (unit.isEmpty() ? "" : " " + unit));
  }
  double x = all.left() + (range ? bar_width + 18 : 0);
  const auto key = [&](const QString& name, const std::function<void(const QRectF&)>& draw) {
    const QRectF sample(x, y - 1, 18, 12);
    draw(sample);
    painter.setPen(m_palette.secondary);
    painter.drawText(QRectF(x + 24, y - 5, 140, 20), Qt::AlignLeft | Qt::AlignVCenter, name);
    x += 24 + painter.fontMetrics().horizontalAdvance(name) + 14;
  };
  if (m_grid.best())
    key("best", [&](const QRectF& sample) {
      painter.setPen(QPen(m_palette.text, 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(sample);
    });
  if (m_grid.count(State::Undefined) > 0)
    key("no value", [&](const QRectF& sample) { drawHatching(painter, sample, false); });
  if (m_grid.count(State::Failed) > 0)
    key("failed", [&](const QRectF& sample) { drawHatching(painter, sample, true); });
}

void HeatMap::hover(int point) {
  if (point == m_hovered) return;
  m_hovered = point;
  update();
  emit hovered(point);
}

void HeatMap::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (const int point = pointAt(event->localPos()); point >= 0) select(point);
}

void HeatMap::mouseDoubleClickEvent(QMouseEvent* event) {
  if (const int point = pointAt(event->localPos()); point >= 0) emit adoptRequested(point);
}

void HeatMap::mouseMoveEvent(QMouseEvent* event) {
  hover(pointAt(event->localPos()));
}

void HeatMap::leaveEvent(QEvent*) {
  hover(-1);
}

void HeatMap::keyPressEvent(QKeyEvent* event) {
  if (m_grid.empty()) return QWidget::keyPressEvent(event);
  const int from = m_selected >= 0 ? m_selected : m_grid.best().value_or(0);
  switch (event->key()) {
    case Qt::Key_Left:
      return select(m_selected < 0 ? from : m_grid.moved(from, -1, 0));
    case Qt::Key_Right:
      return select(m_selected < 0 ? from : m_grid.moved(from, 1, 0));
    case Qt::Key_Up:
      return select(m_selected < 0 ? from : m_grid.moved(from, 0, 1));
    case Qt::Key_Down:
      return select(m_selected < 0 ? from : m_grid.moved(from, 0, -1));
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (m_selected >= 0) emit adoptRequested(m_selected);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

bool HeatMap::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int point = pointAt(help->pos());
    if (point < 0)
      QToolTip::hideText();
    else
      QToolTip::showText(
          help->globalPos(),
          "<div>" + text(typeset(m_grid.place_text(point))) + "</div><div>" +
              text(escaped_html(metric_words(m_grid.metric()) + " " + m_grid.value_text(point))) + "</div>",
          this, cellRect(point).toRect());
    return true;
  }
  return QWidget::event(event);
}

}  // namespace abrazo::widgets
