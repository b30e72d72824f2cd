#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo {

/// Output files of a build; empty = not written.
struct BuildFiles {
  std::filesystem::path library;   ///< HDF5
  std::filesystem::path manifest;  ///< JSON that builds the same library again
};

/// Builds the library of a manifest and writes the requested files: all of them, or none after an error or
/// cancellation.
/// @param warnings warnings of the readers
Result<MotionLibrary> build_and_save(const Manifest& manifest, const BuildFiles& files,
                                     const Progress& progress, std::vector<std::string>& warnings);

}  // namespace abrazo
