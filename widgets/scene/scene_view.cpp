#include "widgets/scene/scene_view.hpp"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCamera.h>
#include <vtkFXAAOptions.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <functional>

#include "widgets/scene/pair_camera.hpp"
#include "widgets/scene/scene_actors.hpp"
#include "widgets/scene/scene_overlay.hpp"
#include "widgets/scene/smoothing_budget.hpp"

namespace abrazo::widgets {
namespace {

/// The OpenGL surface. Turns the pointer into camera moves itself: VTK's own styles tilt the horizon and grab
/// keys.
class GlSurface : public QVTKOpenGLNativeWidget {
 public:
  explicit GlSurface(QWidget* parent) : QVTKOpenGLNativeWidget(parent) {}
  std::function<void(QPointF delta, bool pan)> dragged;
  std::function<void(double notches)> wheeled;

 protected:
  void mousePressEvent(QMouseEvent* event) override { m_last = event->localPos(); }
  void mouseReleaseEvent(QMouseEvent*) override {}
  void mouseDoubleClickEvent(QMouseEvent*) override {}
  void mouseMoveEvent(QMouseEvent* event) override {
    if (event->buttons() == Qt::NoButton) return;
    const QPointF delta = event->localPos() - m_last;
    m_last = event->localPos();
    const bool pan = event->buttons() & Qt::RightButton ||
                     (event->buttons() & Qt::MiddleButton && event->modifiers() & Qt::ShiftModifier);
    dragged(delta, pan);
  }
  void wheelEvent(QWheelEvent* event) override { wheeled(event->angleDelta().y() / 120.0); }

 private:
  QPointF m_last;
};

vtkNew<vtkLight> light(double x, double y, double z, double intensity) {
  vtkNew<vtkLight> made;
  made->SetLightTypeToCameraLight();
  made->SetPosition(x, y, z);
  made->SetFocalPoint(0, 0, 0);
  made->SetIntensity(intensity);
  return made;
}

constexpr int standstill_ms = 130;  // without a new picture: time for smooth edges
constexpr int moving_ms = 1000;     // pictures closer than this are one movement, however slow the renderer

QString seconds(double time_s) {
  return QString::number(time_s, 'f', 3) + " s";
}

}  // namespace

struct SceneView::Parts {
  GlSurface* surface = nullptr;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> solid, in_front, topmost;
  SceneActors actors;
  OrbitCamera camera;
  PairCamera pair_camera;
  ScalarChips* chips = nullptr;
  ScalarLegend* legend = nullptr;
  FrameFacts* facts = nullptr;
  Palette palette = palette_of(Theme::Dark);
  PartVisibility visibility = default_visibility;
  PartCounts counts{};
  MeshScalar scalar = MeshScalar::Residual;
  SteadyRange range;
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

