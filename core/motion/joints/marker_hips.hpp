#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/joints/functional_centre.hpp"
#include "core/motion/joints/marker_set.hpp"

namespace abrazo {

/// Hip joint centres, left and right, in `pelvis_axes` from the middle between the front markers [m].
struct HipCentres {
  std::array<Vec3, 2> places;
  std::array<std::optional<FunctionalCentre>, 2> functional;  ///< of those found from the motion
  std::array<double, 2> from_regression_m{};                  ///< how far those are from the regression's

  /// What was found from the motion, with its figures, for a warning; empty: both by the regression.
  std::string words() const;
};

/// By the motion of the markers on the thighs where that tells them well (functional_centre) and they are
/// within 4 cm of the regression's place, else by Harrington's regression.
/// @param pelvis_width_m, pelvis_depth_m  between the front markers; from their middle to that of the back
HipCentres hip_centres(const MarkerSet& set, const std::vector<Positions>& frames, double metres_per_unit,
                       double pelvis_width_m, double pelvis_depth_m);

/// Middle of the markers at the back of the pelvis, or the sacrum.
Vec3 pelvis_back(const MarkerSet& set, const Positions& frame);

}  // namespace abrazo
