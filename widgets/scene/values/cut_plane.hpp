#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/positions.hpp"

namespace abrazo::widgets {

/// A cutting plane fixed in the world; everything beyond it, along the normal, is clipped.
struct CutPlane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit

  bool leaves_out(const Vec3& world) const { return (world - point).dot(normal) > 0; }
};

/// Unit vector of a direction: azimuth about +Y from +Z, elevation above the horizon [rad].
inline Vec3 direction_of(double azimuth_rad, double elevation_rad) {
  const double level = std::cos(elevation_rad);
  return {level * std::sin(azimuth_rad), std::sin(elevation_rad), level * std::cos(azimuth_rad)};
}

/// Azimuth of the normal of a new upright plane [rad]. The plane stands as nearly along the line between the
/// bodies as it can while its normal is turned 40 to 60 degrees from the eye: a plane that faces the eye
/// shows neither its place nor how it moves.
/// @param between  from one body to the other [m]
inline double new_cut_azimuth(double eye_azimuth_rad, const Vec3& between) {
  constexpr double pi = 3.14159265358979323846, least_rad = pi / 4.5, most_rad = pi / 3;
  const double square_rad = std::atan2(between.z(), -between.x());
  const double turn_rad = std::remainder(square_rad - eye_azimuth_rad, pi);
  return std::remainder(
      eye_azimuth_rad + std::copysign(std::clamp(std::abs(turn_rad), least_rad, most_rad), turn_rad), 2 * pi);
}

}  // namespace abrazo::widgets
