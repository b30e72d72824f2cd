#include "widgets/scene/values/cut_handles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace abrazo::widgets {
namespace {

constexpr double half_outline_m = 0.9, shaft_m = 0.45;
constexpr double knob_px = 11, line_px = 6;  ///< within which a handle is held
/// Share of its length that the normal has in the picture, below which its direction there says nothing.
constexpr double least_share = 0.2;

/// The cutting plane hides no handle.
OrbitCamera uncut(OrbitCamera camera) {
  camera.plane.reset();
  camera.cuts = false;
  return camera;
}

double distance_px(const std::optional<PicturePoint>& a, const std::optional<PicturePoint>& b, double x,
                   double y) {
  if (!a || !b) return std::numeric_limits<double>::infinity();
  const Eigen::Vector2d from(a->x, a->y), along(b->x - a->x, b->y - a->y), place(x, y);
  const double share = std::clamp((place - from).dot(along) / std::max(along.squaredNorm(), 1e-9), 0.0, 1.0);
  return (place - from - share * along).norm();
}

}  // namespace

std::array<Vec3, 4> outline_of(const CutPlane& plane) {
  const bool is_level = std::abs(plane.normal.y()) > 0.99;
  const Vec3 across = (is_level ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY().cross(plane.normal))).normalized();
  const Vec3 upwards = plane.normal.cross(across);
  std::array<Vec3, 4> corners;
  constexpr std::array<std::array<double, 2>, 4> signs = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t c = 0; c < corners.size(); ++c)
    corners[c] = plane.point + half_outline_m * (signs[c][0] * across + signs[c][1] * upwards);
  return corners;
}

CutHandles::CutHandles(const CutPlane& plane, const OrbitCamera& camera, double width_px, double height_px)
    : plane_(plane), projection_(uncut(camera), width_px, height_px) {
  const auto corners = outline_of(plane);
  for (std::size_t c = 0; c < corners.size(); ++c) outline[c] = projection_.project(corners[c]);
  middle = projection_.project(plane.point);
  knob = projection_.project(plane.point + shaft_m * plane.normal);
}

CutGrip CutHandles::at(double x, double y) const {
  if (knob && std::hypot(knob->x - x, knob->y - y) <= knob_px) return CutGrip::Turn;
  if (distance_px(middle, knob, x, y) <= line_px) return CutGrip::Move;
  for (std::size_t c = 0; c < outline.size(); ++c)
    if (distance_px(outline[c], outline[(c + 1) % outline.size()], x, y) <= line_px) return CutGrip::Move;
  return CutGrip::None;
}

/// What is held moves along a line through it: where that passes nearest to the pointer's ray, it is.
double CutHandles::moved_m(double from_x, double from_y, double to_x, double to_y) const {
  if (!middle) return 0;
  const Vec3& normal = plane_.normal;
  const auto from = projection_.ray(from_x, from_y), to = projection_.ray(to_x, to_y);
  const double slope = normal.dot(from.along);
  if (1 - slope * slope < least_share * least_share) {
    const double by_m = (to_y - from_y) / projection_.pixels_per_metre(middle->depth_m);
    return slope < 0 ? by_m : -by_m;
  }
  Vec3 held = plane_.point;  // on the shaft; else on the outline, in the plane
  if (distance_px(middle, knob, from_x, from_y) > line_px && std::abs(slope) > least_share)
    held = from.from + (plane_.point - from.from).dot(normal) / slope * from.along;
  const auto nearest_m = [&](const PictureProjection::Ray& ray) {
    const double along = normal.dot(ray.along);
    const Vec3 offset = ray.from - held;
    return (normal.dot(offset) - along * ray.along.dot(offset)) / (1 - along * along);
  };
  return nearest_m(to) - nearest_m(from);
}

Vec3 CutHandles::turned(double x, double y) const {
  const auto [eye, forward] = projection_.ray(x, y);
  const Vec3 offset = eye - plane_.point;
  const double nearest = -offset.dot(forward);
  const Vec3 closest = offset + nearest * forward;  // of the ray to the point, from there
  const double within = shaft_m * shaft_m - closest.squaredNorm();
  if (within <= 0) return closest.normalized();
  const Vec3 before = closest - std::sqrt(within) * forward, behind = closest + std::sqrt(within) * forward;
  const bool stays_before = before.dot(plane_.normal) >= behind.dot(plane_.normal);
  return (stays_before ? before : behind).normalized();
}

}  // namespace abrazo::widgets
