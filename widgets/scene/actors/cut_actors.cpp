#include "widgets/scene/actors/cut_actors.hpp"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>

#include <vector>

#include "widgets/scene/values/cut_handles.hpp"

namespace abrazo::widgets {

void cut_away(vtkRenderer* layer, const std::optional<CutPlane>& plane) {
  vtkActorCollection* actors = layer->GetActors();
  vtkCollectionSimpleIterator place;
  actors->InitTraversal(place);
  while (vtkActor* actor = actors->GetNextActor(place)) {
    vtkMapper* mapper = actor->GetMapper();
    if (!mapper) continue;
    vtkPlaneCollection* had = mapper->GetClippingPlanes();
    const bool is_cut = had && had->GetNumberOfItems() > 0;
    if (!plane) {
      if (is_cut) mapper->RemoveAllClippingPlanes();
      continue;
    }
    const Vec3 kept = -plane->normal;  // VTK keeps what lies along the normal
    if (!is_cut) mapper->AddClippingPlane(vtkNew<vtkPlane>());
    vtkPlane* cut = mapper->GetClippingPlanes()->GetItem(0);
    cut->SetOrigin(plane->point.data());
    cut->SetNormal(kept.data());
  }
}

void CutFrame::addTo(vtkRenderer* renderer) {
  m_lines.addTo(renderer);
  show(std::nullopt);
}

void CutFrame::setColours(const Palette& palette, double pixel_ratio) {
  m_lines.setColour(palette.accent.lighter(palette.dark ? 130 : 100), 0.9);
  m_lines.setWidth(1.5 * pixel_ratio);
}

void CutFrame::show(const std::optional<CutPlane>& plane) {
  constexpr double tick_m = 0.15;
  m_lines.setVisible(plane.has_value());
  if (!plane) return;
  // A hair before the plane, so that it does not cut itself away.
  const Vec3 hair = -0.002 * plane->normal, middle = plane->point + hair;
  std::vector<double> points;
  const auto add = [&points](const Vec3& p) { points.insert(points.end(), {p.x(), p.y(), p.z()}); };
  for (const Vec3& corner : outline_of(*plane)) add(corner + hair);
  add(middle);
  add(middle - tick_m * plane->normal);
  m_lines.setPoints(points);
  m_lines.setLines(std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
}

}  // namespace abrazo::widgets
