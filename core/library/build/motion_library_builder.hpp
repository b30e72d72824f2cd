#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo {

struct LibraryBuildOptions {
  std::vector<std::string> excluded_takes;
  std::optional<double> rate_hz;  ///< thin to about this rate (whole strides); none = every frame
  /// Makes either performer active in every frame, regardless of the annotated roles (the library doubles):
  /// for a user who alternates between attack and defence. The annotation stays in PairSource::annotated.
  bool both_roles = false;
};

/// Normalises, computes features and tetrahedralises every pair of the takes (paper 3.2, 3.4.1). A frame with
/// unknown active performer becomes two pairs (the library doubles, 3.2.1). Uses all processor cores; the
/// result does not depend on their number. @return an Error "cancelled" if `progress` cancels
Result<MotionLibrary> build_library(std::string name, std::vector<PairedTake> takes,
                                    const LibraryBuildOptions& options, const Progress& progress);

/// Whether the pairs of every take come at the rate of the library, within 1 %.
bool has_one_rate(const MotionLibrary& library);

/// Reads a manifest and all its takes, and builds. An excluded take that does not exist is an error that
/// lists the names.
/// @param warnings warnings of the readers
Result<MotionLibrary> build_library(const Manifest& manifest, const LibraryBuildOptions& options,
                                    const Progress& progress, std::vector<std::string>& warnings);

}  // namespace abrazo
