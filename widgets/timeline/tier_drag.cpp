#include "widgets/timeline/tier_drag.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

constexpr double same_s = 1e-9;

TierDrag::Kind kind_of(const TierHit& hit, bool draws_anew) {
  using Part = TierHit::Part;
  if (draws_anew) return TierDrag::Kind::Draw;
  switch (hit.part) {
    case Part::Body:
      return TierDrag::Kind::Move;
    case Part::Start:
      return TierDrag::Kind::Start;
    case Part::End:
      return TierDrag::Kind::End;
    case Part::Between:
      return TierDrag::Kind::Between;
    default:
      return TierDrag::Kind::Draw;
  }
}

struct Snap {
  double time_s = 0;
  std::optional<double> mark_s;  ///< snap target, unless it is a frame
};

Snap snap(double time_s, const SnapTargets& targets, double reach_s) {
  if (reach_s <= 0) return {on_frame(time_s, targets.fps), {}};
  const double there = snapped(time_s, targets, reach_s);
  const bool at_cursor = targets.cursor_s && std::abs(*targets.cursor_s - there) < same_s;
  const bool at_other = std::any_of(targets.others_s.begin(), targets.others_s.end(),
                                    [there](double other) { return std::abs(other - there) < same_s; });
  return {there, at_cursor || at_other ? std::optional(there) : std::nullopt};
}

}  // namespace

TierDrag::TierDrag(const Annotations& annotations, const TierHit& hit, double pressed_s,
                   const TierRules& rules, bool draws_anew)
    : annotations_(annotations),
      hit_(hit),
      pressed_s_(pressed_s),
      rules_(rules),
      kind_(kind_of(hit, draws_anew)) {
  if (const Annotation* found = annotations.find(hit.annotation)) dragged_ = *found;
  if (const Annotation* found = annotations.find(hit.next)) next_ = *found;
}

TierDrag::Outcome TierDrag::to(double time_s, const SnapTargets& targets, double reach_s) const {
  switch (kind_) {
    case Kind::Draw:
      return drawn(time_s, targets, reach_s);
    case Kind::Move:
      return moved(time_s, targets, reach_s);
    case Kind::Start:
    case Kind::End:
    case Kind::Between:
      break;
  }
  return resized(time_s, targets, reach_s);
}

TierDrag::Outcome TierDrag::drawn(double time_s, const SnapTargets& targets, double reach_s) const {
  const Snap here = snap(time_s, targets, reach_s);
  const double start = snap(pressed_s_, targets, reach_s).time_s;
  const auto inside = [this](double t) { return std::clamp(t, rules_.range.first_s, rules_.range.last_s); };
  Outcome outcome{annotations_,
                  inside(std::min(start, here.time_s)),
                  inside(std::max(start, here.time_s)),
                  here.mark_s,
                  {},
                  true};
  Annotations tried = annotations_;
  const auto done = tried.draw(hit_.tier, outcome.from_s, outcome.to_s, "new", rules_.conflict, rules_.range);
  if (!done) outcome.refused = done.error().text();
  return outcome;
}

/// Whichever of its ends is nearer to something pulls the other along.
TierDrag::Outcome TierDrag::moved(double time_s, const SnapTargets& targets, double reach_s) const {
  const double length = dragged_.duration_s();
  const double wanted = dragged_.start_s + time_s - pressed_s_;
  const Snap start = snap(wanted, targets, reach_s), end = snap(wanted + length, targets, reach_s);
  const double by_start = start.time_s - wanted, by_end = end.time_s - wanted - length;
  const bool end_wins = end.mark_s && (!start.mark_s || std::abs(by_end) < std::abs(by_start));
  const double from = wanted + (end_wins ? by_end : by_start);
  Outcome outcome{annotations_, from, from + length, end_wins ? end.mark_s : start.mark_s, {}, true};
  const Status done =
      outcome.annotations.place(dragged_.id, from, from + length, rules_.conflict, rules_.range);
  if (!done) outcome.refused = done.error().text();
  return outcome;
}

TierDrag::Outcome TierDrag::resized(double time_s, const SnapTargets& targets, double reach_s) const {
  const double edge = kind_ == Kind::Start ? dragged_.start_s : dragged_.end_s;
  // Where the edge was taken hold of is not quite where it is.
  const Snap snap_to = snap(edge + time_s - pressed_s_, targets, reach_s);
  const double least_s = rules_.fps > 0 ? 1 / rules_.fps : 0.001;
  double there = snap_to.time_s;
  there = kind_ == Kind::Start ? std::min(there, dragged_.end_s - least_s)
                               : std::max(there, dragged_.start_s + least_s);
  if (kind_ == Kind::Between) there = std::min(there, next_.end_s - least_s);
  Outcome outcome{annotations_,
                  kind_ == Kind::Start ? there : dragged_.start_s,
                  kind_ == Kind::Start ? dragged_.end_s : there,
                  snap_to.mark_s,
                  {},
                  true};
  if (there != snap_to.time_s) outcome.snapped_s.reset();
  Annotations& next = outcome.annotations;
  Status done = Done{};
  if (kind_ != Kind::Between) {
    done = next.place(dragged_.id, outcome.from_s, outcome.to_s, rules_.conflict, rules_.range);
  } else if (there < dragged_.end_s) {  // the one that shrinks first: the other needs its room
    done = next.place(dragged_.id, dragged_.start_s, there, Conflict::Replace, rules_.range);
    if (done) done = next.place(next_.id, there, next_.end_s, Conflict::Replace, rules_.range);
  } else {
    done = next.place(next_.id, there, next_.end_s, Conflict::Replace, rules_.range);
    if (done) done = next.place(dragged_.id, dragged_.start_s, there, Conflict::Replace, rules_.range);
  }
  if (!done) outcome.refused = done.error().text();
  return outcome;
}

std::string TierDrag::words() const {
  const std::string what = dragged_.value.empty() ? "label" : dragged_.value;
  switch (kind_) {
    case Kind::Draw:
      return "draw label";
    case Kind::Move:
      return "move " + what;
    case Kind::Start:
    case Kind::End:
      return "resize " + what;
    case Kind::Between:
      break;
  }
  return "move the edge of " + what;
}

SnapTargets snap_targets(const Annotations& annotations, const TierHit& dragged, double fps, double cursor_s,
                         const std::vector<double>& markers_s) {
  SnapTargets targets{fps, on_frame(cursor_s, fps), {}};
  for (const double marker_s : markers_s) targets.others_s.push_back(on_frame(marker_s, fps));
  for (const AnnotationTier& tier : annotations.tiers())
    for (const Annotation& each : tier.annotations) {
      if (each.id == dragged.annotation || each.id == dragged.next) continue;
      targets.others_s.push_back(each.start_s);
      targets.others_s.push_back(each.end_s);
    }
  return targets;
}

}  // namespace abrazo::widgets
