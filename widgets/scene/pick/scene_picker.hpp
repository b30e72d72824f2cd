#pragma once

#include <QPointF>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/scene/pick/scene_pick.hpp"
#include "widgets/scene/values/scene_parts.hpp"

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
  /// Skeletons of recorded pairs that are shown.
  void setGhosts(std::vector<Ghost> ghosts) { m_ghosts = std::move(ghosts); }
  /// Names candidates; may be null.
  void setLibrary(std::shared_ptr<const MotionLibrary> library) { m_library = std::move(library); }
  /// Where the mesh of the selected pair stands a second time; zero when it does not.
  void setReferenceOffset(const Vec3& offset) { m_referenceOffset = offset; }
  /// @return whether something else is selected now
  bool select(const Selection& item);
  const Selection& selected() const { return m_selected; }
  const Selection& hovered() const { return m_hovered; }
  Selection itemAt(QPointF place, const FrameSnapshot& frame) const;
  /// Marks and cards follow the frame; what its mesh does not have is reported and not marked.
  void show(const FrameSnapshot& frame);
  /// The card of what is selected stands at the lower right.
  void arrange();

 private:
  std::span<const double> cornersOf(const Selection& item) const;
  PictureProjection projection() const;
  void moveCard(const FrameSnapshot& frame);

  QWidget* m_parent;
  SceneStage& m_stage;
  PickCard *m_selectedCard, *m_hoveredCard;
  PartVisibility m_visibility = default_visibility;
  Selection m_selected, m_hovered;
  std::vector<Ghost> m_ghosts;
  std::shared_ptr<const MotionLibrary> m_library;
  Vec3 m_referenceOffset = Vec3::Zero();
  QPointF m_place{-1e6, -1e6};
};

}  // namespace abrazo::widgets
