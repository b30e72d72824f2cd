#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/positions.hpp"

namespace abrazo::widgets {

/// Two lights that move with the camera, and the brightness of a body under them (Phong's model). Computed
/// per vertex and interpolated, because per-pixel lighting dominates the cost of a body in a software
/// renderer.
class BodyLight {
 public:
  /// @param direction of view, unit length; the world's up is up in the picture
  explicit BodyLight(const Vec3& direction) : towards_eye_(-direction.cast<float>()) {
    const Eigen::Vector3f ahead = direction.cast<float>();
    Eigen::Vector3f right = ahead.cross(Eigen::Vector3f::UnitY());
    right = right.norm() > 1e-4F ? right.normalized() : Eigen::Vector3f::UnitX();
    const Eigen::Vector3f up = right.cross(ahead);
    const auto placed = [&](float x, float y, float z) {
      return (x * right + y * up - z * ahead).normalized();
    };
    lamps_ = {{{placed(-0.7F, 0.9F, 1.0F), 0.85F}, {placed(0.9F, 0.1F, 0.8F), 0.28F}}};
  }

  /// Share of the surface colour, 0.42 in the shade.
  /// @param normal  outwards, unit length
  float on(const Eigen::Vector3f& normal) const {
    float brightness = 0.42F;
    for (const Lamp& lamp : lamps_) {
      const float facing = normal.dot(lamp.direction);
      if (facing <= 0) continue;
      const float mirrored = std::max(0.0F, (2 * facing * normal - lamp.direction).dot(towards_eye_));
      brightness += lamp.intensity * (0.62F * facing + 0.12F * power_18(mirrored));
    }
    return brightness;
  }

 private:
  struct Lamp {
    Eigen::Vector3f direction;  ///< towards the light
    float intensity;
  };
  static float power_18(float value) {
    const float sq = value * value, fourth = sq * sq, eighth = fourth * fourth;
    return eighth * eighth * sq;
  }

  Eigen::Vector3f towards_eye_;
  std::array<Lamp, 2> lamps_;
};

}  // namespace abrazo::widgets
