#pragma once

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

}  // namespace abrazo::widgets
