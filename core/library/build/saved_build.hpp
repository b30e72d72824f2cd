#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo {

/// Where a build is written to; empty = not written.
struct BuildFiles {
  std::filesystem::path library;   ///< HDF5
  std::filesystem::path manifest;  ///< JSON that builds the same library again
};

/// Builds the library of a manifest and writes what is wanted of it: all of it or, after an error or when
/// `progress` says stop, none.
/// @param warnings  what the readers found odd
Result<MotionLibrary> build_and_save(const Manifest& manifest, const BuildFiles& files,
                                     const Progress& progress, std::vector<std::string>& warnings);

}  // namespace abrazo
