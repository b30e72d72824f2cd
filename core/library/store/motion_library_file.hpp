#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Writes a library as HDF5 (layout: docs/library-file.md), whole or not at all.
Status write_library(const MotionLibrary& library, const std::filesystem::path& file,
                     const Progress& progress = {});

struct LibraryReading {
  /// Poses and meshes that are more than this stay in the file and are mapped: some 370 000 pairs.
  std::uint64_t largest_in_memory_bytes = std::uint64_t{1} << 30;
};

/// Reads it back. Refuses what is not such a file, is of a newer version, cut short, or inconsistent, and
/// says which. Of a large library only what every pair needs is read; its poses and meshes are looked at
/// when they are used (MotionLibrary::damage).
Result<MotionLibrary> read_library(const std::filesystem::path& file, const LibraryReading& reading = {});

/// How much of a library stays in its file, read as it is used; 0 when all is in memory.
std::uint64_t mapped_bytes(const MotionLibrary& library);

}  // namespace abrazo
