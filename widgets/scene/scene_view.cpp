#include "widgets/scene/scene_view.hpp"

#include <QElapsedTimer>
#include <QEvent>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/motion/joint_set.hpp"
#include "widgets/common/value_range.hpp"
#include "widgets/scene/gl_surface.hpp"
#include "widgets/scene/pair_camera.hpp"
#include "widgets/scene/scene_overlay.hpp"
#include "widgets/scene/scene_picker.hpp"
#include "widgets/scene/scene_stage.hpp"
#include "widgets/scene/smoothing_budget.hpp"

namespace abrazo::widgets {
namespace {

constexpr double pixels_per_notch = 40;  // of a drag that zooms
constexpr int standstill_ms = 130;       // without a new picture: time for smooth edges
constexpr int moving_ms = 1000;  // pictures closer than this are one movement, however slow the renderer

/// Of both bodies: their trails are drawn while no joint is selected.
const std::vector<int> hands = {joints::left_hand, joints::right_hand, joint_count + joints::left_hand,
                                joint_count + joints::right_hand};

QString seconds(double time_s) {
  return QString::number(time_s, 'f', 3) + " s";
}

}  // namespace

struct SceneView::Parts {
  explicit Parts(SceneView* view) : surface(new GlSurface(view)), stage(*surface), picker(view, stage) {}

  GlSurface* surface;
  SceneStage stage;
  ScenePicker picker;
  SceneActors& actors = stage.actors;
  OrbitCamera& camera = stage.camera;
  PairCamera pair_camera;
  ScalarChips* chips = nullptr;
  ScalarLegend *legend = nullptr, *cell_legend = nullptr;
  FrameFacts* facts = nullptr;
  Palette palette = palette_of(Theme::Dark);
  PartVisibility visibility = default_visibility;
  PartCounts counts{};
  SceneOptions options;
  int filter_joint = -1;  ///< the joint that was selected last
  MeshScalar scalar = MeshScalar::Residual;
  std::array<SteadyRange, mesh_scalar_count> ranges;
  SteadyRange cell_range;
  FrameSnapshotPtr frame;
  std::shared_ptr<const MotionLibrary> library;
  int candidate = -1;
  bool following = true;
  bool framed = false;
  std::uint64_t rendered = 0;
  SmoothingBudget budget;
  bool smoothed = true;
  bool on_the_way = false;  ///< rendered and not yet on the screen
  QElapsedTimer since_render, since_follow;
  QTimer standstill;  ///< runs out when no picture followed one with rough edges

