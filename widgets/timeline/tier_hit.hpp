#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/annotation/annotations.hpp"
#include "widgets/timeline/timeline_axis.hpp"
#include "widgets/timeline/timeline_lanes.hpp"

namespace abrazo::widgets {

/// The item under the pointer in the lanes of tiers. Independent of Qt.
struct TierHit {
  enum class Part {
    Nothing,     ///< no lane of a tier
    Name,        ///< at the left of a lane
    Empty,       ///< of a lane
    Body,        ///< of an annotation
    Start,       ///< its edge
    End,         ///< its edge
    Between,     ///< the common edge of two annotations
    Suggestion,  ///< a suggestion, if there is no annotation
  };
  Part part = Part::Nothing;
  int tier = 0;
  int annotation = 0;  ///< for Between the earlier one; for Suggestion its id
  int next = 0;        ///< for Between the later one

  bool operator==(const TierHit&) const = default;
  bool is_edge() const { return part == Part::Start || part == Part::End || part == Part::Between; }
};

/// Distance within which the pointer grabs an edge inside the annotation. Outside, the next one is drawn.
inline constexpr double edge_reach_px = 5, least_outside_px = 1;

/// The edge of the selected annotation nearest to a time, within reach: whoever draws another one beside one
/// that is not selected does not mean its edge. A narrow annotation keeps a body between its edges,
/// which reach outside for what they lack inside.
inline TierHit edge_near(const AnnotationTier& tier, double time_s, double second_px, int selected) {
  using Part = TierHit::Part;
  TierHit found{Part::Empty, tier.id};
  double nearest_px = edge_reach_px;
  for (std::size_t i = 0; i < tier.annotations.size(); ++i) {
    const Annotation& each = tier.annotations[i];
    const double inner_px = std::min(edge_reach_px, each.duration_s() / second_px / 3);
    const double outer_px = std::max(least_outside_px, edge_reach_px - inner_px);
    const auto reaches = [&](double edge_s, double inwards) {
      const double off_px = (time_s - edge_s) / second_px;
      return std::abs(off_px) <= (off_px * inwards > 0 ? inner_px : outer_px) &&
             std::abs(off_px) <= nearest_px;
    };
    if (each.id == selected && reaches(each.start_s, 1) && found.part != Part::Between) {
      nearest_px = std::abs(time_s - each.start_s) / second_px;
      found = {Part::Start, tier.id, each.id};
    }
    const Annotation* next = i + 1 < tier.annotations.size() ? &tier.annotations[i + 1] : nullptr;
    constexpr double same_s = 1e-6;
    const bool shared = next && next->start_s - each.end_s < same_s;
    const double to_end_px = std::abs(time_s - each.end_s) / second_px;
    const bool on_shared =
        shared && (each.id == selected || next->id == selected) && to_end_px <= nearest_px &&
        (time_s < each.end_s ? to_end_px <= inner_px
                             : to_end_px <= std::min(edge_reach_px, next->duration_s() / second_px / 3));
    if (on_shared) {
      nearest_px = to_end_px;
      found = {Part::Between, tier.id, each.id, next->id};
    } else if (each.id == selected && !shared && reaches(each.end_s, -1)) {
      nearest_px = to_end_px;
      found = {Part::End, tier.id, each.id};
    }
  }
  return found;
}

inline TierHit tier_hit(double x_px, double y_px, const TimelineAxis& axis, const TimelineLanes& lanes,
                        const Annotations& annotations, int selected) {
  using Part = TierHit::Part;
  constexpr double outside_px = 8;
  const int id = lanes.tier_at(y_px);
  const AnnotationTier* tier = annotations.tier(id);
  if (!tier) return {};
  if (x_px < axis.left_px - outside_px) return {Part::Name, id};
  const double time_s = axis.time(x_px);
  const TierHit edge = edge_near(*tier, time_s, axis.seconds_per_pixel(), selected);
  if (edge.is_edge()) return edge;
  if (const Annotation* body = tier->at(time_s)) return {Part::Body, id, body->id};
  for (const Suggestion& suggestion : annotations.suggestions())
    if (suggestion.tier == id && time_s >= suggestion.start_s && time_s < suggestion.end_s)
      return {Part::Suggestion, id, suggestion.id};
  return {Part::Empty, id};
}

}  // namespace abrazo::widgets
