#pragma once

#include <Eigen/Core>
#include <vector>

namespace abrazo {

using Vec2 = Eigen::Vector2d;

/// Corners of the convex hull, counter-clockwise from the leftmost, without points on an edge. Fewer than
/// three corners if the points are collinear or coincide; empty for no points.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// Distance of a point from a hull of at least one corner [m]; 0 inside and on the border.
/// @throws std::invalid_argument for a hull without corners
double distance_outside(const std::vector<Vec2>& hull, const Vec2& point);

}  // namespace abrazo
