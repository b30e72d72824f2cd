#include "widgets/timeline/timeline_view.hpp"

#include <QHelpEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/session/frames/frame_in_library.hpp"
#include "widgets/timeline/timeline_accessible.hpp"
#include "widgets/timeline/timeline_painter.hpp"

namespace abrazo::widgets {
namespace {

constexpr int names_width = 104;
constexpr int right_margin = 16;
constexpr std::size_t newest_kept = 40'000;  // five minutes and a half at 120 Hz
constexpr std::size_t older_kept = 40'000;

/// The frame may be from another library; only its shown values are converted.
/// @param dt_s  since the previous step, for the weight of its rate
TrackRow row_of(const FrameSnapshot& frame, const std::shared_ptr<const MotionLibrary>& library,
                double dt_s) {
  const FrameResult& result = frame.result;
  const int pair = selected_pair(frame, library);
  TrackRow row;
  row.time_s = frame.time_s;
  row.user_is_active = frame.settings.user_role == UserRole::Active;
  row.leader = leader_of(row.user_is_active, pair, library.get());
  if (!library || pair < 0 || pair >= library->pair_count()) return row;
  const Candidate& chosen = result.candidates[static_cast<std::size_t>(result.selected)];
  row.pair = pair;
  row.take = static_cast<int>(library->source(pair).take);
  row.label = library->label(pair);
  row.source_changed = result.source_changed;
  row.cost = deciding_cost(chosen);
  row.is_by_intent = chosen.intent.has_value();
  const double velocity = dt_s > 0 ? velocity_weight_at(frame.settings, dt_s) * result.energy.velocity : 0;
  row.energy = result.energy.deformation + velocity + result.energy.constraint;
  return row;
}

}  // namespace

TimelineView::TimelineView(QWidget* parent) : QWidget(parent), m_scroll(new QScrollBar(Qt::Vertical, this)) {
  m_content.palette = palette_of(Theme::Dark);
  setAccessibleName("Timeline");
  setAccessibleDescription("Arrow keys step frames, + and - zoom, Page Up and Page Down move the view");
  install_timeline_accessibility();
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  m_scroll->setAccessibleName("Lanes of the timeline");
  m_scroll->setFocusPolicy(Qt::NoFocus);
  m_scroll->hide();
  connect(m_scroll, &QScrollBar::valueChanged, this, [this](int px) {
    m_content.lanes.scroll_to(px);
    redraw();
  });
}

QSize TimelineView::sizeHint() const {
  return {800, static_cast<int>(m_content.lanes.whole_px())};
}

QSize TimelineView::minimumSizeHint() const {
  constexpr double least_lanes_px = 54;
  return {300, static_cast<int>(TimelineLanes::ruler_px + TimelineLanes::gap_px + TimelineLanes::overview_px +
                                least_lanes_px)};
}

void TimelineView::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  const TimelineLanes lanes = m_content.lanes;
  const Palette palette = m_content.palette;
  m_content = {};
  m_content.palette = palette;
  m_content.lanes = lanes;
  m_content.library = std::move(library);
  m_nextIndex = 0;
  m_gaps = {};
  m_drag = Drag::None;
  arrange();  // the new viewport has no place yet
}

/// From the pairs that are kept: to read the frames again takes a long session many turns.
void TimelineView::extendLibrary(std::shared_ptr<const MotionLibrary> library) {
  const auto before = std::exchange(m_content.library, std::move(library));
  const MotionLibrary& now = *m_content.library;
  PairNumbers numbers(*before, now);
  m_content.tracks.renumber(numbers.takes(), [&](int pair, bool user_is_active) {
    const int same = numbers(pair);
    return PairFacts{same, same < 0 ? std::string_view() : now.label(same),
                     leader_of(user_is_active, same, &now)};
  });
  redraw();
}

void TimelineView::setColours(const Palette& palette) {
  m_content.palette = palette;
  redraw();
}

void TimelineView::setLanes(const TimelineLanes& lanes) {
  if (lanes.text() == m_content.lanes.text()) return;
  m_content.lanes.set_text(lanes.text());
  arrangeScroll();
  updateGeometry();
  redraw();
  emit lanesChanged();
}

void TimelineView::showOtherFrames() {
  TimelineContent before = std::move(m_content);
  m_content = {};
  m_content.palette = before.palette;
  m_content.library = std::move(before.library);
  m_content.lanes = std::move(before.lanes);
  m_content.tiers = std::move(before.tiers);
  m_content.markers = std::move(before.markers);
  m_content.selected_marker = before.selected_marker;
  m_content.takes = std::move(before.takes);
  m_content.lost = std::move(before.lost);
  m_nextIndex = 0;
  m_gaps = {};
  m_settingsMarksScale = 0;
  m_drag = Drag::None;
  arrange();
}

void TimelineView::showMarkers(const Markers& markers) {
  m_content.markers = markers;
  if (!markers.find(m_content.selected_marker)) m_content.selected_marker = 0;
  redraw();
}

void TimelineView::selectMarker(int id) {
  m_content.selected_marker = m_content.markers.find(id) ? id : 0;
  redraw();
}

void TimelineView::showTakes(std::vector<TimelineTake> takes) {
  if (takes == m_content.takes) return;
  const auto is_recorded = [](const TimelineTake& take) { return take.is_running; };
  const bool begins =
      std::ranges::any_of(takes, is_recorded) && std::ranges::none_of(m_content.takes, is_recorded);
  m_content.takes = std::move(takes);
  if (begins) {
    m_content.lanes.reveal(TimelineLane::Takes);
    arrangeScroll();
  }
  redraw();
}

