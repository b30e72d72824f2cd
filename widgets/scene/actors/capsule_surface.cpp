#include "widgets/scene/actors/capsule_surface.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace abrazo::widgets {
namespace {

/// A ring of the unit capsule: where its centre is along the bone, how far beyond the end, how wide.
struct Ring {
  double along;   ///< 0..1 between the ends
  double beyond;  ///< in radii, along the axis
  double width;   ///< in radii
};

std::array<Ring, CapsuleSurface::rings> unit_rings() {
  std::array<Ring, CapsuleSurface::rings> rings{};
  std::size_t next = 0;
  for (int i = 1; i <= CapsuleSurface::cap_rings; ++i) {
    const double angle = -std::numbers::pi / 2 + (std::numbers::pi / 2) * i / (CapsuleSurface::cap_rings + 1);
    rings[next++] = {0, std::sin(angle), std::cos(angle)};
  }
  for (int i = 0; i < CapsuleSurface::shaft_rings; ++i)
    rings[next++] = {static_cast<double>(i) / (CapsuleSurface::shaft_rings - 1), 0, 1};
  for (int i = 1; i <= CapsuleSurface::cap_rings; ++i) {
    const double angle = (std::numbers::pi / 2) * i / (CapsuleSurface::cap_rings + 1);
    rings[next++] = {1, std::sin(angle), std::cos(angle)};
  }
  return rings;
}

const std::array<Ring, CapsuleSurface::rings> the_rings = unit_rings();

std::array<std::array<double, 2>, CapsuleSurface::segments> circle() {
  std::array<std::array<double, 2>, CapsuleSurface::segments> points{};
  for (std::size_t s = 0; s < points.size(); ++s) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(s) / CapsuleSurface::segments;
    points[s] = {std::cos(angle), std::sin(angle)};
  }
  return points;
}

const auto the_circle = circle();

}  // namespace

CapsuleSurface::CapsuleSurface(const CapsuleRadii& radii) {
  for (int b = 0; b < bone_count; ++b)
    if (radii[static_cast<std::size_t>(b)] > 0)
      bones_.push_back({bone(b).first, bone(b).second, radii[static_cast<std::size_t>(b)]});

  for (std::size_t c = 0; c < bones_.size(); ++c) {
    const auto base = static_cast<std::int64_t>(c) * points_per_capsule;
    const auto at = [base](int ring, int segment) {
      return base + 1 + std::int64_t{ring} * segments + segment % segments;
    };
    const std::int64_t last = base + points_per_capsule - 1;
    for (int s = 0; s < segments; ++s) {
      triangles_.push_back({base, at(0, s + 1), at(0, s)});
      triangles_.push_back({last, at(rings - 1, s), at(rings - 1, s + 1)});
      for (int r = 0; r + 1 < rings; ++r) {
        triangles_.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
        triangles_.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
      }
    }
    along_.push_back(0);
    for (const Ring& ring : the_rings)
      for (int s = 0; s < segments; ++s) along_.push_back(static_cast<float>(ring.along));
    along_.push_back(1);
  }
}

/// Calls put(end or shaft point of the axis, unit direction outwards, radius) for every surface point in
/// order.
template <typename Put>
void CapsuleSurface::visit(const Pose& pose, Put put) const {
  for (const BoneCapsule& capsule : bones_) {
    const Vec3 from = pose.row(capsule.from), to = pose.row(capsule.to);
    Vec3 axis = to - from;
    axis = axis.norm() > 1e-9 ? axis.normalized() : Vec3::UnitY();
    const Vec3 side = (std::abs(axis.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX()).cross(axis).normalized();
    const Vec3 other = axis.cross(side);
    put(from, -axis, capsule.radius);
    for (const Ring& ring : the_rings) {
      const Vec3 centre = from + ring.along * (to - from);
      for (const auto& [c, s] : the_circle)
        put(centre, ring.width * (c * side + s * other) + ring.beyond * axis, capsule.radius);
    }
    put(to, axis, capsule.radius);
  }
}

void CapsuleSurface::place(const Pose& pose, double girth, double inflation_m,
                           std::span<float> points) const {
  std::size_t next = 0;
  visit(pose, [&](const Vec3& centre, const Vec3& out, double radius) {
    const Vec3 point = centre + (girth * radius + inflation_m) * out;
    for (int c = 0; c < 3; ++c) points[next++] = static_cast<float>(point[c]);
  });
}

void CapsuleSurface::place_normals(const Pose& pose, std::span<float> normals) const {
  std::size_t next = 0;
  visit(pose, [&](const Vec3&, const Vec3& out, double) {
    for (int c = 0; c < 3; ++c) normals[next++] = static_cast<float>(out[c]);
  });
}

}  // namespace abrazo::widgets
