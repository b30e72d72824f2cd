#include "widgets/scene/actors/body_actor.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QColor>
#include <cmath>
#include <optional>
#include <vector>

#include "widgets/scene/actors/capsule_surface.hpp"
#include "widgets/scene/actors/surface.hpp"
#include "widgets/scene/values/body_light.hpp"

namespace abrazo::widgets {
struct BodyActor::Parts {
  Outline outline;
  std::optional<CapsuleSurface> shape;
  Surface skin, hull;
  vtkNew<vtkUnsignedCharArray> shades;  ///< RGB per point of the skin
  std::vector<float> normals;
  QColor colour = Qt::gray;

  void colourHull();
};

BodyActor::BodyActor(Outline outline) : m_parts(std::make_unique<Parts>()) {
  m_parts->outline = outline;
  auto* skin = m_parts->skin.actor->GetProperty();
  skin->BackfaceCullingOn();
  // The silhouette is the inside of a slightly larger body: only its far faces are drawn.
  auto* hull = m_parts->hull.actor->GetProperty();
  hull->FrontfaceCullingOn();
  m_parts->shades->SetNumberOfComponents(3);
}

BodyActor::~BodyActor() = default;

void BodyActor::setRadii(const CapsuleRadii& radii) {
  m_parts->shape.emplace(radii);
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : m_parts->shape->triangles())
    triangles->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  for (Surface* surface : {&m_parts->skin, &m_parts->hull}) {
    surface->points->SetNumberOfPoints(m_parts->shape->point_count());
    surface->data->SetPolys(triangles);
  }
  m_parts->normals.resize(static_cast<std::size_t>(3 * m_parts->shape->point_count()));
  m_parts->shades->SetNumberOfTuples(m_parts->shape->point_count());
  m_parts->shades->FillValue(0);
  m_parts->skin.data->GetPointData()->SetScalars(m_parts->shades);
  m_parts->colourHull();
}

void BodyActor::setPose(const Pose& pose, double girth) {
  if (!m_parts->shape) return;
  m_parts->shape->place(pose, girth, 0, m_parts->skin.coordinates());
  m_parts->shape->place(pose, girth, outline_m, m_parts->hull.coordinates());
  m_parts->shape->place_normals(pose, m_parts->normals);
  m_parts->skin.points->Modified();
  m_parts->hull.points->Modified();
}

void BodyActor::setColour(const QColor& colour) {
  m_parts->colour = colour;
  m_parts->colourHull();
}

void BodyActor::lightFor(const BodyLight& light) {
  Parts& p = *m_parts;
  if (!p.skin.actor->GetVisibility()) return;
  const Eigen::Vector3f own(static_cast<float>(p.colour.red()), static_cast<float>(p.colour.green()),
                            static_cast<float>(p.colour.blue()));
  unsigned char* shade = p.shades->GetPointer(0);
  for (std::size_t n = 0; n + 2 < p.normals.size(); n += 3) {
    const float brightness = light.on({p.normals[n], p.normals[n + 1], p.normals[n + 2]});
    for (const float channel : own)
      *shade++ = static_cast<unsigned char>(std::min(channel * brightness + 0.5F, 255.0F));
  }
  p.shades->Modified();
}

void BodyActor::Parts::colourHull() {
  const QColor dark = colour.darker(300);
  hull.actor->GetProperty()->SetColor(dark.redF(), dark.greenF(), dark.blueF());
  if (outline == Outline::Solid || !shape) return;
  const QColor gap = colour.darker(135);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (const float along : shape->along()) {
    const QColor& here = std::lround(along * (CapsuleSurface::shaft_rings - 1)) % 4 < 2 ? dark : gap;
    for (const int channel : {here.red(), here.green(), here.blue()})
      colours->InsertNextValue(static_cast<unsigned char>(channel));
  }
  hull.data->GetPointData()->SetScalars(colours);
}

void BodyActor::setVisible(bool visible) {
  m_parts->skin.actor->SetVisibility(visible);
  m_parts->hull.actor->SetVisibility(visible);
}

void BodyActor::addTo(vtkRenderer* renderer) {
  renderer->AddActor(m_parts->skin.actor);  // first: hides most of the silhouette before that is shaded
  renderer->AddActor(m_parts->hull.actor);
}

}  // namespace abrazo::widgets
