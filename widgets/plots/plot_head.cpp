#include "widgets/plots/plot_head.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/plots/plot_colours.hpp"

namespace abrazo::widgets {
namespace {

constexpr double left_margin = 12, title_gap = 14, key_gap = 10, name_gap = 5, square = 8, square_gap = 4;
constexpr double least_mark_room = 14;

QFont key_font() {
  return interface_font(11);
}

QString value_text(Series series, const std::optional<SeriesValues>& values) {
  const double value =
      values ? (*values)[static_cast<std::size_t>(series)] : std::numeric_limits<double>::quiet_NaN();
  return std::isfinite(value) ? QString::number(value, 'f', info_of(series).decimals) : QString("–");
}

double value_width(Series series) {
  constexpr int digits_before = 2;
  return tabular_width(key_font(), QString(info_of(series).decimals + digits_before, '0'));
}

double name_width(Series series) {
  return QFontMetricsF(key_font()).horizontalAdvance(text(info_of(series).brief));
}

double key_width(const PaneSeries& series, bool with_values) {
  double sum = 0;
  for (const Series one : series)
    sum += square + square_gap + name_width(one) + name_gap + (with_values ? value_width(one) : 0) + key_gap;
  return sum;
}

/// What is right of `x`.
QRectF from(const QRectF& place, double x) {
  return {x, place.top() + 4, std::max(0.0, place.right() - x), place.height() - 4};
}

/// @return where the key ends
double paint_key(QPainter& painter, const QRectF& place, double x, const PlotHead& head, bool with_values) {
  painter.setFont(key_font());
  for (const Series series : head.series) {
    painter.fillRect(QRectF(x, place.center().y() - 2, square, square), colour_of(series, head.palette));
    x += square + square_gap;
    painter.setPen(head.palette.secondary);
    painter.drawText(from(place, x), Qt::AlignVCenter | Qt::AlignLeft, text(info_of(series).brief));
    x += name_width(series) + name_gap;
    if (with_values) {
      painter.setPen(head.palette.text);
      draw_tabular(painter, from(place, x), Qt::AlignLeft, value_text(series, head.values));
      x += value_width(series);
    }
    x += key_gap;
  }
  return x;
}

/// Cut where there is no room, but never the unit at its end: without it the numbers say nothing.
QString fitting_title(const QString& title, const QFont& font, double room) {
  const QFontMetricsF metrics(font);
  const auto unit_at = title.lastIndexOf(" [");
  const QString unit = unit_at < 0 ? QString() : title.mid(unit_at);
  const QString name = unit_at < 0 ? title : title.left(unit_at);
  return metrics.elidedText(name, Qt::ElideRight, room - metrics.horizontalAdvance(unit)) + unit;
}

void paint_mark(QPainter& painter, const QRectF& place, double key_end, const PlotHead& head) {
  if (head.mark == PlotMark::None) return;
  const bool follows = head.mark == PlotMark::Following;
  const QString word = follows ? "following" : "End follows";
  const double room = 12 + QFontMetricsF(key_font()).horizontalAdvance(word);
  const bool with_word = key_end + room < place.right();
  const double left = place.right() - (with_word ? room : 10);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(follows ? QPen(Qt::NoPen) : QPen(head.palette.secondary, 1.2));
  painter.setBrush(follows ? head.palette.live : head.palette.panel);
  painter.drawEllipse(QPointF(left + 4, place.center().y() + 2), 3.2, 3.2);
  painter.setPen(head.palette.secondary);
  if (with_word) painter.drawText(from(place, left + 11), Qt::AlignVCenter | Qt::AlignLeft, word);
}

}  // namespace

void paint_plot_head(QPainter& painter, const QRectF& place, const PlotHead& head) {
  const QString title = text(head.title.empty() ? title_of(head.series) : head.title);
  painter.save();
  painter.setClipRect(place, Qt::IntersectClip);
  QFont title_font = interface_font(12, QFont::DemiBold);
  const double room = place.right() - (head.mark == PlotMark::None ? 0 : least_mark_room);
  const double left = place.left() + left_margin;
  const double title_end = left + QFontMetricsF(title_font).horizontalAdvance(title) + title_gap;
  const bool in_one_line = title_end + key_width(head.series, false) < room;
  // Otherwise the title with its unit has a line of its own.
  const QRectF upper(place.left(), place.top() - 3, place.width(), 19);
  const QRectF lower(place.left(), place.top() + 10, place.width(), 20);
  const QRectF& title_line = in_one_line ? place : upper;
  const QRectF& key_line = in_one_line ? place : lower;
  const double key_begin = in_one_line ? title_end : left;
  const bool with_values = key_begin + key_width(head.series, true) < (in_one_line ? room : place.right());
  if (!in_one_line) title_font = interface_font(11, QFont::DemiBold);
  painter.setFont(title_font);
  painter.setPen(head.palette.text);
  painter.drawText(from(title_line, left), Qt::AlignVCenter | Qt::AlignLeft,
                   in_one_line ? title : fitting_title(title, title_font, room - left));
  const double key_end = paint_key(painter, key_line, key_begin, head, with_values);
  paint_mark(painter, title_line, in_one_line ? key_end : title_end, head);
  painter.restore();
}

}  // namespace abrazo::widgets
