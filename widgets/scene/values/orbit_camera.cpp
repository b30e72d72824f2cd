#include "widgets/scene/values/orbit_camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

constexpr double radians_per_pixel = 0.0075;
constexpr double nearest_m = 0.3, farthest_camera_m = 40;
constexpr double steepest_rad = 1.55;  // just short of the pole, where "up" would be undefined

}  // namespace

Vec3 OrbitCamera::position() const {
  return focus() + distance_m * direction_of(azimuth_rad, elevation_rad);
}

bool OrbitCamera::operator==(const OrbitCamera& o) const {
  return target == o.target && azimuth_rad == o.azimuth_rad && elevation_rad == o.elevation_rad &&
         distance_m == o.distance_m && is_parallel == o.is_parallel && shift_m == o.shift_m;
}

Vec3 OrbitCamera::right() const {
  return {std::cos(azimuth_rad), 0, -std::sin(azimuth_rad)};
}

Vec3 OrbitCamera::up() const {
  return direction_of(azimuth_rad, elevation_rad).cross(right());
}

double OrbitCamera::nearest_shown_m() const {
  constexpr double at_the_lens_m = 0.08;
  return cuts ? std::max(at_the_lens_m, distance_m - cut_m) : at_the_lens_m;
}

void OrbitCamera::orbit(double dx_px, double dy_px) {
  azimuth_rad = std::remainder(azimuth_rad - dx_px * radians_per_pixel, 2 * 3.14159265358979323846);
  elevation_rad = std::clamp(elevation_rad + dy_px * radians_per_pixel, -steepest_rad, steepest_rad);
}

void OrbitCamera::pan(double dx_px, double dy_px, double view_height_px) {
  const double metres_per_pixel =
      2 * distance_m * std::tan(view_angle_rad / 2) / std::max(view_height_px, 1.0);
  target += metres_per_pixel * (dy_px * up() - dx_px * right());
}

void OrbitCamera::zoom(double notches) {
  distance_m = std::clamp(distance_m * std::pow(0.88, notches), nearest_m, farthest_camera_m);
}

double OrbitCamera::distance_for(const Positions& points, const PictureShape& picture) const {
  constexpr double flesh_m = 0.14, used_width = 0.84;
  const double slope = std::tan(view_angle_rad / 2);
  const double half_height = picture.used_height * slope, half_width = used_width * picture.aspect * slope;
  const Vec3 back = direction_of(azimuth_rad, elevation_rad), across = right(), upwards = up();
  double distance = 0;
  for (Eigen::Index p = 0; p < points.rows(); ++p) {
    const Vec3 offset = points.row(p).transpose() - target;
    const double high = (std::abs(offset.dot(upwards)) + flesh_m) / half_height;
    const double wide = (std::abs(offset.dot(across)) + std::abs(shift_m) + flesh_m) / half_width;
    distance = std::max(distance, offset.dot(back) + std::max(high, wide));
  }
  return std::clamp(distance, nearest_m, farthest_camera_m);
}

}  // namespace abrazo::widgets