  MeshLook look();
  SteadyRange& range() { return ranges[static_cast<std::size_t>(scalar)]; }
  bool shows(ScenePart part) const { return visibility[static_cast<std::size_t>(part)]; }
  PictureShape shape() const {
    constexpr double overlays_px = 100;  // the chips above and the facts below
    const double height = std::max(1, surface->height());
    return {surface->width() / height, std::clamp(1 - overlays_px / height, 0.58, 0.84)};
  }
};

/// Colours of the mesh for the frame, and the legends that explain them.
MeshLook SceneView::Parts::look() {
  const FrameResult& result = frame->result;
  MeshLook look;
  look.scalars = edge_scalars(*frame, scalar);
  look.is_signed = scalar_info(scalar).is_signed;
  range().show(typical_upper(result.edges, look.scalars), frame->time_s);
  look.upper = range().upper();
  legend->show(scalar_legend(scalar, look.upper));
  if (shows(ScenePart::Tetrahedra)) {
    cell_range.show(typical_doublings(cell_volumes(result)), frame->time_s);
    look.doublings = cell_range.upper();
    cell_legend->show(volume_legend(look.doublings));
  }
  look.filter = {options.shortest_m, options.longest_m, options.picked_joint_only ? filter_joint : -1};
  look.apart = options.apart;
  return look;
}

void SceneView::prepareApplication() {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
}

SceneView::SceneView(QWidget* parent) : QWidget(parent), m_parts(std::make_unique<Parts>(this)) {
  Parts& p = *m_parts;
  setMinimumSize(320, 220);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  p.surface->setFocusPolicy(Qt::ClickFocus);
  p.surface->lower();
  box->addWidget(p.surface);

  p.chips = new ScalarChips(this);
  p.legend = new ScalarLegend(this);
  p.cell_legend = new ScalarLegend(this);
  p.cell_legend->setVisible(false);
  p.facts = new FrameFacts(this);
  wireOverlay();
  wirePointer();
  connect(p.surface, &QOpenGLWidget::frameSwapped, this, [this] {
    if (!m_parts->on_the_way) return;  // the window was put together anew without a new picture of the scene
    m_parts->on_the_way = false;
    ++m_parts->rendered;
    m_parts->budget.took(m_parts->smoothed, static_cast<double>(m_parts->since_render.nsecsElapsed()) * 1e-6);
  });
  p.standstill.setSingleShot(true);
  p.standstill.setInterval(standstill_ms);
  connect(&p.standstill, &QTimer::timeout, this, &SceneView::renderSharp);
  setColours(palette_of(Theme::Dark));
  p.actors.setVisibility(p.visibility);
  p.actors.setTrailJoints(hands);
}

void SceneView::wireOverlay() {
  Parts& p = *m_parts;
  connect(p.chips, &ScalarChips::scalarChosen, this, &SceneView::setScalar);
  connect(p.chips, &ScalarChips::betweenOnlyChosen, this,
          [this](bool only) { showPart(ScenePart::MeshWithin, !only); });
  connect(p.chips, &ScalarChips::cellsChosen, this,
          [this](bool shown) { showPart(ScenePart::Tetrahedra, shown); });
  connect(p.chips, &ScalarChips::optionsRequested, this, &SceneView::setOptions);
  connect(p.legend, &ScalarLegend::lockToggled, this,
          [this](bool locked) { m_parts->range().set_locked(locked); });
  connect(p.cell_legend, &ScalarLegend::lockToggled, this,
          [this](bool locked) { m_parts->cell_range.set_locked(locked); });
}

void SceneView::wirePointer() {
  GlSurface& surface = *m_parts->surface;
  surface.dragged = [this](QPointF delta, PointerMove move) {
    Parts& p = *m_parts;
    if (move == PointerMove::Turn) p.pair_camera.turned_by_hand();
    if (move == PointerMove::Turn) p.camera.orbit(delta.x(), delta.y());
    if (move == PointerMove::Shift) p.camera.pan(delta.x(), delta.y(), p.surface->height());
    if (move == PointerMove::Zoom) zoom(-delta.y() / pixels_per_notch);
    render();
  };
  surface.wheeled = [this](double notches) {
    zoom(notches);
    render();
  };
  surface.hovered = [this](QPointF place) {
    if (m_parts->frame && m_parts->picker.pointAt(place, *m_parts->frame)) render();
  };
  surface.clicked = [this](QPointF place) {
    if (m_parts->frame) select(m_parts->picker.itemAt(place, *m_parts->frame));
  };
}

void SceneView::zoom(double notches) {
  m_parts->pair_camera.zoomed_by_hand();
  m_parts->camera.zoom(notches);
}

SceneView::~SceneView() = default;

const PartVisibility& SceneView::visibility() const {
  return m_parts->visibility;
}
MeshScalar SceneView::scalar() const {
  return m_parts->scalar;
}
const OrbitCamera& SceneView::camera() const {
  return m_parts->camera;
}
std::uint64_t SceneView::renderedFrames() const {
  return m_parts->rendered;
}

void SceneView::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  m_parts->library = std::move(library);
  m_parts->framed = false;
  for (SteadyRange& range : m_parts->ranges) range.reset();
  m_parts->cell_range.reset();
  if (!m_parts->library || m_parts->library->bodies().empty()) return;
  m_parts->actors.setRadii(m_parts->library->usual_active_body().capsule_radii,
                           m_parts->library->usual_passive_body().capsule_radii);
}

