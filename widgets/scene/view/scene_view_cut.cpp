#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "widgets/scene/view/scene_view_parts.hpp"

namespace abrazo::widgets {
namespace {

constexpr double farthest_cut_m = 1, steepest_cut_rad = 1.5707963267948966;
constexpr int one_edit_ms = 600;  // manual changes closer than this are taken back together

}  // namespace

void SceneView::Parts::applyCut() {
  camera.cuts = options.cuts && !options.cut_in_world;
  camera.cut_m = options.cut_m;
  camera.plane = options.cuts && options.cut_in_world ? std::optional(options.plane()) : std::nullopt;
  actors.showCut(camera.plane);
}

std::optional<CutHandles> SceneView::Parts::cutHandles() const {
  if (!camera.plane || !shown) return std::nullopt;
  return CutHandles(*camera.plane, camera, surface->width(), surface->height());
}

void SceneView::wireCut() {
  GlSurface& surface = *m_parts->surface;
  surface.taken = [this](QPointF place) { return takeCut(place); };
  surface.pulled = [this](QPointF place) { pullCut(place); };
  surface.letGo = [this] { letGoOfCut(); };
}

bool SceneView::takeCut(QPointF place) {
  Parts& p = *m_parts;
  const auto handles = p.cutHandles();
  const CutGrip grip = handles ? handles->at(place.x(), place.y()) : CutGrip::None;
  if (grip == CutGrip::None) return false;
  const QPointF knob =
      handles->knob && grip == CutGrip::Turn ? QPointF(handles->knob->x, handles->knob->y) : place;
  p.cut_drag = CutDrag{grip, p.options, place, knob - place};
  placeCutHandles();
  return true;
}

void SceneView::pullCut(QPointF place) {
  Parts& p = *m_parts;
  if (!p.cut_drag) return;
  const CutDrag& drag = *p.cut_drag;
  SceneOptions options = p.options;
  options.take_cut_of(drag.before);
  if (drag.grip == CutGrip::Move) {
    const CutHandles begun(drag.before.plane(), p.camera, p.surface->width(), p.surface->height());
    const double by_m = begun.moved_m(drag.from.x(), drag.from.y(), place.x(), place.y());
    options.cut_m = std::clamp(options.cut_m + by_m, -farthest_cut_m, farthest_cut_m);
  } else if (const auto handles = p.cutHandles()) {
    const QPointF knob = place + drag.offset;
    options.turn_cut_to(handles->turned(knob.x(), knob.y()));
  }
  setOptions(options);
}

/// The whole drag is one edit.
void SceneView::letGoOfCut() {
  Parts& p = *m_parts;
  if (!p.cut_drag) return;
  const SceneOptions before = p.cut_drag->before;
  p.cut_drag.reset();
  p.since_cut.invalidate();
  placeCutHandles();
  if (!p.options.has_cut_of(before)) emit cutEdited(before, p.options, ++p.cut_edit);
}

/// @return whether there was something to leave
bool SceneView::leaveCutDrag() {
  Parts& p = *m_parts;
  if (!p.cut_drag) return false;
  const SceneOptions before = p.cut_drag->before;
  p.cut_drag.reset();
  restoreCut(before);
  placeCutHandles();
  return true;
}

void SceneView::restoreCut(const SceneOptions& cut) {
  SceneOptions options = m_parts->options;
  options.take_cut_of(cut);
  applyOptions(options);
}

void SceneView::placeCutHandles() {
  Parts& p = *m_parts;
  const auto handles = p.cutHandles();
  p.cut_layer->show(handles, p.cut_drag ? p.cut_drag->grip : handles ? p.cut_hovered : CutGrip::None);
}

/// @return whether the pointer is over a handle
bool SceneView::pointAtCut(QPointF place) {
  Parts& p = *m_parts;
  const auto handles = p.cutHandles();
  const CutGrip grip = handles ? handles->at(place.x(), place.y()) : CutGrip::None;
  if (grip == p.cut_hovered) return grip != CutGrip::None;
  p.cut_hovered = grip;
  p.surface->setCursor(grip == CutGrip::None   ? Qt::ArrowCursor
                       : grip == CutGrip::Turn ? Qt::OpenHandCursor
                                               : Qt::SizeAllCursor);
  placeCutHandles();
  return grip != CutGrip::None;
}

void SceneView::edit(const SceneOptions& wanted) {
  Parts& p = *m_parts;
  const SceneOptions before = p.options;
  setOptions(wanted);
  if (p.options.has_cut_of(before)) return;
  if (!p.since_cut.isValid() || p.since_cut.elapsed() > one_edit_ms) ++p.cut_edit;
  p.since_cut.start();
  emit cutEdited(before, p.options, p.cut_edit);
}

void SceneView::moveCut(double by_m, double turn_rad, double tilt_rad) {
  SceneOptions options = m_parts->options;
  if (!options.cuts) return;
  options.cut_m = std::clamp(options.cut_m + by_m, -farthest_cut_m, farthest_cut_m);
  if (options.cut_in_world) {
    options.cut_azimuth_rad = std::remainder(options.cut_azimuth_rad + turn_rad, 4 * steepest_cut_rad);
    options.cut_elevation_rad =
        std::clamp(options.cut_elevation_rad + tilt_rad, -steepest_cut_rad, steepest_cut_rad);
  }
  edit(options);
}

}  // namespace abrazo::widgets
