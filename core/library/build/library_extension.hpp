#pragma once

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// The library with one more take at its end: what is there is copied, only the new pairs are made. Pair
/// numbers stay. The same to the bit as building it with that take last in the manifest, but for one thing:
/// performers whom the library knows already keep the capsule radii that it has, since the takes they were
/// calibrated on are not at hand; and so a new performer who dances with a known one is calibrated on this
/// take alone.
/// @param options  those that the library was built with; no takes are excluded
/// @return an Error when the library has a take of this name, or the take is refused as when building
Result<MotionLibrary> extend_library(const MotionLibrary& library, PairedTake take,
                                     const LibraryBuildOptions& options, const Progress& progress);

}  // namespace abrazo
