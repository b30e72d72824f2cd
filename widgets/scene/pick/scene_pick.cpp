#include "widgets/scene/pick/scene_pick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {
namespace {

constexpr double far_away = std::numeric_limits<double>::infinity();
constexpr double as_near_px = 1.5;  // less apart than a hand can point
constexpr double pointer_counts = 1e6;

/// The best so far by distance in pixels, then by depth.
struct Nearest {
  double distance_px = far_away, depth_m = far_away;
  Selection item;
  void offer(double distance, double depth, const Selection& offered) {
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

Selection nearest_joint(double x, double y, const Projected& at, const std::array<bool, 2>& bodies) {
  Nearest best;
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (!at[v] || !bodies[v / joint_count]) continue;
    const double distance = std::hypot(at[v]->x - x, at[v]->y - y);
    if (distance <= joint_reach_px)
      best.offer(distance, at[v]->depth_m, Selection::joint(static_cast<int>(v)));
  }
  return best.item;
}

Projected projected(const PairPose& pair, const PictureProjection& projection) {
  Projected at;
  for (int v = 0; v < pair_vertex_count; ++v)
    at[static_cast<std::size_t>(v)] = projection.project(pair.row(v).transpose());
  return at;
}

void offer_edges(Nearest& best, double x, double y, const Projected& at, std::span<const MeshEdge> edges) {
  for (const MeshEdge& edge : edges) {
    const auto &a = at[edge[0]], &b = at[edge[1]];
    if (!a || !b) continue;
    const double distance = distance_to_segment(x, y, *a, *b), t = share_along(x, y, *a, *b);
    if (distance <= edge_reach_px)
      best.offer(distance, (1 - t) * a->depth_m + t * b->depth_m, Selection::edge(edge));
  }
}

/// A ghost is drawn over everything: beside an edge that is as near, it is the one that is seen.
void offer_ghost(Nearest& best, double x, double y, const Projected& at, int pair) {
  constexpr double in_front_m = 0;
  for (int v = 0; v < pair_vertex_count; ++v) {
    const int parent = joint_parents[static_cast<std::size_t>(v % joint_count)];
    if (parent < 0) continue;
    const auto &a = at[static_cast<std::size_t>(v - v % joint_count + parent)],
               &b = at[static_cast<std::size_t>(v)];
    if (!a || !b) continue;
    if (const double distance = distance_to_segment(x, y, *a, *b); distance <= edge_reach_px)
      best.offer(distance, in_front_m, Selection::candidate(pair));
  }
}

Selection cell_in_front(double x, double y, const PictureProjection& projection, const Pickable& scene) {
  double nearest = far_away;
  Selection item;
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
      item = Selection::tetrahedron(scene.cells[c]);
    }
  }
  return item;
}

/// Pixels of the segments that a rectangle hides; the pointer counts more than any of them.
double length_within(int x, int y, int width, int height, int pointer_x, int pointer_y,
                     std::span<const std::array<PicturePoint, 2>> segments) {
  constexpr int samples = 64;
  constexpr double dot_counts = 10;
  const auto inside = [=](double px, double py) {
    return px >= x && px <= x + width && py >= y && py <= y + height;
  };
  double hidden = inside(pointer_x, pointer_y) ? pointer_counts : 0;
  for (const auto& [a, b] : segments) {
    const double length = std::max(dot_counts, std::hypot(b.x - a.x, b.y - a.y));
    for (int s = 0; s <= samples; ++s) {
      const double t = static_cast<double>(s) / samples;
      if (inside(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))) hidden += length / samples;
    }
  }
  return hidden;
}

bool covers(int x, int y, int width, int height, const PictureBox& box) {
  return x < box.x + box.width && box.x < x + width && y < box.y + box.height && box.y < y + height;
}

/// What speaks against a place of a card, most important first.
struct CardCost {
  bool covers = true;  ///< something that is taken
  double hidden_px = far_away, away_px = far_away;
  bool operator<(const CardCost& other) const {
    return std::tie(covers, hidden_px, away_px) < std::tie(other.covers, other.hidden_px, other.away_px);
  }
};

}  // namespace

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

Selection pick(double x, double y, const PictureProjection& projection, const Pickable& scene) {
  const Projected at = projected(scene.pair, projection);
  if (const Selection joint = nearest_joint(x, y, at, scene.bodies)) return joint;
  Nearest best;
  offer_edges(best, x, y, at, scene.edges);
  for (const Ghost& ghost : scene.ghosts)
    offer_ghost(best, x, y, projected(ghost.pose, projection), ghost.pair);
  return best.item ? best.item : cell_in_front(x, y, projection, scene);
}

std::vector<std::array<PicturePoint, 2>> segments_of(const Selection& item,
                                                     const PictureProjection& projection,
                                                     const PairPose& pair) {
  const Projected at = projected(pair, projection);
  std::vector<std::array<PicturePoint, 2>> segments;
  const auto add = [&](std::size_t from, std::size_t to) {
    if (at[from] && at[to]) segments.push_back({*at[from], *at[to]});
  };
  const auto& ends = item.vertices;
  if (item.kind == SelectionKind::Joints)
    for (const std::uint8_t joint : ends) add(joint, joint);
  else
    for (std::size_t a = 0; a < ends.size(); ++a)
      for (std::size_t b = a + 1; b < ends.size(); ++b) add(ends[a], ends[b]);
  return segments;
}

CardPlace place_card(int pointer_x, int pointer_y, int width, int height, int room_width, int room_height,
                     std::span<const std::array<PicturePoint, 2>> segments,
                     std::span<const PictureBox> taken) {
  constexpr int gap = 16, gap_to_taken = 6;
  const int last_x = std::max(0, room_width - width), last_y = std::max(0, room_height - height);
  CardPlace best;
  CardCost least;
  const auto offer = [&](int left, int top, bool is_beside) {
    const int x = std::clamp(left, 0, last_x), y = std::clamp(top, 0, last_y);
    CardCost cost;
    cost.covers =
        std::ranges::any_of(taken, [&](const PictureBox& box) { return covers(x, y, width, height, box); });
    cost.hidden_px = length_within(x, y, width, height, pointer_x, pointer_y, segments);
    cost.away_px = is_beside ? 0 : std::hypot(x + width / 2 - pointer_x, y + height / 2 - pointer_y);
    if (!(cost < least)) return;
    least = cost;
    best = {x, y};
  };
  std::vector<int> lefts = {pointer_x + gap, pointer_x - gap - width, pointer_x - width / 2};
  std::vector<int> tops = {pointer_y + gap, pointer_y - gap - height, pointer_y - height / 2};
  for (const int top : tops)
    for (const int left : lefts)
      if (left != lefts[2] || top != tops[2]) offer(left, top, true);  // else over the pointer
  if (!least.covers && least.hidden_px < pointer_counts) return best;
  lefts.insert(lefts.end(), {0, last_x});
  tops.insert(tops.end(), {0, last_y});
  for (const PictureBox& box : taken) {
    lefts.insert(lefts.end(), {box.x - gap_to_taken - width, box.x + box.width + gap_to_taken});
    tops.insert(tops.end(), {box.y - gap_to_taken - height, box.y + box.height + gap_to_taken});
  }
  for (const int top : tops)
    for (const int left : lefts) offer(left, top, false);
  return best;
}

}  // namespace abrazo::widgets