void TimelineView::showLost(const QString& why) {
  if (why == m_content.lost) return;
  m_content.lost = why;
  redraw();
}

void TimelineView::redraw() {
  m_layerIsOld = true;
  update();
}

void TimelineView::refresh(const FrameHistory& history, const Playback& playback) {
  const double shown_until = axis().last_s(), known_until = m_content.playback.last_s;
  const FrameHistory::Span span = history.span();
  if (span.memory_first_s != m_content.memory_first_s) m_layerIsOld = true;
  m_content.memory_first_s = span.memory_first_s;
  const std::vector<FrameSnapshotPtr> frames = history.next_since(m_nextIndex);
  const std::uint64_t frames_each = frames.empty() ? 1 : history.frames_each();
  for (const FrameSnapshotPtr& frame : frames) take(*frame, frames_each);
  if (!frames.empty() && frames.back()->time_s < span.last_s) emit unfinished();
  m_content.tracks.drop_before(playback.first_s);
  m_content.tracks.thin_older(newest_kept, older_kept);
  m_content.settings.evict_before(playback.first_s);
  place(playback);
  if (known_until <= shown_until) redraw();  // new frames are in view
  update();
}

void TimelineView::take(const FrameSnapshot& frame, std::uint64_t frames_each) {
  const FrameInterval interval = m_gaps.next(frame, frames_each);
  m_nextIndex = frame.index + 1;
  const std::size_t changes = m_content.settings.changes().size();
  m_content.settings.append(frame);
  if (m_content.settings.changes().size() != changes) m_settingsMarksScale = 0;
  const bool has_elapsed = interval.is_adjacent && frame.elapsed_s > 0;
  TrackRow row = row_of(frame, m_content.library, has_elapsed ? frame.elapsed_s : interval.since_s);
  row.left_out_s = interval.left_out_s;
  m_content.tracks.append(row);
}

void TimelineView::append(std::span<const TrackRow> rows) {
  for (const TrackRow& row : rows) m_content.tracks.append(row);
  redraw();
}

void TimelineView::showPlayback(const Playback& playback) {
  const Playback& known = m_content.playback;
  const bool still = playback.state == known.state && playback.cursor_s == known.cursor_s &&
                     playback.range() == known.range() && playback.loop == known.loop;
  // The live end moves the whole view; that is for refresh(), which has its frames.
  if (still || playback.state == Playback::State::Following) return;
  place(playback);
  update();
}

void TimelineView::place(const Playback& playback) {
  const TimelineAxis before = axis();
  const Playback known = m_content.playback;
  m_content.playback = playback;
  m_content.viewport.show(playback, m_drag == Drag::Cursor);
  if (before.first_s != axis().first_s || before.span_s != axis().span_s ||
      known.range() != playback.range() || known.loop != playback.loop || known.first_s != playback.first_s)
    m_layerIsOld = true;
}

void TimelineView::zoom(double factor) {
  m_content.viewport.zoom(factor, m_content.playback.cursor_s);
  redraw();
}

void TimelineView::showAll() {
  m_content.viewport.show_all();
  redraw();
}

void TimelineView::showRange() {
  const auto range = m_content.playback.range();
  if (!range) return showAll();
  m_content.viewport.show_range(range->from_s, range->to_s);
  redraw();
}

void TimelineView::paintEvent(QPaintEvent*) {
  const double scale = devicePixelRatioF();
  if (m_layer.size() != size() * scale) {
    m_layer = QPixmap(size() * scale);
    m_layer.setDevicePixelRatio(scale);
    m_layerIsOld = true;
  }
  if (m_layerIsOld) {
    if (m_settingsMarksScale != axis().seconds_per_pixel()) {
      constexpr double apart_px = 5, dragged_s = 0.3;
      m_settingsMarksScale = axis().seconds_per_pixel();
      m_content.settings_marks =
          m_content.settings.merged(std::max(dragged_s, apart_px * m_settingsMarksScale));
    }
    QPainter layer(&m_layer);
    paint_timeline(layer, m_content, size());
    m_layerIsOld = false;
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, m_layer);
  paint_running_labels(painter, m_content);
  paint_timeline_overview(painter, m_content, size());
  paint_timeline_cursor(painter, m_content, size());
}

void TimelineView::resizeEvent(QResizeEvent*) {
  arrange();
}

void TimelineView::arrange() {
  const double left = names_width + 16;
  m_content.lanes.set_height(height());
  m_content.viewport.set_place(left, std::max(50.0, width() - left - right_margin));
  arrangeScroll();
  redraw();
}

void TimelineView::arrangeScroll() {
  m_content.lanes.set_height(height());
  const int most = static_cast<int>(std::ceil(m_content.lanes.most_scroll_px()));
  const int page = static_cast<int>(m_content.lanes.bottom_px() - m_content.lanes.top_px());
  const QSignalBlocker quiet(m_scroll);
  m_scroll->setRange(0, most);
  m_scroll->setPageStep(page);
  m_scroll->setSingleStep(20);
  m_scroll->setValue(static_cast<int>(m_content.lanes.asked_scroll_px()));
  m_scroll->setGeometry(width() - 9, static_cast<int>(m_content.lanes.top_px()), 8, std::max(page, 0));
  m_scroll->setVisible(most > 0);
}

void TimelineView::focusInEvent(QFocusEvent* event) {
  m_content.focused = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason ||
                      event->reason() == Qt::ShortcutFocusReason;
  redraw();
}

void TimelineView::focusOutEvent(QFocusEvent*) {
  m_content.focused = false;
  redraw();
}

bool TimelineView::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString facts = facts_at(m_content, help->pos());
  facts.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), facts, this);
  return true;
}

}  // namespace abrazo::widgets
