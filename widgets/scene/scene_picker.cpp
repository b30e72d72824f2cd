#include "widgets/scene/scene_picker.hpp"

#include <QWidget>

#include "widgets/scene/pick_card.hpp"
#include "widgets/scene/scene_stage.hpp"

namespace abrazo::widgets {

ScenePicker::ScenePicker(QWidget* parent, SceneStage& stage)
    : m_parent(parent),
      m_stage(stage),
      m_selectedCard(new PickCard(parent)),
      m_hoveredCard(new PickCard(parent)) {
  m_selectedCard->setObjectName("selected");
  m_hoveredCard->setObjectName("hovered");
}

void ScenePicker::setColours(const Palette& palette) {
  m_selectedCard->setColours(palette);
  m_hoveredCard->setColours(palette);
}

PickedItem ScenePicker::itemAt(QPointF place, const FrameSnapshot& frame) const {
  if (!m_parent->rect().contains(place.toPoint())) return {};
  const auto shows = [this](ScenePart part) { return m_visibility[static_cast<std::size_t>(part)]; };
  const bool skeleton = shows(ScenePart::Joints) || shows(ScenePart::Bones);
  const MeshActors& mesh = m_stage.actors.mesh();
  const PictureProjection projection(m_stage.camera, m_parent->width(), m_parent->height());
  return pick(place.x(), place.y(), projection,
              {frame.result.result,
               {skeleton || shows(ScenePart::Leader), skeleton || shows(ScenePart::Follower)},
               mesh.shownEdges(),
               mesh.shownCells(),
               mesh.corners()});
}

bool ScenePicker::pointAt(QPointF place, const FrameSnapshot& frame) {
  m_place = place;
  const PickedItem item = itemAt(place, frame);
  const bool changed = item != m_hovered;
  if (changed) m_hoveredCard->hide();
  m_hovered = item;
  if (changed) show(frame);
  if (m_hovered) m_hoveredCard->moveBeside(place.toPoint());
  return changed;
}

bool ScenePicker::select(const PickedItem& item) {
  if (item == m_selected) return false;
  m_selected = item;
  m_selectedCard->hide();
  return true;
}

std::span<const double> ScenePicker::cornersOf(const PickedItem& item) const {
  if (item.kind != PickKind::Tetrahedron) return {};
  const auto& cells = m_stage.actors.mesh().shownCells();
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (PickedItem::tetrahedron(cells[c]) == item) return m_stage.actors.mesh().corners().subspan(12 * c, 12);
  return {};
}

void ScenePicker::show(const FrameSnapshot& frame) {
  const PairPose& pair = frame.result.result;
  if (m_hovered && m_hovered != itemAt(m_place, frame)) m_hovered = itemAt(m_place, frame);
  const auto in_frame = [&frame](const PickedItem& item) {
    return has_item(frame, item) ? item : PickedItem();
  };
  m_stage.picks.showSelected(in_frame(m_selected), pair, cornersOf(m_selected));
  m_stage.picks.showHovered(in_frame(m_hovered), pair, cornersOf(m_hovered));
  m_hovered ? m_hoveredCard->show(describe(frame, m_hovered)) : m_hoveredCard->hide();
  m_selected ? m_selectedCard->show(describe(frame, m_selected)) : m_selectedCard->hide();
  arrange();
}

void ScenePicker::arrange() {
  constexpr int margin = 12;
  m_selectedCard->move(m_parent->width() - m_selectedCard->width() - margin,
                       m_parent->height() - m_selectedCard->height() - margin);
}

}  // namespace abrazo::widgets
