#pragma once

#include <QPointF>

#include "core/session/frame_snapshot.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/scene/scene_parts.hpp"
#include "widgets/scene/scene_pick.hpp"

class QWidget;

namespace abrazo::widgets {

class PickCard;
class SceneStage;

/// What the pointer is on and what is selected: marks both in the scene and tells their facts on cards.
class ScenePicker {
 public:
  ScenePicker(QWidget* parent, SceneStage& stage);

  void setColours(const Palette& palette);
  void setVisibility(const PartVisibility& visibility) { m_visibility = visibility; }
  /// @return whether the scene looks different now. A place outside of the picture points at nothing.
  bool pointAt(QPointF place, const FrameSnapshot& frame);
  /// @return whether something else is selected now
  bool select(const PickedItem& item);
  const PickedItem& selected() const { return m_selected; }
  const PickedItem& hovered() const { return m_hovered; }
  PickedItem itemAt(QPointF place, const FrameSnapshot& frame) const;
  /// Marks and cards follow the frame; what its mesh does not have is told and not marked.
  void show(const FrameSnapshot& frame);
  /// The card of what is selected stands at the lower right.
  void arrange();

 private:
  std::span<const double> cornersOf(const PickedItem& item) const;

  QWidget* m_parent;
  SceneStage& m_stage;
  PickCard *m_selectedCard, *m_hoveredCard;
  PartVisibility m_visibility = default_visibility;
  PickedItem m_selected, m_hovered;
  QPointF m_place{-1e6, -1e6};
};

}  // namespace abrazo::widgets
