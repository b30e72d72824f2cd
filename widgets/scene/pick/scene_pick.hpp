#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/interaction_mesh.hpp"
#include "widgets/common/selection.hpp"
#include "widgets/scene/values/picture_projection.hpp"

namespace abrazo::widgets {

/// A recorded pair shown as a skeleton.
struct Ghost {
  int pair = -1;  ///< of the library
  PairPose pose = PairPose::Zero();
};

/// The items that can be picked.
struct Pickable {
  const PairPose& pair;
  std::array<bool, 2> bodies{true, true};  ///< whose joints
  std::span<const MeshEdge> edges;
  std::span<const MeshTetrahedron> cells;
  std::span<const double> corners;  ///< of the drawn cells, 12 numbers each, world [m]
  std::span<const Ghost> ghosts;
};

inline constexpr double joint_reach_px = 9, edge_reach_px = 5;

/// Distance of (x, y) from the segment a b [pixels].
double distance_to_segment(double x, double y, const PicturePoint& a, const PicturePoint& b);
/// Depth of the triangle at (x, y), interpolated in the picture; negative outside of it.
double depth_inside(double x, double y, const std::array<PicturePoint, 3>& triangle);

/// A joint within `joint_reach_px`, else an edge or a bone of a ghost within `edge_reach_px`, else the cell
/// in front. Among several the nearest to the pointer; among equally near ones the nearest to the eye.
Selection pick(double x, double y, const PictureProjection& projection, const Pickable& scene);

/// The visible lines of an item in the picture, as ends of segments.
std::vector<std::array<PicturePoint, 2>> segments_of(const Selection& item,
                                                     const PictureProjection& projection,
                                                     const PairPose& pair);

/// A rectangle of the picture [pixels].
struct PictureBox {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Position of a card of this size beside the pointer, inside the view and off the segments if possible, else
/// where it hides least of them. Off the taken boxes wherever there is other room, if not beside the pointer.
struct CardPlace {
  int x = 0, y = 0;
};
CardPlace place_card(int pointer_x, int pointer_y, int width, int height, int room_width, int room_height,
                     std::span<const std::array<PicturePoint, 2>> segments,
                     std::span<const PictureBox> taken = {});

}  // namespace abrazo::widgets
