#include "widgets/scene/actors/cell_actor.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "widgets/scene/values/mesh_scalar.hpp"

namespace abrazo::widgets {
namespace {

using Rgba = std::array<unsigned char, 4>;
constexpr unsigned char flat_alpha = 14, inverted_alpha = 150;

/// What changed much is denser: the many cells that kept their volume must not hide it.
unsigned char alpha_of(double share) {
  return static_cast<unsigned char>(std::lround(26 + 110 * std::min(std::abs(share), 1.0)));
}

}  // namespace

struct CellActor::Parts {
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
};

CellActor::CellActor() : m_parts(std::make_unique<Parts>()) {
  Parts& p = *m_parts;
  p.points->SetDataTypeToFloat();
  p.data->SetPoints(p.points);
  p.mapper->SetInputData(p.data);
  p.mapper->SetScalarModeToUseCellData();
  p.actor->SetMapper(p.mapper);
  p.actor->PickableOff();
  // Blends in the order of its faces, which are sorted here: far cheaper than VTK's translucent pass.
  p.actor->ForceOpaqueOn();
  p.actor->GetProperty()->LightingOff();
  p.actor->VisibilityOff();
  m_rims.setVisible(false);
}

CellActor::~CellActor() = default;

void CellActor::setColours(const Palette& palette, double pixel_ratio) {
  m_dark = palette.dark;
  m_inverted = palette.dark ? QColor("#ff3fb4") : QColor("#c8007a");
  m_rims.setColour(m_inverted);
  m_rims.setWidth(2 * pixel_ratio);
}

void CellActor::setVisible(bool visible) {
  m_parts->actor->SetVisibility(visible);
  m_rims.setVisible(visible);
}

void CellActor::addTo(vtkRenderer* solid, vtkRenderer* in_front) {
  solid->AddActor(m_parts->actor);
  m_rims.addTo(in_front);
}

void CellActor::show(std::vector<double> corners, std::span<const CellVolume> cells, double doublings) {
  m_corners = std::move(corners);
  m_colours.clear();
  std::vector<std::array<int, 2>> rims;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const CellVolume& cell = cells[c];
    if (cell.is_inverted) {
      m_colours.push_back({static_cast<unsigned char>(m_inverted.red()),
                           static_cast<unsigned char>(m_inverted.green()),
                           static_cast<unsigned char>(m_inverted.blue()), inverted_alpha});
      const int first = static_cast<int>(4 * c);
      for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b) rims.push_back({first + a, first + b});
      continue;
    }
    const double share = !cell.is_flat && doublings > 0 ? std::log2(cell.ratio) / doublings : 0;
    const auto [r, g, b] = diverging_colour(0.5 + share / 2);
    m_colours.push_back({r, g, b, cell.is_flat ? flat_alpha : alpha_of(share)});
  }
  Parts& p = *m_parts;
  p.points->SetNumberOfPoints(static_cast<vtkIdType>(m_corners.size() / 3));
  std::transform(m_corners.begin(), m_corners.end(), static_cast<float*>(p.points->GetVoidPointer(0)),
                 [](double value) { return static_cast<float>(value); });
  p.points->Modified();
  m_rims.setPoints(m_corners);
  m_rims.setLines(rims);
}

void CellActor::sortFor(const Vec3& eye, const Vec3& direction) {
  Parts& p = *m_parts;
  if (!p.actor->GetVisibility()) return;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  for (const int face : faces_back_to_front(m_corners, eye, direction)) {
    const auto& [a, b, c] = cell_faces[static_cast<std::size_t>(face % 4)];
    const vtkIdType first = 4 * (face / 4);
    triangles->InsertNextCell({first + a, first + b, first + c});
    colours->InsertNextTypedTuple(m_colours[static_cast<std::size_t>(face / 4)].data());
  }
  p.data->SetPolys(triangles);
  p.data->GetCellData()->SetScalars(colours);
}

}  // namespace abrazo::widgets
