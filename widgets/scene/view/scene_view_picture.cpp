#include "widgets/scene/view/scene_view_parts.hpp"

namespace abrazo::widgets {

QImage SceneView::picture(const std::optional<QColor>& background) {
  Parts& p = *m_parts;
  if (background) {
    Palette plain = p.palette;
    plain.scene_bottom = plain.scene_top = *background;
    p.stage.setColours(plain, devicePixelRatioF());
  }
  renderSharp();
  const QImage drawn = p.surface->picture();
  if (background) {
    p.stage.setColours(p.palette, devicePixelRatioF());
    renderSharp();
  }
  return drawn;
}

void SceneView::showAs(const SceneView& other, bool captions) {
  Parts& p = *m_parts;
  const Parts& o = *other.m_parts;
  setLibrary(o.library);
  setCharacters(o.characters, o.stances);
  setColours(o.palette);
  p.hidden = o.hidden;
  p.following = false;  // while the options come: they would move the camera
  setScalar(o.scalar);
  setOptions(o.options);
  setVisibility(o.visibility);
  showSelection(o.picker.selected());
  p.ranges = o.ranges;
  p.cell_range = o.cell_range;
  p.width_range = o.width_range;
  p.step = o.step;
  p.pair_camera = o.pair_camera;
  p.camera = o.move ? o.move->to : o.camera;
  p.move.reset();
  p.framed = o.framed;
  p.following = o.following;
  becomePicture(captions);
}

void SceneView::becomePicture(bool captions) {
  Parts& p = *m_parts;
  if (p.move) p.camera = p.move->to;
  p.move.reset();
  p.by_frame_time = true;
  p.followed_s.reset();
  p.chips->hide();
  p.morph->hide();
  p.facts->setVisible(captions);
  const bool shows_mesh = p.shows(ScenePart::MeshBetween) || p.shows(ScenePart::MeshWithin);
  for (ScalarLegend* legend : {p.legend, p.cell_legend}) legend->becomePicture();
  p.legend->setVisible(captions && shows_mesh);
  p.cell_legend->setVisible(captions && p.shows(ScenePart::Tetrahedra));
  arrange();
}

}  // namespace abrazo::widgets
