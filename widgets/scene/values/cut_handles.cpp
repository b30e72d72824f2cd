#include "widgets/scene/values/cut_handles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace abrazo::widgets {
namespace {

constexpr double half_outline_m = 0.9, shaft_m = 0.45;
constexpr double knob_px = 11, line_px = 6;  ///< within which a handle is held
/// Share of its length that the normal has in the picture: below the least its direction there says nothing,
/// from the full one on a pixel moves the plane by two pixels at most.
constexpr double least_share = 0.2, full_share = 0.5;

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

/// How far what is held follows the pointer, from 0 (the normal faces the eye) to 1, smoothly.
double share_followed(double share) {
  const double part = std::clamp((share - least_share) / (full_share - least_share), 0.0, 1.0);
  return part * part * (3 - 2 * part);
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
  if (!middle) return 0;
  const Vec3& normal = plane_.normal;
  const auto from = projection_.ray(from_x, from_y), to = projection_.ray(to_x, to_y),
             below = projection_.ray(from_x, from_y + 1);
  const double slope = normal.dot(from.along);
  Vec3 held = plane_.point;  // on the shaft; else on the outline, in the plane
  if (distance_px(middle, knob, from_x, from_y) > line_px && std::abs(slope) > least_share)
    held = from.from + (plane_.point - from.from).dot(normal) / slope * from.along;
  const auto shown = projection_.project(held);
  const double pixel_m = 1 / projection_.pixels_per_metre(shown ? shown->depth_m : middle->depth_m);

  // What is held moves along a line through it: where that passes nearest to the pointer's ray, it is.
  // Towards the vanishing point of that line it would run away from the hand.
  const auto nearest_m = [&](const PictureProjection::Ray& ray) {
    const double along = normal.dot(ray.along);
    const Vec3 offset = ray.from - held;
    return (normal.dot(offset) - along * ray.along.dot(offset)) / std::max(1 - along * along, 1e-9);
  };
  const double most_m = std::hypot(to_x - from_x, to_y - from_y) * pixel_m / full_share;
  const double followed_m = std::clamp(nearest_m(to) - nearest_m(from), -most_m, most_m);

  // The vertical part of the drag has the sense in which what is held moves in the picture, so that both ways
  // never cancel; where it moves neither up nor down, downwards is nearer to the eye.
  constexpr double least_fall = 0.1;
  const double fall = normal.dot((below.from + below.along - from.from - from.along).normalized());
  const double sense = std::abs(fall) > least_fall ? fall : -slope;
  const double vertical_m = std::copysign(1.0, sense) * (to_y - from_y) * pixel_m;
  const double share = share_followed(std::sqrt(std::max(0.0, 1 - slope * slope)));
  return share * followed_m + (1 - share) * vertical_m;
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
