#pragma once

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// The library with one more take appended: existing pairs are copied, only the new pairs are built. Pair
/// numbers stay. The result is identical to the bit to a build with that take last in the manifest, with one
/// exception: known performers keep their capsule radii, because the takes of their calibration are not
/// available; a new performer is calibrated on this take only.
/// @param options of the library's build; no takes are excluded
/// @return an Error if the library has a take of this name, or for the same reasons as in a build
Result<MotionLibrary> extend_library(const MotionLibrary& library, PairedTake take,
                                     const LibraryBuildOptions& options, const Progress& progress);

}  // namespace abrazo
