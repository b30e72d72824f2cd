#pragma once

#include <algorithm>
#include <array>

#include "core/base/positions.hpp"

namespace abrazo {

/// Corner of a triangle with the triangle's normal.
struct OctahedronCorner {
  Vec3 place, normal;
};

/// The usual picture of a bone: an octahedron from `from` to `to` [m], widest near its beginning, as 8 flat
/// triangles (three corners each, anticlockwise seen from outside).
inline std::array<OctahedronCorner, 24> bone_octahedron(const Vec3& from, const Vec3& to) {
  constexpr double waist_at = 0.15, width = 0.12, widest_m = 0.04;
  const Vec3 along = to - from;
  const Vec3 side = along.unitOrthogonal() * std::min(width * along.norm(), widest_m);
  const Vec3 front = along.normalized().cross(side);
  const Vec3 waist = from + waist_at * along;
  const std::array<Vec3, 4> ring = {waist + side, waist + front, waist - side, waist - front};
  std::array<OctahedronCorner, 24> corners;
  std::size_t next = 0;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a).normalized();
    for (const Vec3& place : {a, b, c}) corners[next++] = {place, normal};
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    add(ring[i], ring[j], to);
    add(ring[j], ring[i], from);
  }
  return corners;
}

}  // namespace abrazo