void SceneView::setColours(const Palette& palette) {
  Parts& p = *m_parts;
  p.palette = palette;
  p.stage.setColours(palette, devicePixelRatioF());
  p.picker.setColours(palette);
  p.legend->setColours(palette);
  p.cell_legend->setColours(palette);
  p.facts->setColours(palette);
  refresh();
}

void SceneView::showFrame(FrameSnapshotPtr frame) {
  if (!frame || frame == m_parts->frame) return;
  m_parts->frame = std::move(frame);
  followPair();
  refresh();
}

/// Moves what changed and renders.
void SceneView::refresh() {
  Parts& p = *m_parts;
  if (p.frame) {
    p.actors.show(*p.frame, p.look());
    showCandidate(p.candidate);
    p.picker.show(*p.frame);
    updateFacts();
    if (p.actors.counts() != p.counts) emit countsChanged(p.counts = p.actors.counts());
  }
  render();
}

void SceneView::followPair() {
  constexpr double longest_s = 0.1;  // a slow machine must not make the camera leap
  Parts& p = *m_parts;
  const FrameResult& result = p.frame->result;
  if (!p.framed && result.selected >= 0) {
    p.framed = true;
    p.pair_camera.start(p.camera, result.result, p.shape());
  } else if (p.following && p.framed) {
    const double elapsed_s =
        p.since_follow.isValid() ? static_cast<double>(p.since_follow.elapsed()) / 1000 : 0;
    p.pair_camera.follow(p.camera, result.result, p.shape(), std::min(elapsed_s, longest_s));
  }
  p.since_follow.start();
}

void SceneView::updateFacts() {
  const FrameSnapshot& frame = *m_parts->frame;
  const FrameResult& result = frame.result;
  QString first = QString("frame %1 · %2 · morph step %3 / %3 + %4")
                      .arg(frame.index)
                      .arg(seconds(frame.time_s))
                      .arg(frame.settings.morph_steps)
                      .arg(frame.settings.projection_steps);
  if (m_parts->options.shortest_m > 0 || m_parts->options.longest_m < MeshFilter::no_limit ||
      m_parts->options.picked_joint_only)
    first += QString(" · filter: %1 of %2 edges")
                 .arg(m_parts->actors.mesh().shownEdges().size())
                 .arg(result.edges.size());
  QString second = "no source";
  if (m_parts->library && result.selected >= 0) {
    const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
    const std::string_view label = m_parts->library->label(pair);
    second = QString("source %1 · %2")
                 .arg(QString::fromStdString(m_parts->library->take_of(pair).name))
                 .arg(m_parts->library->source(pair).frame);
    if (!label.empty())
      second += " · " + QString::fromUtf8(label.data(), static_cast<int>(label.size())).replace('_', ' ');
  }
  if (const int inverted = m_parts->actors.mesh().invertedCount(); inverted > 0)
    first += QString(" · %1 of %2 tetrahedra turned over").arg(inverted).arg(result.tetrahedra.size());
  m_parts->facts->show(
      first, second,
      result.status == StepStatus::Ok ? QString() : QString::fromStdString(result.status_text()));
}

void SceneView::showCandidate(int candidate) {
  Parts& p = *m_parts;
  const bool changed = candidate != p.candidate;
  p.candidate = candidate;
  std::optional<PairPose> pair;
  if (p.frame && p.library && candidate >= 0 &&
      candidate < static_cast<int>(p.frame->result.candidates.size())) {
    const int index = p.frame->result.candidates[static_cast<std::size_t>(candidate)].pair;
    pair = p.library->pair_in_world(index, p.frame->result.query_root,
                                    p.frame->settings.user_role == UserRole::Passive);
  }
  p.actors.showCandidate(pair);
  if (changed) render();
}

