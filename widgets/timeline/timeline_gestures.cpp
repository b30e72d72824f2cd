// What the pointer and the keys do in the timeline.
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::widgets {
namespace {

constexpr double notch_zoom = 0.85;
constexpr double key_zoom = 0.7;

}  // namespace

TimelineHit TimelineView::under(const QPointF& place) const {
  return hit(place.x(), place.y(), axis(), m_content.lanes, m_content.playback.range(), m_content.markers,
             m_content.viewport.is_partial());
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  m_pressed = event->localPos();
  m_pressedTime = axis().time(m_pressed.x());
  m_moved = false;
  if (event->button() == Qt::MiddleButton) {
    m_drag = Drag::View;
    setCursor(Qt::ClosedHandCursor);
  } else if (event->button() == Qt::LeftButton && !beginInTier(event)) {
    begin(under(m_pressed), event);
  }
}

void TimelineView::begin(const TimelineHit& hit, QMouseEvent* event) {
  using Part = TimelineHit::Part;
  if (hit.part != Part::Marker && m_content.selected_marker != 0) selectMarker(0);
  ++m_rangeDrag;
  m_draggedRange = m_content.playback.range().value_or(Playback::Range{});
  switch (hit.part) {
    case Part::Nothing:
    case Part::Names:
      return;
    case Part::Overview:
      m_drag = Drag::Overview;
      return dragTo(event->localPos());
    case Part::In:
      m_drag = Drag::In;
      return;
    case Part::Out:
      m_drag = Drag::Out;
      return;
    case Part::Marker:
      m_drag = Drag::Marker;
      m_draggedMarkers = m_content.markers;
      return selectMarker(hit.marker);
    case Part::Range:
    case Part::Time:
      break;
  }
  if (event->modifiers() & Qt::ShiftModifier) {
    m_drag = Drag::NewRange;
    return;
  }
  m_drag = Drag::Cursor;
  emit scrubbing(true);
  scrubTo(event->localPos().x());
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
  if (m_drag == Drag::None) return showPointer(event->localPos());
  const double far = (event->localPos() - m_pressed).manhattanLength();
  // A click on a marker or a handle selects; it does not move it by the tremble of a hand.
  if (!m_moved && m_drag != Drag::Cursor && m_drag != Drag::Overview &&
      far < QApplication::startDragDistance() / 2.0)
    return;
  m_moved = true;
  if (m_drag == Drag::Tier) return dragInTier(event->localPos(), !(event->modifiers() & Qt::AltModifier));
  dragTo(event->localPos());
}

void TimelineView::dragTo(const QPointF& place) {
  const double time_s = axis().time(place.x());
  const double there = std::clamp(time_s, m_content.playback.first_s, m_content.playback.last_s);
  switch (m_drag) {
    case Drag::None:
    case Drag::Tier:
      return;
    case Drag::Cursor:
      return scrubTo(place.x());
    case Drag::In:
    case Drag::Out:
    case Drag::NewRange:
      return dragRangeTo(there);
    case Drag::Marker:
      m_content.markers.move(m_content.selected_marker, there);
      return redraw();
    case Drag::View:
      m_content.viewport.pan(m_pressedTime - time_s);
      return redraw();
    case Drag::Overview:
      m_content.viewport.centre(m_content.viewport.whole().time(place.x()));
      return redraw();
  }
}

/// Beyond an edge the view scrolls.
void TimelineView::scrubTo(double x_px) {
  constexpr double slowly = 0.3;
  const double beyond = x_px - std::clamp(x_px, axis().left_px, axis().right_px());
  if (beyond != 0 && m_moved) {
    m_content.viewport.pan(slowly * beyond * axis().seconds_per_pixel());
    redraw();
  }
  emit seekRequested(std::clamp(axis().time(x_px), axis().first_s, axis().last_s()));
}

void TimelineView::dragRangeTo(double time_s) {
  if (m_drag == Drag::NewRange) {
    const double start = std::clamp(m_pressedTime, m_content.playback.first_s, m_content.playback.last_s);
    emit rangeRequested(std::min(start, time_s), std::max(start, time_s), m_rangeDrag);
    return;
  }
  // A handle stops at the other one: an empty range would disappear.
  const double least_s = axis().seconds_per_pixel();
  if (m_drag == Drag::In)
    emit rangeRequested(std::min(time_s, m_draggedRange.to_s - least_s), m_draggedRange.to_s, m_rangeDrag);
  else
    emit rangeRequested(m_draggedRange.from_s, std::max(time_s, m_draggedRange.from_s + least_s),
                        m_rangeDrag);
}

void TimelineView::mouseReleaseEvent(QMouseEvent* event) {
  const Drag ended = m_drag;
  m_drag = Drag::None;
  showPointer(event->localPos());
  if (ended == Drag::Cursor) emit scrubbing(false);
  if (ended == Drag::Tier) return endInTier();
  if (ended != Drag::Marker) return;
  if (!m_moved) {
    if (const Marker* marker = m_content.markers.find(m_content.selected_marker))
      emit seekRequested(marker->time_s);
    return;
  }
  const Markers moved = m_content.markers;
  m_content.markers = m_draggedMarkers;  // until the answer shows the moved ones
  emit markersRequested(moved, "move marker");
}

void TimelineView::mouseDoubleClickEvent(QMouseEvent* event) {
  const TimelineHit hit = under(event->localPos());
  const TierHit tier = tierUnder(event->localPos());
  if (event->button() == Qt::LeftButton && tier.annotation != 0)
    tier.part == TierHit::Part::Suggestion ? emit suggestionEntryRequested(tier.annotation)
                                           : emit valueEntryRequested(tier.annotation);
  else if (event->button() == Qt::LeftButton && hit.part == TimelineHit::Part::Marker)
    emit markerEntryRequested(hit.marker);
  else if (event->button() == Qt::LeftButton && hit.part == TimelineHit::Part::Range)
    emit rangeEntryRequested();
  else if (const TimelineTake* take = takeUnder(event->localPos()); take && event->button() == Qt::LeftButton)
    emit takeRequested(take->id);
  else
    mousePressEvent(event);
}

const TimelineTake* TimelineView::takeUnder(const QPointF& place) const {
  TimelineLane lane{};
  const bool on_takes = m_content.lanes.lane_at(place.y(), lane) && lane == TimelineLane::Takes;
  return on_takes ? take_at(m_content, axis().time(place.x())) : nullptr;
}

void TimelineView::showPointer(const QPointF& place) {
  using Part = TimelineHit::Part;
  const Part part = under(place).part;
  setCursor(tierUnder(place).is_edge()              ? Qt::SizeHorCursor
            : part == Part::In || part == Part::Out ? Qt::SizeHorCursor
            : part == Part::Marker                  ? Qt::PointingHandCursor
                                                    : Qt::ArrowCursor);
  if (!QToolTip::isVisible()) return;
  const QString facts = facts_at(m_content, place);
  facts.isEmpty() ? QToolTip::hideText() : QToolTip::showText(mapToGlobal(place.toPoint()), facts, this);
}

void TimelineView::wheelEvent(QWheelEvent* event) {
  const QPoint notches = event->angleDelta();
  const double x = event->position().x();
  if (x < axis().left_px - 8) {
    m_content.lanes.scroll_to(m_content.lanes.asked_scroll_px() - notches.y() / 3.0);
    arrangeScroll();
  } else if (event->modifiers() & Qt::ShiftModifier || notches.x() != 0) {
    const int along = notches.x() != 0 ? notches.x() : notches.y();
    m_content.viewport.pan(-along / 120.0 * 0.1 * axis().span_s);
  } else {
    m_content.viewport.zoom(std::pow(notch_zoom, notches.y() / 120.0), axis().time(x));
  }
  redraw();
  event->accept();
}

void TimelineView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(key_zoom);
    case Qt::Key_Minus:
      return zoom(1 / key_zoom);
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      m_content.viewport.pan((event->key() == Qt::Key_PageUp ? -0.8 : 0.8) * axis().span_s);
      return redraw();
    case Qt::Key_Escape:
      if (m_drag == Drag::Tier) return m_drag = Drag::None, m_content.tiers.drag.reset(), redraw();
      selectMarker(0);
      emit annotationChosen(0);
      return QWidget::keyPressEvent(event);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (m_content.selected_marker != 0) return emit markerEntryRequested(m_content.selected_marker);
      if (m_content.tiers.selected != 0) return emit valueEntryRequested(m_content.tiers.selected);
      return QWidget::keyPressEvent(event);
    default:
      QWidget::keyPressEvent(event);
  }
}

