#include <algorithm>
#include <cmath>

#include "tests/fuzz/fuzz_target.hpp"
#include "widgets/plots/pane_arrangement.hpp"
#include "widgets/timeline/timeline_lanes.hpp"

namespace fuzz = abrazo::fuzz;
namespace widgets = abrazo::widgets;

namespace {

void read_arrangement(std::string_view text) {
  const widgets::PaneArrangement panes = widgets::arrangement_of(text);
  fuzz::expect(!panes.empty() && panes.size() <= widgets::most_panes, "no panes, or too many");
  for (const widgets::PaneSeries& pane : panes) {
    fuzz::expect(!pane.empty(), "an empty pane");
    for (const widgets::Series series : pane) {
      fuzz::expect(widgets::can_join(pane, series), "a pane of two units");
      fuzz::expect(std::ranges::count(pane, series) == 1, "a series twice in a pane");
    }
  }
  fuzz::expect(widgets::arrangement_of(widgets::text_of(panes)) == panes, "panes come back as others");
}

void expect_same_again(const widgets::TimelineLanes& lanes) {
  widgets::TimelineLanes again;
  again.set_text(lanes.text());
  for (int lane = 0; lane < widgets::timeline_lane_count; ++lane)
    fuzz::expect(again.is_shown(static_cast<widgets::TimelineLane>(lane)) ==
                     lanes.is_shown(static_cast<widgets::TimelineLane>(lane)),
                 "a lane comes back hidden, or shown");
  for (const widgets::TierLane& tier : lanes.tiers())
    fuzz::expect(again.is_shown(tier) == lanes.is_shown(tier), "a tier comes back hidden, or shown");
  fuzz::expect(again.text() == lanes.text(), "lanes come back as others");
}

void read_lanes(std::string_view text) {
  widgets::TimelineLanes lanes;
  lanes.set_tiers({{1, "move"}, {2, std::string(text)}, {3, std::string(text.substr(0, text.size() / 2))}});
  lanes.set_tier_shown(std::string(text), false);
  expect_same_again(lanes);
  lanes.set_text(text);
  expect_same_again(lanes);
  fuzz::expect(std::isfinite(lanes.whole_px()) && lanes.scroll_px() <= lanes.most_scroll_px(),
               "lanes without a height");
}

}  // namespace

/// What a session file remembers of the plots and of the timeline's lanes.
ABRAZO_FUZZ_TARGET(view_text)(fuzz::Bytes bytes) {
  const std::string_view text = fuzz::text_of(bytes);
  read_arrangement(text);
  read_lanes(text);
}