void SceneView::setVisibility(const PartVisibility& visibility) {
  if (visibility == m_parts->visibility) return;
  m_parts->visibility = visibility;
  m_parts->actors.setVisibility(visibility);
  m_parts->picker.setVisibility(visibility);
  m_parts->chips->setBetweenOnly(!m_parts->shows(ScenePart::MeshWithin));
  m_parts->chips->setCells(m_parts->shows(ScenePart::Tetrahedra));
  m_parts->cell_legend->setVisible(m_parts->shows(ScenePart::Tetrahedra));
  refresh();
  emit visibilityChanged(visibility);
}

void SceneView::showPart(ScenePart part, bool shown) {
  PartVisibility changed = m_parts->visibility;
  changed[static_cast<std::size_t>(part)] = shown;
  setVisibility(changed);
}

const SceneOptions& SceneView::options() const {
  return m_parts->options;
}

void SceneView::setOptions(const SceneOptions& options) {
  Parts& p = *m_parts;
  if (options == p.options) return;
  p.options = options;
  p.surface->style = options.navigation;
  p.camera.is_parallel = options.is_parallel;
  p.camera.cuts = options.cuts;
  p.camera.cut_m = options.cut_m;
  p.chips->setOptions(options);
  refresh();
  emit optionsChanged(options);
}

const PickedItem& SceneView::picked() const {
  return m_parts->picker.selected();
}

void SceneView::select(const PickedItem& item) {
  Parts& p = *m_parts;
  if (!p.picker.select(item)) return;
  if (item.kind == PickKind::Joint) p.filter_joint = item.vertices[0];
  if (!item) p.filter_joint = -1;
  p.actors.setTrailJoints(p.filter_joint >= 0 ? std::vector<int>{p.filter_joint} : hands);
  refresh();
  emit pickedChanged(item);
}

void SceneView::setScalar(MeshScalar scalar) {
  m_parts->scalar = scalar;
  if (!m_parts->range().locked()) m_parts->range().reset();
  m_parts->legend->setLocked(m_parts->range().locked());
  m_parts->chips->setScalar(scalar);
  refresh();
}

void SceneView::frameAll() {
  if (!m_parts->frame) return;
  m_parts->pair_camera.show_all(m_parts->camera, m_parts->frame->result.result, m_parts->shape());
  render();
}

void SceneView::lookFrom(double azimuth_rad, double elevation_rad) {
  m_parts->pair_camera.turned_by_hand();
  m_parts->camera.azimuth_rad = azimuth_rad;
  m_parts->camera.elevation_rad = elevation_rad;
  render();
}

void SceneView::setFollowing(bool following) {
  m_parts->following = following;
  if (following) m_parts->framed = false;  // begins anew beside the pair
}

void SceneView::render() {
  if (!isVisible()) return;
  Parts& p = *m_parts;
  const bool moving = p.since_render.isValid() && p.since_render.elapsed() < moving_ms;
  p.smoothed = p.budget.wants_smoothing(moving);
  if (!p.smoothed) p.standstill.start();
  p.since_render.start();
  p.on_the_way = true;
  p.stage.render(p.smoothed);
}

void SceneView::renderSharp() {
  m_parts->since_render.invalidate();
  render();
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  Parts& p = *m_parts;
  p.chips->adjustSize();
  p.chips->move(12, 10);
  // Where the chips leave no room the legend goes below them.
  const bool narrow = width() < p.chips->width() + p.legend->width() + 36;
  p.legend->move(width() - p.legend->width() - 10, narrow ? 40 : 8);
  p.cell_legend->move(p.legend->x(), p.legend->y() + p.legend->height() + 2);
  p.facts->setGeometry(14, height() - p.facts->height() - 10, width() - 28, p.facts->height());
  p.picker.arrange();
  render();
}

void SceneView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange && m_parts && m_parts->chips) m_parts->chips->adjustSize();
}

}  // namespace abrazo::widgets
