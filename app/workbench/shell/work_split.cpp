#include "app/workbench/shell/work_split.hpp"

#include <algorithm>

#include "app/workbench/shell/panel_area.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/whole_lanes.hpp"

namespace abrazo::app {
namespace {

/// Source, Moves and Role: with fewer a running session says too little.
constexpr int usual_lanes = 3;

}  // namespace

WorkSplit::WorkSplit(PanelArea* panels, QWidget* timeline, const widgets::TimelineView* lanes,
                     QWidget* parent)
    : QSplitter(Qt::Vertical, parent), m_panels(panels), m_timeline(timeline), m_lanes(lanes) {
  addWidget(panels);
  addWidget(timeline);
  setHandleWidth(1);
  setChildrenCollapsible(false);
  setStretchFactor(0, 1);
  setStretchFactor(1, 0);
  // Queued: the signal comes from within the layout of the panels.
  connect(panels, &PanelArea::neededHeightChanged, this, &WorkSplit::fit, Qt::QueuedConnection);
  // The room for labels goes with their lanes.
  connect(lanes, &widgets::TimelineView::lanesChanged, this, [this] {
    if (!m_labels || !m_lanes->lanes().tiers().empty()) return;
    m_labels = false;
    fit();
  });
  connect(this, &QSplitter::splitterMoved, this, [this] {
    m_chosen = sizes().back();
    m_labels = false;
  });
}

void WorkSplit::choose(std::optional<int> height_px) {
  m_chosen = height_px;
  m_labels = false;
  fit();
}

void WorkSplit::makeRoomForLanes() {
  m_labels = !m_lanes->lanes().tiers().empty();
  fit();
}

void WorkSplit::fit() {
  const int all_lanes = m_timeline->sizeHint().height();
  const int rest = height() - handleWidth() - m_panels->neededHeight();
  int least = std::min(m_timeline->minimumSizeHint().height(), all_lanes);
  // Where the panels lack more than a lane anyway, two lanes would not give them what they need.
  const bool lack_anyway = rest < least - static_cast<int>(widgets::TimelineLanes::tier_px);
  const int room = height() - handleWidth() - m_panels->minimumSizeHint().height();
  if (lack_anyway)
    least = std::max(least, std::min({heightFor(widgets::first_lanes_px(m_lanes->lanes(), usual_lanes)), room,
                                      all_lanes}));
  int below = m_chosen ? *m_chosen : withWholeLanes(std::clamp(rest, least, all_lanes));
  if (m_labels) below = std::max(below, withWholeLanes(std::min(all_lanes, height() / 2)));
  setSizes({std::max(0, height() - handleWidth() - below), below});
}

/// Of the lower part, with this height of the lanes, ruler and overview [px].
int WorkSplit::heightFor(double lanes_px) const {
  return m_timeline->sizeHint().height() - m_lanes->sizeHint().height() + static_cast<int>(lanes_px);
}

int WorkSplit::withWholeLanes(int below) const {
  return heightFor(widgets::whole_lanes_px(m_lanes->lanes(), below - heightFor(0)));
}

void WorkSplit::resizeEvent(QResizeEvent* event) {
  QSplitter::resizeEvent(event);
  fit();
}

}  // namespace abrazo::app
