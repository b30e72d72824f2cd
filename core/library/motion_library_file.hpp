#pragma once

#include <filesystem>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/motion_library.hpp"

namespace abrazo {

/// Writes a library as HDF5 (layout: docs/library-file.md), whole or not at all.
Status write_library(const MotionLibrary& library, const std::filesystem::path& file,
                     const Progress& progress = {});

/// Reads it back. Refuses what is not such a file, is of a newer version, cut short, or inconsistent, and
/// says which.
Result<MotionLibrary> read_library(const std::filesystem::path& file);

}  // namespace abrazo
