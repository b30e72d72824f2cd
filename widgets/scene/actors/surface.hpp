#pragma once

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <array>
#include <cstdint>
#include <span>

namespace abrazo::widgets {

/// Points, triangles and an actor of one surface. Its brightness is in the colours of its points.
struct Surface {
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  Surface() {
    points->SetDataTypeToFloat();
    data->SetPoints(points);
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
  }
  std::span<float> coordinates() {
    return {static_cast<float*>(points->GetVoidPointer(0)),
            static_cast<std::size_t>(3 * points->GetNumberOfPoints())};
  }
};

/// Drawn width of a silhouette: the inside of a surface that is larger by so much [m].
inline constexpr double outline_m = 0.006;

}  // namespace abrazo::widgets
