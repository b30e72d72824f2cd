#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/mesh/interaction_mesh.hpp"
#include "core/video/camera_model.hpp"

namespace abrazo::widgets {

/// Parts of a pair in the overlay.
struct OverlayParts {
  bool active = true, passive = true;
  bool mesh = true;            ///< edges between the bodies
  bool within_bodies = false;  ///< the mesh's other edges, without bones

  bool operator==(const OverlayParts&) const = default;
};

struct OverlayLine {
  enum class Part { WithinBody, BetweenBodies, Active, Passive };
  Part part = Part::Active;
  std::vector<Pixel> points;  ///< at least two; more for a lens with distortion
};

/// A pair as a camera sees it, in pixels of the picture.
struct VideoOverlay {
  std::vector<OverlayLine> lines;  ///< the mesh first, so that bodies are drawn over it
  std::array<std::optional<Pixel>, pair_vertex_count> joints;  ///< none if not in front of the camera

  bool empty() const { return lines.empty(); }
};

VideoOverlay project_overlay(const CameraModel& camera, const PairPose& pose, std::span<const MeshEdge> edges,
                             const OverlayParts& parts);

/// Interpolates two frames, because a video's pictures are at other times. No interpolation if the roles
/// changed or the solver jumped: then it is `a` until `b` is reached. @param share 0 = a, 1 = b
PairPose between(const PairPose& a, const PairPose& b, double share);

}  // namespace abrazo::widgets
