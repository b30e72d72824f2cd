#pragma once

#include "widgets/timeline/timeline_lanes.hpp"

namespace abrazo::widgets {

/// The largest height up to this one at which no lane in view is cut [px]; the height itself if not even one
/// lane fits.
inline double whole_lanes_px(const TimelineLanes& lanes, double height_px) {
  const double least = lanes.top_px() + TimelineLanes::overview_px;
  double whole = least;
  const auto add = [&](double lane_px) {
    const bool fits = whole + lane_px <= height_px;
    if (fits) whole += lane_px;
    return fits;
  };
  for (int i = 0; i < timeline_lane_count; ++i) {
    const auto lane = static_cast<TimelineLane>(i);
    if (lanes.is_shown(lane) && !add(info_of(lane).height_px)) return whole > least ? whole : height_px;
  }
  for (const TierLane& tier : lanes.tiers())
    if (lanes.is_shown(tier) && !add(TimelineLanes::tier_px)) break;
  return whole > least ? whole : height_px;
}

}  // namespace abrazo::widgets
