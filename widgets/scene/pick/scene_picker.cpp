#include "widgets/scene/pick/scene_picker.hpp"

#include <algorithm>

#include <QWidget>

#include "widgets/scene/actors/scene_stage.hpp"
#include "widgets/scene/pick/pick_card.hpp"

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

PictureProjection ScenePicker::projection() const {
  return {m_stage.camera, static_cast<double>(m_parent->width()), static_cast<double>(m_parent->height())};
}

Selection ScenePicker::itemAt(QPointF place, const FrameSnapshot& frame) const {
  if (!m_parent->rect().contains(place.toPoint())) return {};
  const auto shows = [this](ScenePart part) { return m_visibility[static_cast<std::size_t>(part)]; };
  const bool skeleton = shows(ScenePart::Joints) || shows(ScenePart::Bones);
  const MeshActors& mesh = m_stage.actors.mesh();
  const std::array<bool, 2> bodies = {skeleton || shows(ScenePart::Leader),
                                      skeleton || shows(ScenePart::Follower)};
  const Selection item =
      pick(place.x(), place.y(), projection(),
           {frame.result.result, bodies, mesh.shownEdges(), mesh.shownCells(), mesh.corners(), m_ghosts});
  if (item || m_referenceOffset.isZero()) return item;
  const PairPose beside = frame.result.selected_pair.rowwise() + m_referenceOffset.transpose();
  return pick(place.x(), place.y(), projection(), {beside, {true, true}, mesh.shownEdges(), {}, {}, {}});
}

bool ScenePicker::pointAt(QPointF place, const FrameSnapshot& frame) {
  m_place = place;
  const Selection item = itemAt(place, frame);
  const bool changed = item != m_hovered;
  if (changed) m_hoveredCard->hide();
  m_hovered = item;
  if (changed) show(frame);
  if (m_hovered) moveCard(frame);
  return changed;
}

/// Beside the item, if there is room.
void ScenePicker::moveCard(const FrameSnapshot& frame) {
  auto segments = segments_of(m_hovered, projection(), frame.result.result);
  if (!m_referenceOffset.isZero()) {
    const PairPose beside = frame.result.selected_pair.rowwise() + m_referenceOffset.transpose();
    const auto second = segments_of(m_hovered, projection(), beside);
    segments.insert(segments.end(), second.begin(), second.end());
  }
  const QPoint pointer = m_place.toPoint();
  m_hoveredCard->limit(m_height);
  const CardPlace at = place_card(pointer.x(), pointer.y(), m_hoveredCard->width(), m_hoveredCard->height(),
                                  m_parent->width(), m_height, segments, m_legends);
  m_hoveredCard->move(at.x, at.y);
}

bool ScenePicker::select(const Selection& item) {
  if (item == m_selected) return false;
  m_selected = item;
  m_selectedCard->hide();
  return true;
}

std::span<const double> ScenePicker::cornersOf(const Selection& item) const {
  if (item.kind != SelectionKind::Tetrahedron) return {};
  const auto& cells = m_stage.actors.mesh().shownCells();
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (Selection::tetrahedron(cells[c]) == item) return m_stage.actors.mesh().corners().subspan(12 * c, 12);
  return {};
}

void ScenePicker::show(const FrameSnapshot& frame) {
  const PairPose& pair = frame.result.result;
  const PairPose beside = frame.result.selected_pair.rowwise() + m_referenceOffset.transpose();
  const PairPose* second = m_referenceOffset.isZero() ? nullptr : &beside;
  if (m_hovered) m_hovered = itemAt(m_place, frame);
  const auto in_frame = [&frame](const Selection& item) {
    return has_item(frame, item) ? item : Selection();
  };
  m_stage.picks.showSelected(in_frame(m_selected), {pair, cornersOf(m_selected), second});
  m_stage.picks.showHovered(in_frame(m_hovered), {pair, cornersOf(m_hovered), second});
  // What is selected has a card already.
  const bool tells = m_hovered && m_hovered != m_selected;
  tells ? m_hoveredCard->show(describe(frame, m_hovered, m_library.get())) : m_hoveredCard->hide();
  if (tells) moveCard(frame);
  m_selected ? m_selectedCard->show(describe(frame, m_selected, m_library.get())) : m_selectedCard->hide();
  placeSelected();
}

void ScenePicker::arrange(int height_px, const QRect& at_right, const QRect& at_left,
                          const std::vector<QRect>& legends) {
  m_height = height_px;
  m_atRight = at_right;
  m_atLeft = at_left;
  m_legends.clear();
  for (const QRect& legend : legends)
    m_legends.push_back({legend.x(), legend.y(), legend.width(), legend.height()});
  for (PickCard* card : {m_selectedCard, m_hoveredCard}) card->setMostWidth(at_right.width());
  placeSelected();
}

void ScenePicker::placeSelected() {
  PickCard& card = *m_selectedCard;
  const bool left = card.wholeHeight() > m_atRight.height() && m_atLeft.height() > m_atRight.height() &&
                    card.width() <= m_atLeft.width();
  const QRect& room = left ? m_atLeft : m_atRight;
  card.limit(room.height());
  card.move(left ? room.x() : room.x() + room.width() - card.width(),
            std::max(0, room.y() + room.height() - card.height()));
}

}  // namespace abrazo::widgets
