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

double CutHandles::moved_m(double from_x, double from_y, double to_x, double to_y) const {
  constexpr double little_m = 0.01;
  const auto ahead = projection_.project(plane_.point + little_m * plane_.normal);
  if (!middle || !ahead) return 0;
  const double scale = projection_.pixels_per_metre(middle->depth_m);
  const Eigen::Vector2d along = Eigen::Vector2d(ahead->x - middle->x, ahead->y - middle->y) / little_m;
  const Eigen::Vector2d drag(to_x - from_x, to_y - from_y);
  if (along.norm() >= least_share * scale) return drag.dot(along) / along.squaredNorm();
  return (ahead->depth_m < middle->depth_m ? drag.y() : -drag.y()) / scale;
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
