#include "widgets/scene/actors/limb_actor.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QColor>
#include <algorithm>
#include <optional>
#include <vector>

#include "widgets/scene/actors/capsule_surface.hpp"

namespace abrazo::widgets {

struct LimbActor::Parts {
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  CapsuleRadii radii{};
  std::vector<int> bones;
  std::optional<CapsuleSurface> shape;

  void rebuild();
};

LimbActor::LimbActor() : m_parts(std::make_unique<Parts>()) {
  Parts& p = *m_parts;
  p.points->SetDataTypeToFloat();
  p.data->SetPoints(p.points);
  p.mapper->SetInputData(p.data);
  p.mapper->SetScalarVisibility(false);
  p.actor->SetMapper(p.mapper);
  p.actor->PickableOff();
  p.actor->ForceOpaqueOn();  // blends all the same, without VTK's translucent pass
  p.actor->GetProperty()->LightingOff();
  p.actor->GetProperty()->BackfaceCullingOn();
}

LimbActor::~LimbActor() = default;

void LimbActor::setRadii(const CapsuleRadii& radii) {
  m_parts->radii = radii;
  m_parts->bones.clear();
  m_parts->shape.reset();
}

void LimbActor::setColour(const QColor& colour, double opacity) {
  m_parts->actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  m_parts->actor->GetProperty()->SetOpacity(opacity);
}

void LimbActor::Parts::rebuild() {
  CapsuleRadii shown{};
  for (const int bone : bones) shown[static_cast<std::size_t>(bone)] = radii[static_cast<std::size_t>(bone)];
  shape.emplace(shown);
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : shape->triangles())
    triangles->InsertNextCell({static_cast<vtkIdType>(triangle[0]), static_cast<vtkIdType>(triangle[1]),
                               static_cast<vtkIdType>(triangle[2])});
  points->SetNumberOfPoints(shape->point_count());
  data->SetPolys(triangles);
}

void LimbActor::show(std::span<const int> bones, const Pose& pose, double girth) {
  Parts& p = *m_parts;
  if (!p.shape || !std::equal(bones.begin(), bones.end(), p.bones.begin(), p.bones.end())) {
    p.bones.assign(bones.begin(), bones.end());
    p.rebuild();
  }
  const auto count = static_cast<std::size_t>(3 * p.shape->point_count());
  if (count == 0) return;
  p.shape->place(pose, girth, 0, {static_cast<float*>(p.points->GetVoidPointer(0)), count});
  p.points->Modified();
}

void LimbActor::setVisible(bool visible) {
  m_parts->actor->SetVisibility(visible);
}

void LimbActor::addTo(vtkRenderer* renderer) {
  renderer->AddActor(m_parts->actor);
}

}  // namespace abrazo::widgets
