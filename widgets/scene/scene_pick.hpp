#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/mesh/interaction_mesh.hpp"
#include "widgets/scene/picture_projection.hpp"

namespace abrazo::widgets {

enum class PickKind { None, Joint, Edge, Tetrahedron };

/// What was pointed at, named by its vertices of the pair: the same thing in every frame.
struct PickedItem {
  PickKind kind = PickKind::None;
  std::array<std::uint8_t, 4> vertices{};  ///< ascending; the first 1, 2 or 4 count
  bool operator==(const PickedItem&) const = default;
  explicit operator bool() const { return kind != PickKind::None; }

  static PickedItem joint(int vertex);
  static PickedItem edge(const MeshEdge& edge);
  static PickedItem tetrahedron(const MeshTetrahedron& cell);
  int vertex_count() const;
};

/// What can be pointed at.
struct Pickable {
  const PairPose& pair;
  std::array<bool, 2> bodies{true, true};  ///< whose joints
  std::span<const MeshEdge> edges;
  std::span<const MeshTetrahedron> cells;
  std::span<const double> corners;  ///< of the cells as they are drawn, 12 numbers each, world [m]
};

inline constexpr double joint_reach_px = 9, edge_reach_px = 5;

/// Pixels from (x, y) to the segment a b.
double distance_to_segment(double x, double y, const PicturePoint& a, const PicturePoint& b);
/// Depth of the triangle at (x, y), interpolated in the picture; negative outside of it.
double depth_inside(double x, double y, const std::array<PicturePoint, 3>& triangle);

/// A joint within `joint_reach_px`, else an edge within `edge_reach_px`, else the cell in front. Of several
/// joints or edges the nearest to the pointer; of those that lie as near as makes no difference, the nearest
/// to the eye.
PickedItem pick(double x, double y, const PictureProjection& projection, const Pickable& scene);

}  // namespace abrazo::widgets
