#include <cmath>

#include "widgets/scene/view/scene_view_parts.hpp"

namespace abrazo::widgets {
namespace {

constexpr int moving_ms = 1000;  // pictures closer than this are one movement, however slow the renderer
constexpr int move_interval_ms = 16;

}  // namespace

const OrbitCamera& SceneView::camera() const {
  return m_parts->camera;
}
std::uint64_t SceneView::renderedFrames() const {
  return m_parts->rendered;
}

void SceneView::followPair() {
  constexpr double longest_s = 0.1;  // a slow machine must not make the camera leap
  Parts& p = *m_parts;
  const FrameResult& result = p.frame->result;
  const bool has_pair = result.selected >= 0 || result.status != StepStatus::Failed;  // a trace has no source
  if (!p.framed && has_pair) {
    p.framed = true;
    p.pair_camera.start(p.camera, result.result, p.shape());
  } else if (p.following && p.framed && !p.move && !p.cut_drag) {
    const double by_clock_s =
        p.since_follow.isValid() ? static_cast<double>(p.since_follow.elapsed()) / 1000 : 0;
    const double by_frames_s = std::max(0.0, p.frame->time_s - p.followed_s.value_or(p.frame->time_s));
    const double elapsed_s = p.by_frame_time ? by_frames_s : by_clock_s;
    p.pair_camera.follow(p.camera, result.result, p.shape(), std::min(elapsed_s, longest_s));
  }
  p.since_follow.start();
  p.followed_s = p.frame->time_s;
}

/// Moves there within a fifth of a second. Frames continue to be drawn meanwhile.
void SceneView::moveCamera(const OrbitCamera& to) {
  Parts& p = *m_parts;
  p.views.leave(p.move ? p.move->to : p.camera);
  goTo(to);
}

void SceneView::goTo(const OrbitCamera& to) {
  Parts& p = *m_parts;
  p.move = CameraMove{p.camera, to};
  p.since_move.start();
  if (isVisible()) return p.move_timer.start(move_interval_ms);
  p.move->apply(p.camera, CameraMove::duration_s);
  p.move.reset();
}

void SceneView::frameAll() {
  Parts& p = *m_parts;
  if (!p.frame) return;
  OrbitCamera to = p.camera;
  p.pair_camera.show_all(to, p.frame->result.result, p.shape());
  const auto corners = p.actors.mesh().corners();
  if (p.options.apart > 0 && p.shows(ScenePart::Tetrahedra) && !corners.empty()) {
    const Positions cells =
        Eigen::Map<const Positions>(corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
    to.target = 0.5 * (cells.colwise().minCoeff() + cells.colwise().maxCoeff()).transpose();
    to.distance_m = to.distance_for(cells, p.shape());
    p.pair_camera.zoomed_by_hand();  // the pair alone would draw it near again
  }
  moveCamera(to);
}

double SceneView::roomFor(const PairPose& pair) const {
  const OrbitCamera& camera = m_parts->move ? m_parts->move->to : m_parts->camera;
  return camera.distance_m / camera.distance_for(pair, m_parts->shape());
}

void SceneView::resetView() {
  Parts& p = *m_parts;
  if (!p.frame) return;
  OrbitCamera to;
  to.shift_m = p.camera.shift_m;
  p.pair_camera.start(to, p.frame->result.result, p.shape());
  moveCamera(to);
}

void SceneView::frameSelection() {
  constexpr double nearest_m = 1.2;  // a single joint with its surroundings
  Parts& p = *m_parts;
  const Selection& selected = selection();
  if (!p.shown || !selected.is_of_mesh()) return frameAll();
  Positions points(static_cast<Eigen::Index>(selected.vertices.size()), 3);
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    points.row(v) = p.shown->result.result.row(selected.vertices[static_cast<std::size_t>(v)]);
  OrbitCamera to = p.camera;
  to.target = 0.5 * (points.colwise().minCoeff() + points.colwise().maxCoeff()).transpose();
  to.distance_m = std::max(nearest_m, to.distance_for(points, p.shape()));
  p.pair_camera.zoomed_by_hand();
  moveCamera(to);
}

void SceneView::lookFrom(double azimuth_rad, double elevation_rad) {
  Parts& p = *m_parts;
  p.pair_camera.turned_by_hand();
  OrbitCamera to = p.camera;
  to.azimuth_rad = azimuth_rad;
  to.elevation_rad = elevation_rad;
  moveCamera(to);
}

void SceneView::previousView() {
  Parts& p = *m_parts;
  const OrbitCamera now = p.move ? p.move->to : p.camera;
  if (const auto view = p.views.back(now)) goTo(*view);
}

void SceneView::nextView() {
  Parts& p = *m_parts;
  const OrbitCamera now = p.move ? p.move->to : p.camera;
  if (const auto view = p.views.forth(now)) goTo(*view);
}

void SceneView::setFollowing(bool following) {
  m_parts->following = following;
  if (following) m_parts->framed = false;  // starts again beside the pair
}

void SceneView::render() {
  if (!isVisible()) return;
  Parts& p = *m_parts;
  if (p.move) {
    const double elapsed_s = static_cast<double>(p.since_move.elapsed()) / 1000;
    p.move->apply(p.camera, elapsed_s);
    if (p.move->is_over(elapsed_s)) p.move.reset();
  }
  placeReference();
  placeTags();
  placeCutHandles();
  const bool moving = p.since_render.isValid() && p.since_render.elapsed() < moving_ms;
  const bool smooth = p.budget.wants_smoothing(moving);
  if (!smooth) p.standstill.start();
  p.since_render.start();
  p.stage.render(smooth, [this, smooth, frame = p.frame](double took_ms) {
    ++m_parts->rendered;
    m_parts->budget.took(smooth, took_ms);
    emit pictureDrawn(frame, took_ms);
  });
}

void SceneView::renderSharp() {
  m_parts->since_render.invalidate();
  render();
}

/// Beside the result in the picture, from wherever it is looked at: as far as the pair is wide.
void SceneView::placeReference() {
  constexpr double gap_m = 0.5;
  Parts& p = *m_parts;
  const bool shows = p.options.shows_reference_beside && p.shown;
  Vec3 offset = Vec3::Zero();
  if (shows) {
    const Vec3 across = p.camera.right();
    const auto along = (p.shown->result.result * across).eval();
    p.width_range.show(along.maxCoeff() - along.minCoeff() + gap_m, p.shown->time_s);
    offset = p.width_range.upper() * across;
  }
  const double shift_m = 0.5 * offset.norm();
  if (!p.move && p.camera.shift_m != shift_m) p.camera.shift_m = shift_m;
  if (p.reference_offset == offset) return;
  p.reference_offset = offset;
  p.actors.setReferenceOffset(offset);
  p.picker.setReferenceOffset(offset);
  if (shows) p.actors.showReference(p.shown->result);
}

void SceneView::placeTags() {
  Parts& p = *m_parts;
  std::vector<DepthTags::Tag> tags;
  if (p.shown && p.shows(ScenePart::Contacts)) {
    const PictureProjection projection(p.camera, width(), height());
    for (const ContactLine& contact : contact_lines(p.shown->result))
      if (const auto at = projection.project(contact.middle()); at && tags.size() < DepthTags::most_tags)
        tags.push_back({QPoint(static_cast<int>(at->x), static_cast<int>(at->y)),
                        QString::fromStdString(depth_text(contact.depth_m, contact.allowed_m)),
                        contact.is_excess()});
  }
  p.tags.show(tags);
}

}  // namespace abrazo::widgets
