#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Writes a library as HDF5 (layout: docs/library-file.md), all or nothing.
Status write_library(const MotionLibrary& library, const std::filesystem::path& file,
                     const Progress& progress = {});

struct LibraryReading {
  /// Above this size, poses and meshes stay in the file and are mapped: about 370 000 pairs.
  std::uint64_t largest_in_memory_bytes = std::uint64_t{1} << 30;
};

/// Reads a library file. An Error if it is not such a file, of a newer version, truncated or inconsistent.
/// Poses and meshes of a large library are not read here but checked on use (MotionLibrary::damage).
Result<MotionLibrary> read_library(const std::filesystem::path& file, const LibraryReading& reading = {});

/// Size of the part of a library that stays in its file; 0 if all is in memory.
std::uint64_t mapped_bytes(const MotionLibrary& library);

}  // namespace abrazo
