#include "widgets/scene/orbit_camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

constexpr double radians_per_pixel = 0.0075;
constexpr double steepest_rad = 1.55;  // just short of the pole, where "up" would be undefined

}  // namespace

Vec3 OrbitCamera::position() const {
  const double level = std::cos(elevation_rad);
  return target + distance_m * Vec3(level * std::sin(azimuth_rad), std::sin(elevation_rad),
                                    level * std::cos(azimuth_rad));
}

Vec3 OrbitCamera::right() const {
  return {std::cos(azimuth_rad), 0, -std::sin(azimuth_rad)};
}

Vec3 OrbitCamera::up() const {
  return (position() - target).normalized().cross(right());
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
  distance_m = std::clamp(distance_m * std::pow(0.88, notches), 0.3, 40.0);
}

void OrbitCamera::frame(const Vec3& centre, double radius_m, double aspect) {
  target = centre;
  const double half_vertical = view_angle_rad / 2;
  const double half_horizontal = std::atan(std::tan(half_vertical) * aspect);
  distance_m = std::clamp(radius_m / std::sin(std::min(half_vertical, half_horizontal)), 0.3, 40.0);
}

}  // namespace abrazo::widgets
