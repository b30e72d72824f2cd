#include "widgets/scene/view/scene_view_parts.hpp"

namespace abrazo::widgets {

void SceneView::showComparison(const std::optional<PairPose>& a, const std::optional<PairPose>& b) {
  Parts& p = *m_parts;
  if (!p.frame) return;
  const bool was_there = p.stage.ghosts.isThere();
  if (!was_there && !a && !b) return;
  p.stage.ghosts.show(p.frame->result.result, a, b);
  render();
}

bool SceneView::showsComparison() const {
  return m_parts->stage.ghosts.isThere();
}

}  // namespace abrazo::widgets
