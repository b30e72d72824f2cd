#include "widgets/scene/actors/line_set.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QColor>
#include <algorithm>

namespace abrazo::widgets {

struct LineSet::Parts {
  Kind kind;
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
};

LineSet::LineSet(Kind kind) : m_parts(std::make_unique<Parts>()) {
  m_parts->kind = kind;
  m_parts->points->SetDataTypeToFloat();
  m_parts->data->SetPoints(m_parts->points);
  m_parts->mapper->SetInputData(m_parts->data);
  m_parts->mapper->SetScalarVisibility(false);
  m_parts->actor->SetMapper(m_parts->mapper);
  m_parts->actor->PickableOff();
  // Blends all the same, in the order of the actors. VTK's translucent pass costs a software renderer more
  // than everything else in the scene.
  m_parts->actor->ForceOpaqueOn();
  m_parts->actor->GetProperty()->LightingOff();
  if (kind == Kind::Dots) m_parts->actor->GetProperty()->RenderPointsAsSpheresOn();
}

LineSet::~LineSet() = default;

void LineSet::setPoints(std::span<const double> xyz) {
  const auto count = static_cast<vtkIdType>(xyz.size() / 3);
  if (m_parts->points->GetNumberOfPoints() != count) m_parts->points->SetNumberOfPoints(count);
  auto* target = static_cast<float*>(m_parts->points->GetVoidPointer(0));
  std::transform(xyz.begin(), xyz.end(), target, [](double value) { return static_cast<float>(value); });
  m_parts->points->Modified();
}

void LineSet::setLines(std::span<const std::array<int, 2>> lines) {
  vtkNew<vtkCellArray> cells;
  for (const auto& line : lines) cells->InsertNextCell({line[0], line[1]});
  m_parts->data->SetLines(cells);
}

void LineSet::setDots(int count) {
  vtkNew<vtkCellArray> cells;
  for (vtkIdType p = 0; p < count; ++p) cells->InsertNextCell(1, &p);
  m_parts->data->SetVerts(cells);
}

void LineSet::setCellColours(std::span<const std::array<unsigned char, 4>> colours) {
  m_parts->mapper->SetScalarVisibility(!colours.empty());
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfComponents(4);
  array->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
  for (std::size_t c = 0; c < colours.size(); ++c)
    array->SetTypedTuple(static_cast<vtkIdType>(c), colours[c].data());
  m_parts->data->GetCellData()->SetScalars(array);
  m_parts->mapper->SetScalarModeToUseCellData();
}

void LineSet::setColour(const QColor& colour, double opacity) {
  m_parts->actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  m_parts->actor->GetProperty()->SetOpacity(opacity);
}

void LineSet::setWidth(double pixels) {
  m_parts->actor->GetProperty()->SetLineWidth(static_cast<float>(pixels));
  m_parts->actor->GetProperty()->SetPointSize(static_cast<float>(pixels));
}

void LineSet::setOffset(const Vec3& offset) {
  m_parts->actor->SetPosition(offset.x(), offset.y(), offset.z());
}

void LineSet::setVisible(bool visible) {
  m_parts->actor->SetVisibility(visible);
}

void LineSet::addTo(vtkRenderer* renderer) {
  renderer->AddActor(m_parts->actor);
}

vtkActor* LineSet::actor() const {
  return m_parts->actor;
}

}  // namespace abrazo::widgets
