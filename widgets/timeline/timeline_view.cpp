#include "widgets/timeline/timeline_view.hpp"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int lane_height = 27;
constexpr int ruler_height = 22;
constexpr int names_width = 104;
constexpr int right_margin = 16;
enum Lane { SourceLane, MovesLane, CostLane };

QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<int>(utf8.size()));
}

QString tickText(double time_s, double step_s) {
  if (step_s >= 60) return QString("%1 min").arg(time_s / 60, 0, 'f', 0);
  return QString::number(time_s, 'f', step_s < 0.1 ? 2 : step_s < 1 ? 1 : 0) + " s";
}

}  // namespace

TimelineView::TimelineView(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setMinimumHeight(ruler_height + 3 * lane_height + 14);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFixedHeight(ruler_height + 3 * lane_height + 18);
}

void TimelineView::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  m_library = std::move(library);
  m_tracks.clear();
  m_nextIndex = 0;
  update();
}

void TimelineView::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void TimelineView::refresh(const FrameHistory& history, const Playback& playback) {
  for (const FrameSnapshotPtr& frame : history.since(m_nextIndex)) take(*frame);
  m_playback = playback;
  m_tracks.drop_before(playback.first_s);
  if (playback.state == Playback::State::Following)
    m_axis.follow(playback.first_s, playback.last_s);
  else if (!m_scrubbing)
    m_axis.reveal(playback.cursor_s);
  update();
}

void TimelineView::take(const FrameSnapshot& frame) {
  m_nextIndex = frame.index + 1;
  const FrameResult& result = frame.result;
  if (!m_library || result.selected < 0) return m_tracks.append(frame.time_s, -1, {}, 0);
  const Candidate& chosen = result.candidates[static_cast<std::size_t>(result.selected)];
  m_tracks.append(frame.time_s, static_cast<int>(m_library->source(chosen.pair).take),
                  m_library->label(chosen.pair), chosen.cost.total);
}

QRectF TimelineView::laneRect(int lane) const {
  return {m_axis.left_px, ruler_height + 4.0 + lane * lane_height, m_axis.width_px, lane_height};
}

QRectF TimelineView::block(const TimelineTracks::Interval& interval, int lane) const {
  const double left = std::max(m_axis.x(interval.from_s), m_axis.left_px);
  const double right = std::min(m_axis.x(interval.to_s), m_axis.right_px());
  return {left, laneRect(lane).top() + 3, std::max(0.0, right - left), lane_height - 6.0};
}

void TimelineView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), m_palette.panel);
  painter.setFont(interface_font(12));
  painter.setPen(m_palette.secondary);
  const char* names[] = {"Source", "Moves", "Cost"};
  for (int lane = SourceLane; lane <= CostLane; ++lane)
    painter.drawText(QRectF(14, laneRect(lane).top(), names_width - 14, lane_height), Qt::AlignVCenter,
                     names[lane]);
  paintRuler(painter);
  painter.setClipRect(QRectF(m_axis.left_px, 0, m_axis.width_px, height()));
  paintSources(painter);
  paintMoves(painter);
  paintCost(painter);
  paintEvicted(painter);
  painter.setClipping(false);
  paintCursor(painter);
}

void TimelineView::paintRuler(QPainter& painter) const {
  painter.setFont(interface_font(12));
  const double step = m_axis.tick_s(90);
  for (const double tick : m_axis.ticks(90)) {
    const double x = std::round(m_axis.x(tick)) + 0.5;
    painter.setPen(mixed(m_palette.secondary, m_palette.panel, 0.55));
    painter.drawLine(QPointF(x, 4), QPointF(x, ruler_height - 2));
    painter.setPen(m_palette.secondary);
    const QString label = tickText(tick, step);
    if (x + 5 + tabular_width(painter.font(), label) < width())
      draw_tabular(painter, QRectF(x + 5, 2, 80, ruler_height - 4), Qt::AlignLeft, label);
  }
  if (m_playback.out_s > m_playback.in_s) {
    const QRectF range(QPointF(m_axis.x(m_playback.in_s), 0),
                       QPointF(m_axis.x(m_playback.out_s), ruler_height));
    painter.fillRect(range & QRectF(m_axis.left_px, 0, m_axis.width_px, ruler_height),
                     QColor(47, 111, 184, 70));
  }
}

void TimelineView::paintSources(QPainter& painter) const {
  painter.setFont(interface_font(12));
  for (const auto& interval : m_tracks.sources()) {
    if (interval.key < 0 || interval.to_s < m_axis.first_s || interval.from_s > m_axis.last_s()) continue;
    const QRectF area = block(interval, SourceLane);
    painter.setPen(Qt::NoPen);
    painter.setBrush(take_colour(m_palette, interval.key));
    painter.drawRoundedRect(area.adjusted(0.5, 0, -0.5, 0), 2, 2);
    if (!m_library) continue;
    const QString number =
        text(short_take_name(m_library->takes()[static_cast<std::size_t>(interval.key)].name));
    if (area.width() < tabular_width(painter.font(), number) + 7) continue;
    painter.setPen(m_palette.dark ? QColor("#e6e9ee") : m_palette.text);
    draw_tabular(painter, area.adjusted(5, 0, 0, 0), Qt::AlignLeft, number);
  }
}

