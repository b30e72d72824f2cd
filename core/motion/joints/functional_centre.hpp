#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// The point about which the markers of a segment turn.
struct FunctionalCentre {
  Vec3 centre = Vec3::Zero();     ///< in the axes of the trajectories [m]
  std::array<double, 2> range{};  ///< rad, of the segment's direction, 5th to 95th percentile: the widest,
                                  ///< and across it
  double noise_m = 0;             ///< standard deviation of the markers' distances from the centre
  double expected_error_m = 0;    ///< standard error of the centre, from noise, range and distinct directions
};

/// Least squares for the common centre of the spheres on which markers move, with a radius for each: Gamage
/// and Lasenby, J. Biomech. 35 (2002) 87-93, without its bias towards the markers: Halvorsen, J. Biomech. 36
/// (2003) 999-1008.
/// @param trajectories  for each marker frames x 3 [m], in axes in which the centre rests; as many frames
/// each
/// @return nothing where the markers move in one plane or hardly at all, so that no centre is determined
std::optional<FunctionalCentre> functional_centre(const std::vector<Positions>& trajectories);

/// Whether the motion tells the centre better than a regression on the size of the body, whose error is some
/// 7 mm: 40 degrees one way and 20 across at least (Ehrig et al., J. Biomech. 39 (2006) 2798-2809, find the
/// error of all such methods to grow steeply below 20), and an expected error below 7 mm.
bool is_better_than_regression(const FunctionalCentre& found);

}  // namespace abrazo