void TimelineView::contextMenuEvent(QContextMenuEvent* event) {
  const bool by_key = event->reason() == QContextMenuEvent::Keyboard;
  const QPoint place(by_key ? static_cast<int>(axis().left_px) : event->pos().x(), event->pos().y());
  const TimelineHit hit = under(place);
  if (hit.part == TimelineHit::Part::Marker) selectMarker(hit.marker);
  if (by_key && m_content.tiers.selected != 0)
    return emit tierMenuRequested(m_content.tiers.active_tier, m_content.tiers.selected,
                                  m_content.playback.cursor_s, mapToGlobal(QPoint(place.x(), 20)));
  if (const TierHit tier = tierUnder(event->pos()); !by_key && tier.tier != 0) {
    const bool confirmed = tier.part != TierHit::Part::Suggestion;
    emit tierChosen(tier.tier);
    if (tier.annotation != 0)
      confirmed ? emit annotationChosen(tier.annotation) : emit suggestionChosen(tier.annotation);
    return emit tierMenuRequested(tier.tier, confirmed ? tier.annotation : 0, axis().time(place.x()),
                                  event->globalPos());
  }
  emit menuRequested(by_key ? mapToGlobal(QPoint(place.x(), 20)) : event->globalPos());
}

}  // namespace abrazo::widgets
