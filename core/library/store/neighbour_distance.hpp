#pragma once

#include <optional>

#include "core/base/progress.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// How near a library's pairs lie to one another in feature space [m]: median, over at most `samples` pairs
/// evenly spread, of the distance to the nearest pair that is not within one second of it in the same take.
/// A user's pose nearer than that to some pair is as well covered as the library's own poses are.
/// @return nothing when no pair has another one to compare with, or `progress` says stop
std::optional<double> typical_neighbour_distance(const MotionLibrary& library, int samples = 400,
                                                 const Progress& progress = {});

}  // namespace abrazo
