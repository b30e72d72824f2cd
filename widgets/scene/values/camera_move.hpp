#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "widgets/scene/values/orbit_camera.hpp"

namespace abrazo::widgets {

/// An animated camera move to another view, the shorter way around. Independent of Qt and VTK.
struct CameraMove {
  static constexpr double duration_s = 0.2;
  OrbitCamera from, to;

  bool is_over(double elapsed_s) const { return elapsed_s >= duration_s; }
  /// Eases in and out; exactly `to` at the end. Cutting planes are unchanged.
  void apply(OrbitCamera& camera, double elapsed_s) const {
    const double t = std::clamp(elapsed_s / duration_s, 0.0, 1.0), share = t * t * (3 - 2 * t);
    const auto between = [share](double a, double b) { return share < 1 ? a + share * (b - a) : b; };
    for (int axis = 0; axis < 3; ++axis) camera.target[axis] = between(from.target[axis], to.target[axis]);
    const double turn = std::remainder(to.azimuth_rad - from.azimuth_rad, 2 * 3.14159265358979323846);
    camera.azimuth_rad = share < 1 ? from.azimuth_rad + share * turn : to.azimuth_rad;
    camera.elevation_rad = between(from.elevation_rad, to.elevation_rad);
    camera.distance_m = between(from.distance_m, to.distance_m);
  }
};

/// History of views for going back. Separate from undo, because camera moves are not edits.
class CameraHistory {
 public:
  static constexpr std::size_t most_views = 64;

  /// Call before the camera leaves `view`. Equal successive views count once.
  void leave(const OrbitCamera& view) {
    next_.clear();
    if (!earlier_.empty() && earlier_.back() == view) return;
    earlier_.push_back(view);
    if (earlier_.size() > most_views) earlier_.erase(earlier_.begin());
  }
  /// @param now the present view. @return none if there is no earlier view
  std::optional<OrbitCamera> back(const OrbitCamera& now) { return step(earlier_, next_, now); }
  std::optional<OrbitCamera> forth(const OrbitCamera& now) { return step(next_, earlier_, now); }

 private:
  using Views = std::vector<OrbitCamera>;
  static std::optional<OrbitCamera> step(Views& from, Views& to, const OrbitCamera& now) {
    while (!from.empty() && from.back() == now) from.pop_back();
    if (from.empty()) return std::nullopt;
    to.push_back(now);
    const OrbitCamera view = from.back();
    from.pop_back();
    return view;
  }

  Views earlier_, next_;
};

}  // namespace abrazo::widgets
