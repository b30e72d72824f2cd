#include "widgets/scene/actors/skin_actor.hpp"

#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QColor>
#include <optional>
#include <vector>

#include "widgets/scene/actors/surface.hpp"
#include "widgets/scene/values/body_light.hpp"

namespace abrazo::widgets {

struct SkinActor::Parts {
  std::optional<CharacterFit> fit;
  Surface skin, hull;
  vtkNew<vtkUnsignedCharArray> shades;  ///< RGB per point of the skin
  std::vector<float> normals;
  std::optional<Pose> pose;  ///< that the skin has
  double time_s = 0;
};

SkinActor::SkinActor() : m_parts(std::make_unique<Parts>()) {
  // Clothes and hair are open surfaces: both sides are drawn, except those of the silhouette.
  m_parts->hull.actor->GetProperty()->FrontfaceCullingOn();
  m_parts->shades->SetNumberOfComponents(3);
  setVisible(false);
}

SkinActor::~SkinActor() = default;

void SkinActor::wear(std::shared_ptr<const WornCharacter> character, const Stance& stance) {
  Parts& p = *m_parts;
  p.fit.reset();
  p.pose.reset();
  if (!character) return setVisible(false);
  const CharacterSkin& skin = character->skin;
  const auto count = static_cast<vtkIdType>(skin.points.size());
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(static_cast<vtkIdType>(skin.triangles.size()),
                           static_cast<vtkIdType>(3 * skin.triangles.size()));
  for (const auto& triangle : skin.triangles)
    triangles->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  for (Surface* surface : {&p.skin, &p.hull}) {
    surface->points->SetNumberOfPoints(count);
    for (float& number : surface->coordinates()) number = 0;
    surface->data->SetPolys(triangles);
  }
  p.normals.assign(3 * skin.points.size(), 0);
  p.shades->SetNumberOfTuples(count);
  p.shades->FillValue(0);
  p.skin.data->GetPointData()->SetScalars(p.shades);
  p.fit.emplace(std::move(character), stance);
}

bool SkinActor::wears() const {
  return m_parts->fit.has_value();
}

void SkinActor::setPose(const Pose& pose, double time_s) {
  Parts& p = *m_parts;
  if (!p.fit || !p.skin.actor->GetVisibility()) return;
  if (p.pose && *p.pose == pose && p.time_s == time_s) return;
  p.pose = pose;
  p.time_s = time_s;
  const std::span<float> points = p.skin.coordinates(), outside = p.hull.coordinates();
  p.fit->fit(pose, time_s, points, p.normals);
  for (std::size_t n = 0; n < outside.size(); ++n)
    outside[n] = points[n] + static_cast<float>(outline_m) * p.normals[n];
  p.skin.points->Modified();
  p.hull.points->Modified();
}

void SkinActor::setColour(const QColor& colour) {
  const QColor rim = colour.darker(140);
  m_parts->hull.actor->GetProperty()->SetColor(rim.redF(), rim.greenF(), rim.blueF());
}

void SkinActor::lightFor(const BodyLight& light) {
  Parts& p = *m_parts;
  if (!p.fit || !p.skin.actor->GetVisibility()) return;
  const auto& colours = p.fit->character().skin.colours;
  unsigned char* shade = p.shades->GetPointer(0);
  for (std::size_t point = 0; point < colours.size(); ++point) {
    const float* normal = &p.normals[3 * point];
    const float brightness = light.on({normal[0], normal[1], normal[2]});
    for (const std::uint8_t channel : colours[point])
      *shade++ =
          static_cast<unsigned char>(std::min(static_cast<float>(channel) * brightness + 0.5F, 255.0F));
  }
  p.shades->Modified();
}

void SkinActor::setVisible(bool visible) {
  for (Surface* surface : {&m_parts->skin, &m_parts->hull}) surface->actor->SetVisibility(visible && wears());
}

void SkinActor::addTo(vtkRenderer* renderer) {
  renderer->AddActor(m_parts->skin.actor);  // first: hides most of the silhouette before that is shaded
  renderer->AddActor(m_parts->hull.actor);
}

}  // namespace abrazo::widgets
