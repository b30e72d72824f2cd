#include "widgets/scene/values/morph_step.hpp"

#include <algorithm>

#include "core/mesh/laplacian.hpp"

namespace abrazo::widgets {

int step_count(const FrameSnapshot& frame) {
  return static_cast<int>(frame.result.morph_steps.size());
}

FrameSnapshotPtr at_step(const FrameSnapshotPtr& frame, int step) {
  if (!frame || step >= step_count(*frame)) return frame;
  auto shown = std::make_shared<FrameSnapshot>(*frame);
  FrameResult& result = shown->result;
  result.result = step <= 0 ? result.selected_pair : result.morph_steps[static_cast<std::size_t>(step) - 1];
  result.foot_locks.clear();
  result.collisions.clear();
  Laplacian laplacian;
  laplacian.build(result.edges, result.selected_pair, shown->settings.edge_weights);
  const PairPose bent = laplacian.apply(result.selected_pair) - laplacian.apply(result.result);
  result.edge_residuals_m.clear();
  for (const MeshEdge& edge : result.edges)
    result.edge_residuals_m.push_back(0.5 * (bent.row(edge[0]).norm() + bent.row(edge[1]).norm()));
  return shown;
}

std::string step_text(const FrameSnapshot& frame, int step) {
  const bool has_way = frame.settings.playback == SourcePlayback::Frames;
  const int morphs = has_way ? frame.settings.morph_steps : 1;
  // A frame can have more than the settings ask for: until bones have their lengths, and on other bodies.
  const int projections = std::max(frame.settings.projection_steps, step_count(frame) - morphs);
  const std::string all = std::to_string(morphs) + " + " + std::to_string(projections);
  const int shown = std::clamp(step, 0, step_count(frame));
  if (shown <= morphs) return std::to_string(shown) + " / " + all;
  return std::to_string(morphs) + " + " + std::to_string(shown - morphs) + " / " + all;
}

}  // namespace abrazo::widgets
