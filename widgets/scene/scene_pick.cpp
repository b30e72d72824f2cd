#include "widgets/scene/scene_pick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace abrazo::widgets {
namespace {

constexpr double far_away = std::numeric_limits<double>::infinity();
constexpr double as_near_px = 1.5;  // less apart than a hand can point

/// The best so far by distance in pixels, then by depth.
struct Nearest {
  double distance_px = far_away, depth_m = far_away;
  PickedItem item;
  void offer(double distance, double depth, const PickedItem& offered) {
    const bool nearer = distance < distance_px - as_near_px;
    const bool level = std::abs(distance - distance_px) <= as_near_px && depth < depth_m;
    if (!nearer && !level) return;
    distance_px = distance, depth_m = depth, item = offered;
  }
};

/// How much of the segment lies before the place nearest to (x, y), 0 to 1.
double share_along(double x, double y, const PicturePoint& a, const PicturePoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  return squared > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / squared, 0.0, 1.0) : 0;
}

using Projected = std::array<std::optional<PicturePoint>, pair_vertex_count>;

PickedItem nearest_joint(double x, double y, const Projected& at, const std::array<bool, 2>& bodies) {
  Nearest best;
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (!at[v] || !bodies[v / joint_count]) continue;
    const double distance = std::hypot(at[v]->x - x, at[v]->y - y);
    if (distance <= joint_reach_px)
      best.offer(distance, at[v]->depth_m, PickedItem::joint(static_cast<int>(v)));
  }
  return best.item;
}

PickedItem nearest_edge(double x, double y, const Projected& at, std::span<const MeshEdge> edges) {
  Nearest best;
  for (const MeshEdge& edge : edges) {
    const auto &a = at[edge[0]], &b = at[edge[1]];
    if (!a || !b) continue;
    const double distance = distance_to_segment(x, y, *a, *b), t = share_along(x, y, *a, *b);
    if (distance <= edge_reach_px)
      best.offer(distance, (1 - t) * a->depth_m + t * b->depth_m, PickedItem::edge(edge));
  }
  return best.item;
}

PickedItem cell_in_front(double x, double y, const PictureProjection& projection, const Pickable& scene) {
  double nearest = far_away;
  PickedItem item;
  for (std::size_t c = 0; c < scene.cells.size(); ++c) {
    std::array<PicturePoint, 4> corners;
    bool shown = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto point = projection.project(Vec3(scene.corners.data() + 12 * c + 3 * i));
      shown = shown && point;
      if (point) corners[i] = *point;
    }
    for (std::size_t left_out = 0; shown && left_out < 4; ++left_out) {
      const double depth = depth_inside(
          x, y, {corners[(left_out + 1) % 4], corners[(left_out + 2) % 4], corners[(left_out + 3) % 4]});
      if (depth < 0 || depth >= nearest) continue;
      nearest = depth;
      item = PickedItem::tetrahedron(scene.cells[c]);
    }
  }
  return item;
}

}  // namespace

PickedItem PickedItem::joint(int vertex) {
  return {PickKind::Joint, {static_cast<std::uint8_t>(vertex)}};
}

PickedItem PickedItem::edge(const MeshEdge& edge) {
  return {PickKind::Edge, {std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}};
}

PickedItem PickedItem::tetrahedron(const MeshTetrahedron& cell) {
  PickedItem item{PickKind::Tetrahedron, cell};
  std::sort(item.vertices.begin(), item.vertices.end());
  return item;
}

int PickedItem::vertex_count() const {
  constexpr std::array<int, 4> counts = {0, 1, 2, 4};
  return counts[static_cast<std::size_t>(kind)];
}

double distance_to_segment(double x, double y, const PicturePoint& a, const PicturePoint& b) {
  const double t = share_along(x, y, a, b);
  return std::hypot(a.x + t * (b.x - a.x) - x, a.y + t * (b.y - a.y) - y);
}

double depth_inside(double x, double y, const std::array<PicturePoint, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (area == 0) return -1;
  const double u = ((b.x - x) * (c.y - y) - (b.y - y) * (c.x - x)) / area;
  const double v = ((c.x - x) * (a.y - y) - (c.y - y) * (a.x - x)) / area;
  const double w = 1 - u - v;
  if (u < 0 || v < 0 || w < 0) return -1;
  return u * a.depth_m + v * b.depth_m + w * c.depth_m;
}

PickedItem pick(double x, double y, const PictureProjection& projection, const Pickable& scene) {
  Projected at;
  for (int v = 0; v < pair_vertex_count; ++v)
    at[static_cast<std::size_t>(v)] = projection.project(scene.pair.row(v).transpose());
  if (const PickedItem joint = nearest_joint(x, y, at, scene.bodies)) return joint;
  if (const PickedItem edge = nearest_edge(x, y, at, scene.edges)) return edge;
  return cell_in_front(x, y, projection, scene);
}

}  // namespace abrazo::widgets
