#pragma once

#include <optional>

#include "core/base/progress.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Typical distance of a library's pairs in feature space [m]: median, over at most `samples` evenly spread
/// pairs, of the distance to the nearest pair that is not within one second in the same take. A user's pose
/// nearer than that to some pair is covered as well as the library's own poses.
/// @return none if no pair has another to compare with, or `progress` cancels
std::optional<double> typical_neighbour_distance(const MotionLibrary& library, int samples = 400,
                                                 const Progress& progress = {});

}  // namespace abrazo
