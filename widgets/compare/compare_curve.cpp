#include "widgets/compare/compare_curve.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr double curve_margin = 12, top_margin = 4, axis_height = 18;

}  // namespace

CompareCurve::CompareCurve(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName("Difference of A and B over time");
  setToolTip("A dashed, B solid. Click: go there; left and right: one step.");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void CompareCurve::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void CompareCurve::setFigure(StepFigure figure) {
  m_figure = figure;
  update();
}

void CompareCurve::setSteps(std::vector<ComparedStep> steps) {
  if (steps.empty() && m_steps.empty()) return;
  m_steps = std::move(steps);
  update();
}

void CompareCurve::setCursor(double time_s) {
  if (time_s == m_cursor_s || m_steps.empty()) return void(m_cursor_s = time_s);
  const auto is_inside = [this](double at_s) {
    return at_s >= m_steps.front().time_s && at_s <= m_steps.back().time_s;
  };
  const bool is_seen = is_inside(time_s) || is_inside(m_cursor_s);
  m_cursor_s = time_s;
  if (!is_seen) return;  // live frames are newer than the last figures
  setAccessibleDescription(reading());
  update();
}

QString CompareCurve::reading() const {
  const auto at = step_at(m_steps, m_cursor_s);
  if (at < 0) return {};
  const ComparedStep& step = m_steps[static_cast<std::size_t>(at)];
  const RunFigureInfo& info = info_of(m_figure);
  const auto value = [&](double of_run) {
    return std::isfinite(of_run)
               ? QString::number(info.scale * of_run, 'f', info.decimals) + " " + text(info.unit)
               : QString("—");
  };
  const auto place = static_cast<std::size_t>(m_figure);
  if (m_figure == StepFigure::PartnerDistance) return value(step.b[place]);
  return "A " + value(step.a[place]) + " · B " + value(step.b[place]);
}

CurveScale CompareCurve::scale() const {
  CurveScale scale;
  scale.left = curve_margin;
  scale.top = top_margin + axis_height;
  scale.width = std::max(1.0, width() - 2 * curve_margin);
  scale.height = std::max(1.0, height() - top_margin - 2 * axis_height);
  if (!m_steps.empty()) {
    scale.first_s = m_steps.front().time_s;
    scale.last_s = m_steps.back().time_s;
  }
  scale.upper = curve_upper(m_steps, m_figure);
  return scale;
}

void CompareCurve::paintRun(QPainter& painter, const CurveScale& scale, bool of_b) const {
  const RunFigureInfo& info = info_of(m_figure);
  QPainterPath path;
  bool is_down = false;
  double last_x = -1;
  for (const ComparedStep& step : m_steps) {
    const double value = (of_b ? step.b : step.a)[static_cast<std::size_t>(m_figure)];
    const double x = scale.x(step.time_s);
    if (!std::isfinite(value)) {
      is_down = false;
      continue;
    }
    if (is_down && x - last_x < 0.5) continue;  // finer than the screen
    const QPointF point(x, scale.y(info.scale * value));
    is_down ? path.lineTo(point) : path.moveTo(point);
    if (m_steps.size() == 1) painter.drawEllipse(point, 2.5, 2.5);
    is_down = true;
    last_x = x;
  }
  painter.drawPath(path);
}

void CompareCurve::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(interface_font(11));
  const CurveScale at = scale();
  const QRectF area(at.left, at.top, at.width, at.height);
  painter.setPen(m_palette.secondary);
  const RunFigureInfo& info = info_of(m_figure);
  if (m_steps.empty()) {
    painter.drawText(rect(), Qt::AlignCenter, "nothing to compare yet");
    return;
  }
  const int decimals = at.upper < 1 ? 3 : at.upper < 10 ? 1 : 0;
  draw_tabular(painter, QRectF(at.left, top_margin, at.width, axis_height), Qt::AlignLeft,
               QString::number(at.upper, 'f', decimals) + " " + text(info.unit));
  draw_tabular(painter, QRectF(at.left, top_margin, at.width, axis_height), Qt::AlignRight, reading());
  draw_tabular(painter, QRectF(at.left, area.bottom(), at.width, axis_height), Qt::AlignLeft,
               QString::number(at.first_s, 'f', 1) + " s");
  draw_tabular(painter, QRectF(at.left, area.bottom(), at.width, axis_height), Qt::AlignRight,
               QString::number(at.last_s, 'f', 1) + " s");
  painter.setPen(QPen(m_palette.border, 1));
  for (const double share : {0.0, 0.5, 1.0})
    painter.drawLine(QPointF(area.left(), area.top() + share * area.height()),
                     QPointF(area.right(), area.top() + share * area.height()));
  painter.save();
  painter.setClipRect(area.adjusted(-2, -2, 2, 2));
  painter.setBrush(Qt::NoBrush);
  if (m_figure != StepFigure::PartnerDistance) {
    painter.setPen(QPen(m_palette.warning, 1.4, Qt::DashLine));
    paintRun(painter, at, false);
  }
  painter.setPen(QPen(m_palette.text, 1.4));
  paintRun(painter, at, true);
  painter.restore();
  if (m_cursor_s >= at.first_s - 1e-9 && m_cursor_s <= at.last_s + 1e-9) {
    painter.setPen(QPen(m_palette.dark ? QColor(Qt::white) : m_palette.text, 1));
    painter.drawLine(QPointF(at.x(m_cursor_s), area.top() - 2), QPointF(at.x(m_cursor_s), area.bottom() + 2));
  }
  if (hasFocus()) {
    painter.setPen(QPen(m_palette.accent, 1));
    painter.drawRoundedRect(QRectF(rect()).adjusted(4.5, 0.5, -4.5, -0.5), 4, 4);
  }
}

void CompareCurve::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !m_steps.empty()) emit seekRequested(scale().time(event->x()));
}

void CompareCurve::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) && !m_steps.empty()) emit seekRequested(scale().time(event->x()));
}

void CompareCurve::stepBy(int steps) {
  const auto at = step_at(m_steps, m_cursor_s);
  if (at < 0) return;
  const auto last = static_cast<std::ptrdiff_t>(m_steps.size()) - 1;
  emit seekRequested(
      m_steps[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at + steps, 0, last))].time_s);
}

void CompareCurve::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Left) return stepBy(-1);
  if (event->key() == Qt::Key_Right) return stepBy(1);
  QWidget::keyPressEvent(event);
}

}  // namespace abrazo::widgets
