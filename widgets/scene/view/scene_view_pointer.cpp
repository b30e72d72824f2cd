#include <QKeyEvent>
#include <cmath>

#include "widgets/common/selection_model.hpp"
#include "widgets/scene/pick/pick_facts.hpp"
#include "widgets/scene/view/scene_view_parts.hpp"

namespace abrazo::widgets {
namespace {

constexpr double pixels_per_notch = 40;  // of a drag that zooms
constexpr int one_gesture_ms = 600;      // manual moves closer than this count as one in the view history
constexpr double cut_notch_m = 0.05, cut_radians_per_pixel = 0.0075;
constexpr double trail_notch = 1.25;

}  // namespace

void SceneView::wirePointer() {
  GlSurface& surface = *m_parts->surface;
  surface.dragged = [this](QPointF delta, PointerMove move) { dragged(delta, move); };
  surface.wheeled = [this](double notches) { wheeled(notches); };
  surface.hovered = [this](QPointF place) {
    Parts& p = *m_parts;
    if (!p.shown) return;
    if (pointAtCut(place)) place = {-1e6, -1e6};
    if (p.picker.pointAt(place, *p.shown)) render();
    const Selection& at = p.picker.hovered();
    const auto row = at.kind == SelectionKind::Candidate ? candidate_of(*p.shown, at.pair) : std::nullopt;
    const int candidate = row ? static_cast<int>(*row) : -1;
    if (candidate != p.told_candidate) emit candidateHovered(p.told_candidate = candidate);
  };
  surface.clicked = [this](QPointF place) {
    if (!m_parts->shown) return;
    const Selection item = m_parts->picker.itemAt(place, *m_parts->shown);
    emit selectionRequested(changed(selection(), item, selection_change(m_parts->surface->keys)));
  };
}

/// Before the hand moves the camera: the view it leaves can be gone back to.
void SceneView::handMoves() {
  Parts& p = *m_parts;
  if (!p.since_hand.isValid() || p.since_hand.elapsed() > one_gesture_ms) p.views.leave(p.camera);
  p.since_hand.start();
  p.move.reset();
}

void SceneView::dragged(QPointF delta, PointerMove move) {
  Parts& p = *m_parts;
  const Qt::KeyboardModifiers keys = p.surface->keys;
  if (p.options.cuts && p.options.cut_in_world && keys == (Qt::ControlModifier | Qt::AltModifier))
    return moveCut(0, cut_radians_per_pixel * delta.x(), -cut_radians_per_pixel * delta.y());
  handMoves();
  if (move == PointerMove::Turn) {
    p.pair_camera.turned_by_hand();
    p.camera.orbit(delta.x(), delta.y());
  }
  if (move == PointerMove::Shift) p.camera.pan(delta.x(), delta.y(), p.surface->height());
  if (move == PointerMove::Zoom) zoom(-delta.y() / pixels_per_notch);
  render();
}

void SceneView::wheeled(double notches) {
  Parts& p = *m_parts;
  const Qt::KeyboardModifiers keys = p.surface->keys;
  if (p.options.cuts && keys == Qt::ControlModifier) return moveCut(cut_notch_m * notches, 0, 0);
  if (p.shows(ScenePart::Trails) && keys == Qt::ShiftModifier) {
    SceneOptions options = p.options;
    options.trail_s =
        std::clamp(options.trail_s * std::pow(trail_notch, notches), shortest_trail_s, longest_trail_s);
    return setOptions(options);
  }
  handMoves();
  zoom(notches);
  render();
}

void SceneView::zoom(double notches) {
  m_parts->pair_camera.zoomed_by_hand();
  m_parts->camera.zoom(notches);
}

void SceneView::showSelection(const Selection& selection) {
  Parts& p = *m_parts;
  if (!p.picker.select(selection)) return;
  std::vector<int> trailing(hands.begin(), hands.end());
  if (selection.kind == SelectionKind::Joints)
    trailing.assign(selection.vertices.begin(), selection.vertices.end());
  p.actors.setTrailJoints(trailing);
  refresh();
}

void SceneView::hideSelection() {
  const Selection selected = selection();
  if (!selected.is_of_mesh()) return;
  m_parts->hidden.push_back(selected);
  emit selectionRequested({});
  refresh();
}

void SceneView::showHidden() {
  m_parts->hidden.clear();
  SceneOptions options = m_parts->options;
  options.isolates = false;
  setOptions(options);
  refresh();
}

void SceneView::showCandidate(int candidate) {
  if (candidate == m_parts->candidate) return;
  m_parts->candidate = candidate;
  showGhost();
  render();
}

void SceneView::showRecorded(const std::optional<PairPose>& pair) {
  if (!pair && !m_parts->recorded) return;
  m_parts->recorded = pair;
  showGhost();
  render();
}

/// The candidate that is pointed at elsewhere, else what the library plays, else the one that is selected.
void SceneView::showGhost() {
  Parts& p = *m_parts;
  std::vector<Ghost> ghosts;
  p.actors.showCandidate(p.recorded);
  if (p.shown && p.library) {
    const FrameResult& result = p.shown->result;
    const auto pair_at = [&result](int candidate) {
      return candidate >= 0 && candidate < static_cast<int>(result.candidates.size())
                 ? result.candidates[static_cast<std::size_t>(candidate)].pair
                 : -1;
    };
    if (p.shows(ScenePart::SelectedPair) && pair_at(result.selected) >= 0)
      ghosts.push_back({pair_at(result.selected), result.selected_pair});
    int pair = pair_at(p.candidate);
    if (pair < 0 && !p.recorded && selection().kind == SelectionKind::Candidate) pair = selection().pair;
    if (pair >= 0 && pair < p.library->pair_count()) {
      const bool passive = p.shown->settings.user_role == UserRole::Passive;
      ghosts.push_back({pair, p.library->pair_in_world(pair, result.query_root, passive)});
      p.actors.showCandidate(ghosts.back().pose);
    }
  }
  p.picker.setGhosts(std::move(ghosts));
}

/// What the trails lack before the shown frame, from the recorded frames.
void SceneView::showPast(const FrameHistory& history) {
  Parts& p = *m_parts;
  JointTrails& trails = p.actors.trails();
  if (!p.frame || !p.shows(ScenePart::Trails)) return;
  const double from_s = p.frame->time_s - trails.length_s();
  if (p.frame->index == p.past_of && trails.length_s() == p.past_length_s) return;  // all there is
  if (trails.size() > 0 &&
      trails.known_since_s() <= std::max(from_s, history.span().first_s) + JointTrails::leap_s / 4)
    return;
  p.past_of = p.frame->index;
  p.past_length_s = trails.length_s();
  trails.clear();
  for (const FrameSnapshotPtr& frame : history.range(from_s, p.frame->time_s))
    trails.add(frame->time_s, frame->result.result);
  p.actors.showTrails();
  render();
}

/// Home is the view's own while it has the keyboard, also where the window has another meaning for it; so is
/// Escape while the cutting plane is dragged.
bool SceneView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool leaves = key->key() == Qt::Key_Escape && m_parts->cut_drag;
    if (leaves || (key->key() == Qt::Key_Home && key->modifiers() == Qt::NoModifier)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Home && event->modifiers() == Qt::NoModifier) return frameAll();
  if (event->key() == Qt::Key_Escape && leaveCutDrag()) return;
  QWidget::keyPressEvent(event);
}

void SceneView::placeCards() {
  constexpr int gap = 6, margin = 12;
  Parts& p = *m_parts;
  const ScalarLegend* lowest = p.cell_legend->isHidden() ? p.legend : p.cell_legend;
  const int bottom = p.facts->y(), left_bottom = p.morph->isHidden() ? bottom : p.morph->y();
  const int below_legend = std::max(lowest->geometry().bottom(), p.chips->geometry().bottom()) + gap;
  const int below_chips = p.chips->geometry().bottom() + gap;
  const auto from_to = [](int x, int y, int right, int end) {
    return QRect(x, y, right - x, std::max(0, end - y));
  };
  std::vector<QRect> legends;
  for (const ScalarLegend* each : {p.legend, p.cell_legend})
    if (!each->isHidden()) legends.push_back(each->geometry());
  p.picker.arrange(bottom, from_to(margin, below_legend, width() - margin, bottom),
                   from_to(margin, below_chips, p.legend->x() - gap, left_bottom), legends);
}

}  // namespace abrazo::widgets
