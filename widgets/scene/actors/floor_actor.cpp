#include "widgets/scene/actors/floor_actor.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
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
#include <cmath>

namespace abrazo::widgets {
namespace {

constexpr double spacing_m = 0.5;
constexpr int lines_each_way = 14;  // to either side of the centre
constexpr double reach_m = spacing_m * lines_each_way;
constexpr int shadow_segments = 20;

struct Colours {
  vtkNew<vtkUnsignedCharArray> rgba;
  Colours() { rgba->SetNumberOfComponents(4); }
  void add(const QColor& colour, double alpha) {
    for (const int channel : {colour.red(), colour.green(), colour.blue()})
      rgba->InsertNextValue(static_cast<unsigned char>(channel));
    rgba->InsertNextValue(static_cast<unsigned char>(std::lround(255 * std::clamp(alpha, 0.0, 1.0))));
  }
};

}  // namespace

struct FloorActor::Parts {
  struct Sheet {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
    Sheet() {
      mapper->SetInputData(data);
      actor->SetMapper(mapper);
      actor->ForceOpaqueOn();  // blends all the same, without the costly translucent pass
      actor->PickableOff();
      actor->GetProperty()->LightingOff();
    }
  };

  Sheet grid, shadows;
  QColor colour = Qt::gray;
  bool dark = true;
  Vec3 centre = Vec3(1e9, 0, 0);
  void buildGrid();
  double strengthAt(double x, double z, bool metre) const;
};

FloorActor::FloorActor() : m_parts(std::make_unique<Parts>()) {}
FloorActor::~FloorActor() = default;

double FloorActor::Parts::strengthAt(double x, double z, bool metre) const {
  const double distance = std::hypot(x - centre.x(), z - centre.z()) / reach_m;
  const double faded = std::max(0.0, 1 - distance);
  return (metre ? 0.42 : 0.22) * faded * faded * (dark ? 1.0 : 1.35);
}

void FloorActor::Parts::buildGrid() {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  Colours colours;
  const auto add = [&](double x, double z, bool metre) {
    colours.add(colour, strengthAt(x, z, metre));
    return points->InsertNextPoint(x, 0, z);
  };
  for (const bool along_x : {true, false}) {
    for (int l = -lines_each_way; l <= lines_each_way; ++l) {
      const double across = (along_x ? centre.z() : centre.x()) + l * spacing_m;
      const bool metre = std::lround(across / spacing_m) % 2 == 0;
      vtkIdType previous = -1;
      for (int s = -lines_each_way; s <= lines_each_way; ++s) {
        const double along = (along_x ? centre.x() : centre.z()) + s * spacing_m;
        const vtkIdType here = along_x ? add(along, across, metre) : add(across, along, metre);
        if (previous >= 0) lines->InsertNextCell({previous, here});
        previous = here;
      }
    }
  }
  grid.data->SetPoints(points);
  grid.data->SetLines(lines);
  grid.data->GetPointData()->SetScalars(colours.rgba);
}

void FloorActor::setColour(const QColor& lines, bool dark_background) {
  m_parts->colour = lines;
  m_parts->dark = dark_background;
  if (m_parts->centre.x() < 1e8) m_parts->buildGrid();
}

void FloorActor::setCentre(const Vec3& centre) {
  const auto snapped = [](double value) { return spacing_m * std::round(value / spacing_m); };
  const Vec3 wanted(snapped(centre.x()), 0, snapped(centre.z()));
  // A walk to and fro over half a cell must not rebuild the grid each time.
  if ((wanted - m_parts->centre).norm() < 1.2 * spacing_m) return;
  m_parts->centre = wanted;
  m_parts->buildGrid();
}

void FloorActor::setShadows(std::span<const Shadow> shadows) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  Colours colours;
  for (const Shadow& shadow : shadows) {
    const vtkIdType middle = points->InsertNextPoint(shadow.above.x(), 0.002, shadow.above.z());
    colours.add(Qt::black, shadow.strength);
    for (int s = 0; s < shadow_segments; ++s) {
      const double angle = 2 * 3.14159265358979 * s / shadow_segments;
      points->InsertNextPoint(shadow.above.x() + shadow.radius_m * std::cos(angle), 0.002,
                              shadow.above.z() + shadow.radius_m * std::sin(angle));
      colours.add(Qt::black, 0);
      triangles->InsertNextCell({middle, middle + 1 + s, middle + 1 + (s + 1) % shadow_segments});
    }
  }
  m_parts->shadows.data->SetPoints(points);
  m_parts->shadows.data->SetPolys(triangles);
  m_parts->shadows.data->GetPointData()->SetScalars(colours.rgba);
}

void FloorActor::setVisible(bool visible) {
  m_parts->grid.actor->SetVisibility(visible);
  m_parts->shadows.actor->SetVisibility(visible);
}

void FloorActor::addTo(vtkRenderer* renderer) {
  renderer->AddActor(m_parts->grid.actor);
  renderer->AddActor(m_parts->shadows.actor);  // after the lines that it darkens
}

}  // namespace abrazo::widgets
