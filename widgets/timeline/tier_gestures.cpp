// What the pointer does in the lanes of tiers, and what those lanes are given.
#include <QMouseEvent>
#include <algorithm>

#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::widgets {
namespace {

constexpr double snap_reach_px = 8;

bool holds_nothing(const AnnotationTier& tier, const std::vector<Suggestion>& suggestions) {
  return tier.annotations.empty() &&
         std::ranges::none_of(suggestions, [&](const Suggestion& each) { return each.tier == tier.id; });
}

}  // namespace

void TimelineView::showAnnotations(const Annotations& annotations, const TierRules& rules) {
  TimelineTiers& tiers = m_content.tiers;
  if (tiers.annotations == annotations && tiers.rules == rules) return;
  tiers.annotations = annotations;
  tiers.rules = rules;
  std::vector<TierLane> lanes;
  for (const AnnotationTier& tier : annotations.tiers())
    lanes.push_back({tier.id, tier.name, holds_nothing(tier, annotations.suggestions())});
  if (lanes != m_content.lanes.tiers()) {
    m_content.lanes.set_tiers(std::move(lanes));
    arrangeScroll();
    updateGeometry();
    emit lanesChanged();
  }
  redraw();
}

void TimelineView::showChosen(int tier, int annotation) {
  if (tier != m_content.tiers.active_tier) {
    m_content.lanes.reveal(tier);
    arrangeScroll();
  }
  m_content.tiers.active_tier = tier;
  m_content.tiers.selected = annotation;
  if (annotation != 0) m_content.selected_marker = 0;
  redraw();
}

void TimelineView::showChosenSuggestion(int suggestion) {
  m_content.tiers.suggestion = suggestion;
  redraw();
}

void TimelineView::showRunning(std::vector<RunningLabel> running) {
  m_content.tiers.running = std::move(running);
  update();
}

void TimelineView::showOfTake(bool on) {
  m_content.lanes.set_of_take(on);
  arrangeScroll();
  updateGeometry();
  redraw();
}

QPoint TimelineView::placeOf(int tier, double time_s) const {
  const double x = std::clamp(axis().x(time_s), axis().left_px, axis().right_px());
  return {static_cast<int>(x), static_cast<int>(m_content.lanes.top_of_tier(tier))};
}

TierHit TimelineView::tierUnder(const QPointF& place) const {
  return tier_hit(place.x(), place.y(), axis(), m_content.lanes, m_content.tiers.annotations,
                  m_content.tiers.selected);
}

/// Ctrl draws over existing labels. A click seeks, as in every lane, and selects the label there.
bool TimelineView::beginInTier(QMouseEvent* event) {
  using Part = TierHit::Part;
  const TierHit found = tierUnder(event->localPos());
  if (found.part == Part::Nothing || event->modifiers() & Qt::ShiftModifier) return false;
  if (m_content.selected_marker != 0) selectMarker(0);
  emit tierChosen(found.tier);
  if (found.part == Part::Suggestion)
    emit suggestionChosen(found.annotation);
  else
    emit annotationChosen(found.annotation);
  if (found.part == Part::Name) return true;
  m_drag = Drag::Tier;
  TierRules& rules = m_content.tiers.rules;
  rules.range.last_s = std::max(rules.range.last_s, m_content.playback.last_s);  // it continues while live
  const bool anew = event->modifiers() & Qt::ControlModifier || found.part == Part::Suggestion;
  m_content.tiers.drag.emplace(m_content.tiers.annotations, found, m_pressedTime, m_content.tiers.rules,
                               anew);
  m_content.tiers.dragged = {};
  return true;
}

void TimelineView::dragInTier(const QPointF& place, bool snaps) {
  TimelineTiers& tiers = m_content.tiers;
  std::vector<double> marks;
  for (const Marker& marker : m_content.markers.all()) marks.push_back(marker.time_s);
  if (const auto range = m_content.playback.range()) marks.insert(marks.end(), {range->from_s, range->to_s});
  TierHit own{TierHit::Part::Nothing, tiers.drag->tier(), tiers.drag->annotation()};
  if (tiers.drag->kind() == TierDrag::Kind::Draw) own.annotation = 0;
  if (tiers.drag->kind() == TierDrag::Kind::Between) own = tierUnder(m_pressed);
  const SnapTargets targets =
      snap_targets(tiers.annotations, own, tiers.rules.fps, m_content.playback.cursor_s, marks);
  const double reach_s = snaps ? snap_reach_px * axis().seconds_per_pixel() : 0;
  tiers.dragged = tiers.drag->to(axis().time(place.x()), targets, reach_s);
  redraw();
}

void TimelineView::endInTier() {
  TimelineTiers& tiers = m_content.tiers;
  const TierDrag drag = *tiers.drag;
  const TierDrag::Outcome outcome = std::move(tiers.dragged);
  tiers.drag.reset();
  redraw();
  if (!m_moved)
    return emit seekRequested(
        std::clamp(m_pressedTime, m_content.playback.first_s, m_content.playback.last_s));
  if (!outcome.refused.empty()) return emit labelRefused(QString::fromStdString(outcome.refused));
  if (drag.kind() == TierDrag::Kind::Draw) return emit labelDrawn(drag.tier(), outcome.from_s, outcome.to_s);
  emit annotationsRequested(outcome.annotations, QString::fromStdString(drag.words()).replace('_', ' '));
}

}  // namespace abrazo::widgets
