#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "widgets/timeline/timeline_lanes.hpp"

namespace abrazo::widgets {

/// Heights of the shown lanes from the top, computed ones and tiers [px].
inline std::vector<double> lane_heights_px(const TimelineLanes& lanes) {
  std::vector<double> heights;
  for (int i = 0; i < timeline_lane_count; ++i) {
    const auto lane = static_cast<TimelineLane>(i);
    if (lanes.is_shown(lane)) heights.push_back(info_of(lane).height_px);
  }
  for (const TierLane& tier : lanes.tiers())
    if (lanes.is_shown(tier)) heights.push_back(TimelineLanes::tier_px);
  return heights;
}

/// The height at which the first lanes are in view, with ruler and overview [px].
inline double first_lanes_px(const TimelineLanes& lanes, std::size_t count) {
  double height = lanes.top_px() + TimelineLanes::overview_px;
  const std::vector<double> heights = lane_heights_px(lanes);
  for (std::size_t lane = 0; lane < std::min(count, heights.size()); ++lane) height += heights[lane];
  return height;
}

/// The largest height up to this one at which no lane in view is cut [px]; the height itself if not even one
/// lane fits.
inline double whole_lanes_px(const TimelineLanes& lanes, double height_px) {
  const std::size_t all = lane_heights_px(lanes).size();
  std::size_t fit = 0;
  while (fit < all && first_lanes_px(lanes, fit + 1) <= height_px) ++fit;
  return fit > 0 ? first_lanes_px(lanes, fit) : height_px;
}

}  // namespace abrazo::widgets
