#pragma once

#include <cmath>
#include <optional>

#include "core/session/frames/markers.hpp"
#include "core/session/frames/playback.hpp"
#include "widgets/timeline/timeline_axis.hpp"
#include "widgets/timeline/timeline_lanes.hpp"

namespace abrazo::widgets {

/// The item under the pointer. Independent of Qt.
struct TimelineHit {
  enum class Part { Nothing, Names, Time, In, Out, Range, Marker, Overview };
  Part part = Part::Nothing;
  int marker = 0;  ///< its id, of Part::Marker

  bool operator==(const TimelineHit&) const = default;
};

/// @param markers grabbed on the ruler and in their lane
/// @param partial  there is an overview
inline TimelineHit hit(double x_px, double y_px, const TimelineAxis& axis, const TimelineLanes& lanes,
                       const std::optional<Playback::Range>& range, const Markers& markers, bool partial) {
  using Part = TimelineHit::Part;
  constexpr double reach_px = 5, outside_px = 8;
  if (x_px < axis.left_px - outside_px) return {Part::Names};
  if (y_px >= lanes.bottom_px()) return {partial ? Part::Overview : Part::Nothing};
  const bool on_ruler = y_px < lanes.top_px();
  TimelineLane lane{};
  const bool on_markers = lanes.lane_at(y_px, lane) && lane == TimelineLane::Markers;
  if (on_ruler || on_markers) {
    // The flag of a marker is to the right of its time.
    const double flag_px = on_markers ? 12 : reach_px;
    const double middle_s = axis.time(x_px - (flag_px - reach_px) / 2);
    const double reach_s = (flag_px + reach_px) / 2 * axis.seconds_per_pixel();
    if (const Marker* marker = markers.near(middle_s, reach_s)) return {Part::Marker, marker->id};
  }
  if (on_ruler && range) {
    const double to_in = std::abs(x_px - axis.x(range->from_s)),
                 to_out = std::abs(x_px - axis.x(range->to_s));
    if (to_in <= reach_px && to_in <= to_out) return {Part::In};
    if (to_out <= reach_px) return {Part::Out};
    if (x_px > axis.x(range->from_s) && x_px < axis.x(range->to_s)) return {Part::Range};
  }
  return {Part::Time};
}

}  // namespace abrazo::widgets