void TimelineView::paintMoves(QPainter& painter) const {
  painter.setFont(interface_font(12));
  for (const auto& interval : m_tracks.moves()) {
    if (interval.to_s < m_axis.first_s || interval.from_s > m_axis.last_s()) continue;
    const QRectF area = block(interval, MovesLane);
    const QColor colour =
        label_colour(m_palette, interval.key < 0 ? std::string_view() : m_tracks.label(interval.key));
    painter.fillRect(area, mixed(colour, m_palette.panel, m_palette.dark ? 0.26 : 0.20));
    painter.fillRect(QRectF(area.left(), area.top(), std::min(2.5, area.width()), area.height()), colour);
    if (interval.key < 0) continue;
    const QString name = text(m_tracks.label(interval.key)).replace('_', ' ');
    const QString fitting =
        painter.fontMetrics().elidedText(name, Qt::ElideRight, static_cast<int>(area.width()) - 12);
    constexpr int readable = 6;  // fewer letters of a name say nothing
    if (fitting != name && fitting.size() < readable) continue;
    painter.setPen(m_palette.text);
    painter.drawText(area.adjusted(8, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, fitting);
  }
}

void TimelineView::paintCost(QPainter& painter) const {
  const double largest = m_tracks.usual_cost(m_axis.first_s, m_axis.last_s());
  if (!(largest > 0)) return;
  const QRectF area = laneRect(CostLane).adjusted(0, 3, 0, -2);
  QPainterPath curve;
  // One point per pixel column: the largest within it, so that no peak is lost.
  double column = -1, peak = 0;
  const auto put = [&] {
    if (column < 0) return;
    const QPointF point(column, area.bottom() - std::min(1.0, peak / largest) * area.height());
    curve.elementCount() == 0 ? curve.moveTo(point) : curve.lineTo(point);
  };
  const auto before = [](const TimelineTracks::Sample& s, double t) { return s.time_s < t; };
  const auto& costs = m_tracks.costs();
  for (auto it = std::lower_bound(costs.begin(), costs.end(), m_axis.first_s, before);
       it != costs.end() && it->time_s <= m_axis.last_s(); ++it) {
    const double here = std::floor(m_axis.x(it->time_s));
    if (here != column) {
      put();
      column = here;
      peak = 0;
    }
    peak = std::max(peak, it->value);
  }
  put();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(m_palette.user, 1.2));
  painter.drawPath(curve);
}

void TimelineView::paintEvicted(QPainter& painter) const {
  const double end = std::min(m_axis.x(m_playback.first_s), m_axis.right_px());
  const double begin = std::max(m_axis.x(0), m_axis.left_px);
  if (end - begin < 1 || m_playback.first_s <= 0.5) return;
  painter.fillRect(QRectF(begin, 0, end - begin, height()),
                   QBrush(mixed(m_palette.secondary, m_palette.panel, 0.45), Qt::BDiagPattern));
}

void TimelineView::paintCursor(QPainter& painter) const {
  const double x = std::round(m_axis.x(m_playback.cursor_s)) + 0.5;
  if (x < m_axis.left_px - 1 || x > m_axis.right_px() + 1) return;
  const QColor ink = m_palette.dark ? QColor(Qt::white) : m_palette.text;
  painter.setPen(QPen(ink, 1.6));
  painter.drawLine(QPointF(x, 5), QPointF(x, height()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  painter.drawPolygon(QPolygonF({{x - 5, 0}, {x + 5, 0}, {x, 7}}));
}

void TimelineView::resizeEvent(QResizeEvent*) {
  m_axis.left_px = names_width + 16;
  m_axis.width_px = std::max(50.0, width() - m_axis.left_px - right_margin);
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || event->localPos().x() < m_axis.left_px - 8) return;
  m_scrubbing = true;
  emit seekRequested(m_axis.time(event->localPos().x()));
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
  if (m_scrubbing) emit seekRequested(m_axis.time(event->localPos().x()));
}

void TimelineView::mouseReleaseEvent(QMouseEvent*) {
  m_scrubbing = false;
}

void TimelineView::wheelEvent(QWheelEvent* event) {
  const double factor = std::pow(0.85, event->angleDelta().y() / 120.0);
  const bool following = m_playback.state == Playback::State::Following;
  m_axis.zoom(factor, m_playback.cursor_s);
  if (following) m_axis.follow(m_playback.first_s, m_playback.last_s);
  update();
}

bool TimelineView::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const double time = m_axis.time(help->x());
  QString tip;
  for (const auto& interval : m_tracks.sources())
    if (m_library && interval.key >= 0 && interval.from_s <= time && time < interval.to_s)
      tip = text(m_library->takes()[static_cast<std::size_t>(interval.key)].name);
  for (const auto& interval : m_tracks.moves())
    if (interval.key >= 0 && interval.from_s <= time && time < interval.to_s)
      tip += (tip.isEmpty() ? "" : " · ") + text(m_tracks.label(interval.key));
  tip.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), tip, this);
  return true;
}

}  // namespace abrazo::widgets
