#include "core/metrics/support_polygon.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace abrazo {

namespace {

/// Twice the area of the triangle, positive when it turns left.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double distance_from_edge(const Vec2& a, const Vec2& b, const Vec2& point) {
  const Vec2 along = b - a;
  const double length_sq = along.squaredNorm();
  const double t = length_sq > 0 ? std::clamp((point - a).dot(along) / length_sq, 0.0, 1.0) : 0.0;
  return (point - a - t * along).norm();
}

}  // namespace

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  // Monotone chain: the lower border from left to right, then the upper one back.
  std::vector<Vec2> hull;
  const auto add = [&hull](const Vec2& point, std::size_t first) {
    while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
    hull.push_back(point);
  };
  for (const Vec2& point : points) add(point, 0);
  const std::size_t rightmost = hull.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) add(*point, rightmost);
  hull.pop_back();  // the leftmost again
  return hull;
}

double distance_outside(const std::vector<Vec2>& hull, const Vec2& point) {
  if (hull.empty()) throw std::invalid_argument("distance_outside: a hull without corners");
  bool inside = hull.size() >= 3;
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2& from = hull[i];
    const Vec2& to = hull[(i + 1) % hull.size()];
    inside = inside && turn(from, to, point) >= 0;
    nearest = std::min(nearest, distance_from_edge(from, to, point));
  }
  return inside ? 0 : nearest;
}

}  // namespace abrazo
