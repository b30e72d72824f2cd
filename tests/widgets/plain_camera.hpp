#pragma once

#include <cmath>

#include "widgets/scene/values/orbit_camera.hpp"

namespace abrazo::test {

/// From +Z at the origin, five metres away, half the picture 1 m high at the origin.
inline widgets::OrbitCamera plain_camera() {
  widgets::OrbitCamera camera;
  camera.target = Vec3::Zero();
  camera.azimuth_rad = camera.elevation_rad = 0;
  camera.distance_m = 5;
  camera.view_angle_rad = 2 * std::atan(1 / 5.0);
  return camera;
}

}  // namespace abrazo::test