  void makeRenderers();
  void applyCamera();
  PictureShape shape() const {
    constexpr double overlays_px = 100;  // the chips above and the facts below
    const double height = std::max(1, surface->height());
    return {surface->width() / height, std::clamp(1 - overlays_px / height, 0.58, 0.84)};
  }
};

void SceneView::Parts::makeRenderers() {
  window->SetMultiSamples(0);
  window->LineSmoothingOn();
  window->SetNumberOfLayers(3);
  solid->SetLayer(0);
  in_front->SetLayer(1);
  topmost->SetLayer(2);
  solid->GradientBackgroundOn();
  for (vtkRenderer* renderer : {solid.Get(), in_front.Get(), topmost.Get()}) {
    renderer->SetActiveCamera(solid->GetActiveCamera());
    renderer->AutomaticLightCreationOff();
    window->AddRenderer(renderer);
  }
  // Cheap settings: on a software renderer the search for the ends of edges is most of the cost.
  vtkNew<vtkFXAAOptions> smoothing;
  smoothing->SetUseHighQualityEndpoints(false);
  smoothing->SetEndpointSearchIterations(4);
  topmost->SetFXAAOptions(smoothing);
  topmost->UseFXAAOn();  // works on the whole picture, so once, in the last layer
  solid->AddLight(light(-0.7, 0.9, 1.0, 0.85));
  solid->AddLight(light(0.9, 0.1, 0.8, 0.28));
  actors.addTo(solid, in_front, topmost);
}

void SceneView::Parts::applyCamera() {
  const Vec3 position = camera.position(), up = camera.up();
  vtkCamera* shown = solid->GetActiveCamera();
  shown->SetPosition(position.data());
  shown->SetFocalPoint(camera.target.data());
  shown->SetViewUp(up.data());
  shown->SetViewAngle(camera.view_angle_rad * 180 / 3.14159265358979);
  shown->SetClippingRange(0.08, 60);
}

void SceneView::prepareApplication() {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
}

SceneView::SceneView(QWidget* parent) : QWidget(parent), m_parts(std::make_unique<Parts>()) {
  Parts& p = *m_parts;
  setMinimumSize(320, 220);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  p.surface = new GlSurface(this);
  p.surface->setRenderWindow(p.window.Get());
  p.surface->setFocusPolicy(Qt::ClickFocus);
  if (p.window->GetInteractor()) p.window->GetInteractor()->SetInteractorStyle(nullptr);
  box->addWidget(p.surface);
  p.makeRenderers();

  p.chips = new ScalarChips(this);
  p.legend = new ScalarLegend(this);
  p.facts = new FrameFacts(this);
  connect(p.chips, &ScalarChips::scalarChosen, this, &SceneView::setScalar);
  connect(p.chips, &ScalarChips::betweenOnlyChosen, this, [this](bool only) {
    PartVisibility changed = m_parts->visibility;
    changed[static_cast<std::size_t>(ScenePart::MeshWithin)] = !only;
    setVisibility(changed);
  });
  connect(p.legend, &ScalarLegend::lockToggled, this,
          [this](bool locked) { m_parts->range.set_locked(locked); });
  connect(p.surface, &QOpenGLWidget::frameSwapped, this, [this] {
    if (!m_parts->on_the_way) return;  // the window was put together anew without a new picture of the scene
    m_parts->on_the_way = false;
    ++m_parts->rendered;
    m_parts->budget.took(m_parts->smoothed, static_cast<double>(m_parts->since_render.nsecsElapsed()) * 1e-6);
  });
  p.standstill.setSingleShot(true);
  p.standstill.setInterval(standstill_ms);
  connect(&p.standstill, &QTimer::timeout, this, &SceneView::renderSharp);
  p.surface->dragged = [this](QPointF delta, bool pan) {
    const double height = m_parts->surface->height();
    if (!pan) m_parts->pair_camera.turned_by_hand();
    pan ? m_parts->camera.pan(delta.x(), delta.y(), height) : m_parts->camera.orbit(delta.x(), delta.y());
    render();
  };
  p.surface->wheeled = [this](double notches) {
    m_parts->pair_camera.zoomed_by_hand();
    m_parts->camera.zoom(notches);
    render();
  };
  setColours(palette_of(Theme::Dark));
  p.actors.setVisibility(p.visibility);
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
  m_parts->range.reset();
  if (!m_parts->library || m_parts->library->bodies().empty()) return;
  m_parts->actors.setRadii(m_parts->library->usual_active_body().capsule_radii,
                           m_parts->library->usual_passive_body().capsule_radii);
}

void SceneView::setColours(const Palette& palette) {
  Parts& p = *m_parts;
  p.palette = palette;
  p.solid->SetBackground(palette.scene_bottom.redF(), palette.scene_bottom.greenF(),
                         palette.scene_bottom.blueF());
  p.solid->SetBackground2(palette.scene_top.redF(), palette.scene_top.greenF(), palette.scene_top.blueF());
  p.actors.setColours(palette, devicePixelRatioF());
  p.legend->setColours(palette);
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
    const ScalarInfo info = scalar_info(p.scalar);
    const auto scalars = edge_scalars(p.frame->result, p.scalar);
    p.range.show(typical_upper(p.frame->result.edges, scalars), p.frame->time_s);
    p.legend->show(p.scalar, p.range.upper());
    p.actors.show(*p.frame, scalars, p.range, info.is_signed);
    showCandidate(p.candidate);
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
  const QString first = QString("frame %1 · %2 · morph step %3 / %3 + %4")
                            .arg(frame.index)
                            .arg(seconds(frame.time_s))
                            .arg(frame.settings.morph_steps)
                            .arg(frame.settings.projection_steps);
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
  m_parts->chips->setBetweenOnly(!visibility[static_cast<std::size_t>(ScenePart::MeshWithin)]);
  refresh();
  emit visibilityChanged(visibility);
}

void SceneView::setScalar(MeshScalar scalar) {
  m_parts->scalar = scalar;
  m_parts->range.reset();
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
  p.topmost->SetUseFXAA(p.smoothed);
  if (!p.smoothed) p.standstill.start();
  p.since_render.start();
  p.on_the_way = true;
  p.applyCamera();
  p.window->Render();
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
  p.facts->setGeometry(14, height() - p.facts->height() - 10, width() - 28, p.facts->height());
  render();
}

void SceneView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange && m_parts && m_parts->chips) m_parts->chips->adjustSize();
}

}  // namespace abrazo::widgets
