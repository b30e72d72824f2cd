#include "widgets/scene/scene_stage.hpp"

#include <vtkCamera.h>
#include <vtkFXAAOptions.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <cmath>

#include "widgets/scene/gl_surface.hpp"

namespace abrazo::widgets {
namespace {

vtkNew<vtkLight> light(double x, double y, double z, double intensity) {
  vtkNew<vtkLight> made;
  made->SetLightTypeToCameraLight();
  made->SetPosition(x, y, z);
  made->SetFocalPoint(0, 0, 0);
  made->SetIntensity(intensity);
  return made;
}

}  // namespace

struct SceneStage::Parts {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> solid, in_front, topmost;
};

SceneStage::SceneStage(GlSurface& surface) : m_parts(std::make_unique<Parts>()) {
  Parts& p = *m_parts;
  surface.setRenderWindow(p.window.Get());
  if (p.window->GetInteractor()) p.window->GetInteractor()->SetInteractorStyle(nullptr);
  p.window->SetMultiSamples(0);
  p.window->LineSmoothingOn();
  p.window->SetNumberOfLayers(3);
  p.solid->SetLayer(0);
  p.in_front->SetLayer(1);
  p.topmost->SetLayer(2);
  p.solid->GradientBackgroundOn();
  for (vtkRenderer* renderer : {p.solid.Get(), p.in_front.Get(), p.topmost.Get()}) {
    renderer->SetActiveCamera(p.solid->GetActiveCamera());
    renderer->AutomaticLightCreationOff();
    p.window->AddRenderer(renderer);
  }
  // Cheap settings: on a software renderer the search for the ends of edges is most of the cost.
  vtkNew<vtkFXAAOptions> smoothing;
  smoothing->SetUseHighQualityEndpoints(false);
  smoothing->SetEndpointSearchIterations(4);
  p.topmost->SetFXAAOptions(smoothing);
  p.topmost->UseFXAAOn();  // works on the whole picture, so once, in the last layer
  p.solid->AddLight(light(-0.7, 0.9, 1.0, 0.85));
  p.solid->AddLight(light(0.9, 0.1, 0.8, 0.28));
  actors.addTo(p.solid, p.in_front, p.topmost);
  picks.addTo(p.topmost);
}

SceneStage::~SceneStage() = default;

void SceneStage::setColours(const Palette& palette, double pixel_ratio) {
  const QColor &bottom = palette.scene_bottom, &top = palette.scene_top;
  m_parts->solid->SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
  m_parts->solid->SetBackground2(top.redF(), top.greenF(), top.blueF());
  actors.setColours(palette, pixel_ratio);
  picks.setColours(palette, pixel_ratio);
}

void SceneStage::applyCamera() {
  const Vec3 position = camera.position(), up = camera.up();
  vtkCamera* shown = m_parts->solid->GetActiveCamera();
  shown->SetPosition(position.data());
  shown->SetFocalPoint(camera.target.data());
  shown->SetViewUp(up.data());
  shown->SetViewAngle(camera.view_angle_rad * 180 / 3.14159265358979);
  shown->SetParallelProjection(camera.is_parallel);
  shown->SetParallelScale(camera.distance_m * std::tan(camera.view_angle_rad / 2));
  shown->SetClippingRange(camera.nearest_shown_m(), 60);
  actors.sortFor(position, (camera.target - position).normalized());
}

void SceneStage::render(bool smooth) {
  m_parts->topmost->SetUseFXAA(smooth);
  applyCamera();
  m_parts->window->Render();
}

}  // namespace abrazo::widgets
