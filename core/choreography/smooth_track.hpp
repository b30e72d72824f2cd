#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace abrazo {

/// A value over time from evenly spaced control values: uniform cubic B-spline, so position, velocity and
/// acceleration are continuous and the value stays within the range of the four controls around it (it does
/// not pass through them). Constant before the first and after the last control.
template <typename Value>
class SmoothTrack {
 public:
  /// @param controls  at least one
  SmoothTrack(double first_time, double spacing, std::vector<Value> controls)
      : first_time_(first_time), spacing_(spacing), controls_(std::move(controls)) {}

  Value at(double time) const {
    const double place = (time - first_time_) / spacing_;
    const double whole = std::floor(place);
    const double u = place - whole, v = 1 - u;
    const auto i = static_cast<std::ptrdiff_t>(whole);
    return (v * v * v * control(i - 1) + (3 * u * u * u - 6 * u * u + 4) * control(i) +
            (3 * v * v * v - 6 * v * v + 4) * control(i + 1) + u * u * u * control(i + 2)) /
           6;
  }

 private:
  const Value& control(std::ptrdiff_t i) const {
    const auto last = static_cast<std::ptrdiff_t>(controls_.size()) - 1;
    return controls_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
  }

  double first_time_;
  double spacing_;
  std::vector<Value> controls_;
};

/// From 0 at u <= 0 to 1 at u >= 1 with minimum jerk: velocity and acceleration are 0 at both ends.
inline double minimum_jerk(double u) {
  const double t = std::clamp(u, 0.0, 1.0);
  return t * t * t * (10 + t * (6 * t - 15));
}

/// 0 outside (0, 1), 1 at 1/2; velocity and acceleration are 0 at both ends.
inline double smooth_bump(double u) {
  if (u <= 0 || u >= 1) return 0;
  const double half = 4 * u * (1 - u);
  return half * half * half;
}

}  // namespace abrazo
