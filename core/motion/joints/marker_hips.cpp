#include "core/motion/joints/marker_hips.hpp"

#include <fmt/format.h>

#include <numbers>

#include "core/motion/joints/marker_geometry.hpp"

namespace abrazo {

namespace {

using enum MarkerPlace;

constexpr double farthest_from_regression_m =
    0.04;  ///< farther, and the markers are not what they are called

/// The markers of a thigh in the pelvis's axes; the knee's first, as it tells the thigh's direction best.
std::vector<Positions> thigh_in_pelvis(const MarkerSet& set, std::size_t side,
                                       const std::vector<Positions>& frames, double metres_per_unit) {
  std::vector<int> markers;
  for (const MarkerPlace place : {Knee, KneeInner, Thigh})
    if (set.has(place, side)) markers.push_back(set.of(place, side));
  std::vector<Positions> trajectories(markers.size(), Positions(static_cast<Eigen::Index>(frames.size()), 3));
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const Positions& frame = frames[f];
    const Vec3 left = frame.row(set.of(PelvisFront, 0)).transpose(),
               right = frame.row(set.of(PelvisFront, 1)).transpose();
    const Eigen::Matrix3d axes = pelvis_axes(left, right, pelvis_back(set, frame));
    const Vec3 front = (left + right) / 2;
    for (std::size_t m = 0; m < markers.size(); ++m)
      trajectories[m].row(static_cast<Eigen::Index>(f)) =
          metres_per_unit * (frame.row(markers[m]) - front.transpose()) * axes;
  }
  return trajectories;
}

}  // namespace

Vec3 pelvis_back(const MarkerSet& set, const Positions& frame) {
  if (set.has_both(PelvisBack))
    return (frame.row(set.of(PelvisBack, 0)) + frame.row(set.of(PelvisBack, 1))).transpose() / 2;
  return frame.row(set.of(Sacrum, 0)).transpose();
}

HipCentres hip_centres(const MarkerSet& set, const std::vector<Positions>& frames, double metres_per_unit,
                       double pelvis_width_m, double pelvis_depth_m) {
  HipCentres hips;
  for (const std::size_t side : {0U, 1U}) {
    hips.places[side] = hip_centre(pelvis_width_m, pelvis_depth_m, side == 0 ? 1 : -1);
    const auto found = functional_centre(thigh_in_pelvis(set, side, frames, metres_per_unit));
    if (!found || !is_better_than_regression(*found)) continue;
    const double off_m = (found->centre - hips.places[side]).norm();
    if (off_m > farthest_from_regression_m) continue;
    hips.places[side] = found->centre;
    hips.functional[side] = found;
    hips.from_regression_m[side] = off_m;
  }
  return hips;
}

std::string HipCentres::words() const {
  std::string sides;
  int count = 0;
  constexpr double degrees = 180 / std::numbers::pi;
  for (const std::size_t side : {0U, 1U}) {
    if (!functional[side]) continue;
    ++count;
    sides += fmt::format(
        "{}{} (thigh over {:.0f} by {:.0f} degrees, expected error {:.1f} mm, {:.0f} mm from "
        "the regression)",
        sides.empty() ? "" : ", ", side == 0 ? "lhipjoint" : "rhipjoint",
        functional[side]->range[0] * degrees, functional[side]->range[1] * degrees,
        1000 * functional[side]->expected_error_m, 1000 * from_regression_m[side]);
  }
  if (count == 0) return {};
  return fmt::format("{} of the 2 hip joints {} found from the motion of the markers on the thigh: {}", count,
                     count == 1 ? "was" : "were", sides);
}

}  // namespace abrazo
