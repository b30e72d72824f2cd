#include "widgets/scene/actors/scene_stage.hpp"

#include <vtkCamera.h>
#include <vtkCullerCollection.h>
#include <vtkFXAAOptions.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <cmath>
#include <utility>

#include "widgets/scene/actors/empty_culler.hpp"
#include "widgets/scene/actors/gl_surface.hpp"

namespace abrazo::widgets {
struct SceneStage::Parts {
  explicit Parts(GlSurface& on) : surface(on) {}
  GlSurface& surface;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> solid, in_front, topmost;
};

SceneStage::SceneStage(GlSurface& surface) : m_parts(std::make_unique<Parts>(surface)) {
  Parts& p = *m_parts;
  surface.setRenderWindow(p.window.Get());
  p.window->SetMultiSamples(0);
  p.window->LineSmoothingOn();
  p.window->SetNumberOfLayers(3);
  p.solid->SetLayer(0);
  p.in_front->SetLayer(1);
  p.topmost->SetLayer(2);
  p.solid->GradientBackgroundOn();
  p.solid->SetBackgroundAlpha(1);  // objects drawn over it leave it at 1
  for (vtkRenderer* renderer : {p.solid.Get(), p.in_front.Get(), p.topmost.Get()}) {
    renderer->SetActiveCamera(p.solid->GetActiveCamera());
    renderer->AutomaticLightCreationOff();
    renderer->GetCullers()->RemoveAllItems();
    renderer->AddCuller(vtkNew<EmptyCuller>());
    p.window->AddRenderer(renderer);
  }
  // Cheap settings: on a software renderer the search for the ends of edges is most of the cost.
  vtkNew<vtkFXAAOptions> smoothing;
  smoothing->SetUseHighQualityEndpoints(false);
  smoothing->SetEndpointSearchIterations(4);
  p.topmost->SetFXAAOptions(smoothing);
  p.topmost->UseFXAAOn();  // works on the whole picture, so once, in the last layer
  actors.addTo(p.solid, p.in_front, p.topmost);
  ghosts.addTo(p.in_front);
  picks.addTo(p.in_front, p.topmost);
}

SceneStage::~SceneStage() = default;

void SceneStage::setColours(const Palette& palette, double pixel_ratio) {
  const QColor &bottom = palette.scene_bottom, &top = palette.scene_top;
  m_parts->solid->SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
  m_parts->solid->SetBackground2(top.redF(), top.greenF(), top.blueF());
  actors.setColours(palette, pixel_ratio);
  picks.setColours(palette, pixel_ratio);
  ghosts.setColours(palette, pixel_ratio);
}

void SceneStage::applyCamera() {
  const Vec3 position = camera.position(), up = camera.up();
  vtkCamera* shown = m_parts->solid->GetActiveCamera();
  shown->SetPosition(position.data());
  const Vec3 focus = camera.focus();
  shown->SetFocalPoint(focus.data());
  shown->SetViewUp(up.data());
  shown->SetViewAngle(camera.view_angle_rad * 180 / 3.14159265358979);
  shown->SetWindowCenter(0, camera.lowered);
  shown->SetParallelProjection(camera.is_parallel);
  shown->SetParallelScale(camera.distance_m * std::tan(camera.view_angle_rad / 2));
  shown->SetClippingRange(camera.nearest_shown_m(), 60);
  const Vec3 direction = (focus - position).normalized();
  actors.sortFor(position, direction);
  ghosts.separateFor(direction);
  for (vtkRenderer* layer : {m_parts->solid.Get(), m_parts->in_front.Get(), m_parts->topmost.Get()})
    cut_away(layer, camera.plane);
}

void SceneStage::render(bool smooth, std::function<void(double took_ms)> shown) {
  m_parts->topmost->SetUseFXAA(smooth);
  applyCamera();
  m_parts->surface.requestPicture(std::move(shown));
}

}  // namespace abrazo::widgets
