#include "widgets/common/tabular.hpp"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

double digit_width(const QFontMetricsF& metrics) {
  double widest = 0;
  for (char c = '0'; c <= '9'; ++c) widest = std::max(widest, metrics.horizontalAdvance(QLatin1Char(c)));
  return widest;
}

double advance(const QFontMetricsF& metrics, double digit, QChar c) {
  return c.isDigit() ? digit : metrics.horizontalAdvance(c);
}

}  // namespace

double tabular_width(const QFont& font, const QString& text) {
  const QFontMetricsF metrics(font);
  const double digit = digit_width(metrics);
  double width = 0;
  for (const QChar c : text) width += advance(metrics, digit, c);
  return width;
}

void draw_tabular(QPainter& painter, const QRectF& rect, Qt::Alignment alignment, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  const double digit = digit_width(metrics);
  const double width = tabular_width(painter.font(), text);
  double x = rect.left();
  if (alignment & Qt::AlignRight) x = rect.right() - width;
  if (alignment & Qt::AlignHCenter) x = rect.center().x() - width / 2;
  const double baseline = rect.center().y() + (metrics.ascent() - metrics.descent()) / 2;
  for (const QChar c : text) {
    const double cell = advance(metrics, digit, c);
    const double own = metrics.horizontalAdvance(c);
    painter.drawText(QPointF(x + (cell - own) / 2, baseline), QString(c));
    x += cell;
  }
}

TabularLabel::TabularLabel(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
}

void TabularLabel::setText(const QString& text) {
  if (text == m_text) return;
  m_text = text;
  const int width = static_cast<int>(std::ceil(tabular_width(font(), text))) + 2;
  if (width > m_widest) {
    m_widest = width;
    updateGeometry();
  }
  update();
}

void TabularLabel::setColour(const QColor& colour) {
  if (colour == m_colour) return;
  m_colour = colour;
  update();
}

QSize TabularLabel::sizeHint() const {
  return {m_widest, fontMetrics().height() + 2};
}

void TabularLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(font());
  painter.setPen(m_colour.isValid() ? m_colour : palette().color(QPalette::WindowText));
  draw_tabular(painter, rect(), m_alignment, m_text);
}

}  // namespace abrazo::widgets
