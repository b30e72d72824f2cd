#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/mesh/interaction_mesh.hpp"
#include "core/video/camera_model.hpp"

namespace abrazo::widgets {

/// What of a pair is drawn over a picture.
struct OverlayParts {
  bool active = true, passive = true;
  bool mesh = true;            ///< edges between the bodies
  bool within_bodies = false;  ///< the mesh's other edges, bones left out

  bool operator==(const OverlayParts&) const = default;
};

struct OverlayLine {
  enum class Part { WithinBody, BetweenBodies, Active, Passive };
  Part part = Part::Active;
  std::vector<Pixel> points;  ///< at least two; curved where the lens distorts
};

/// A pair as a camera sees it, in pixels of the picture.
struct VideoOverlay {
  std::vector<OverlayLine> lines;  ///< the mesh first, so that the bodies are drawn over it
  std::array<std::optional<Pixel>, pair_vertex_count>
      joints;  ///< nothing where it is not in front of the camera

  bool empty() const { return lines.empty(); }
};

VideoOverlay project_overlay(const CameraModel& camera, const PairPose& pose, std::span<const MeshEdge> edges,
                             const OverlayParts& parts);

/// Between two frames: a video's pictures are not taken at their times. Where the bodies changed their parts,
/// or the solver jumped, there is nothing between: then it is `a` until `b` is reached. @param share  0 = a,
/// 1 = b
PairPose between(const PairPose& a, const PairPose& b, double share);

}  // namespace abrazo::widgets
