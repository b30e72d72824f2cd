#pragma once

#include <QPointF>
#include <QRect>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/scene/pick/scene_pick.hpp"
#include "widgets/scene/values/scene_parts.hpp"

class QWidget;

namespace abrazo::widgets {

class PickCard;
class SceneStage;

/// Hovered and selected item: marks both in the scene and shows their facts on cards.
class ScenePicker {
 public:
  ScenePicker(QWidget* parent, SceneStage& stage);

  void setColours(const Palette& palette);
  void setVisibility(const PartVisibility& visibility) { m_visibility = visibility; }
  /// @return whether the scene changed. A position outside of the picture means no item.
  bool pointAt(QPointF place, const FrameSnapshot& frame);
  /// The shown skeletons of recorded pairs.
  void setGhosts(std::vector<Ghost> ghosts) { m_ghosts = std::move(ghosts); }
  /// For names of candidates; may be null.
  void setLibrary(std::shared_ptr<const MotionLibrary> library) { m_library = std::move(library); }
  /// Offset of the second copy of the selected pair's mesh; zero = none.
  void setReferenceOffset(const Vec3& offset) { m_referenceOffset = offset; }
  /// @return whether the selection changed
  bool select(const Selection& item);
  const Selection& selected() const { return m_selected; }
  const Selection& hovered() const { return m_hovered; }
  Selection itemAt(QPointF place, const FrameSnapshot& frame) const;
  /// Updates marks and cards for the frame; an item missing in its mesh is reported, not marked.
  void show(const FrameSnapshot& frame);
  /// Both cards keep to the upper part of the picture, without the lines that do not fit, and off the
  /// legends. The one of the selection is at its lower right below them; in a low picture it is at the left
  /// if there is more room.
  /// @param height_px of that part  @param at_right, at_left  free for that card
  void arrange(int height_px, const QRect& at_right, const QRect& at_left, const std::vector<QRect>& legends);

 private:
  std::span<const double> cornersOf(const Selection& item) const;
  PictureProjection projection() const;
  void moveCard(const FrameSnapshot& frame);
  void placeSelected();

  QWidget* m_parent;
  SceneStage& m_stage;
  PickCard *m_selectedCard, *m_hoveredCard;
  PartVisibility m_visibility = default_visibility;
  Selection m_selected, m_hovered;
  std::vector<Ghost> m_ghosts;
  std::shared_ptr<const MotionLibrary> m_library;
  Vec3 m_referenceOffset = Vec3::Zero();
  QPointF m_place{-1e6, -1e6};
  int m_height = 0;  ///< of the room for cards
  QRect m_atRight, m_atLeft;
  std::vector<PictureBox> m_legends;
};

}  // namespace abrazo::widgets
