#pragma once

#include "core/library/store/hdf5_file.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

// The tables of docs/library-file.md, apart from the format's attributes. Both throw Hdf5Problem.

inline constexpr const char* library_format_name = "abrazo motion library";
inline constexpr int library_format_version = 1;

// Rows are copied between file and memory as they are.
static_assert(sizeof(PairPose) == 3 * pair_vertex_count * sizeof(double));
static_assert(sizeof(Features) == 15 * sizeof(double));
static_assert(sizeof(RootFrame) == 4 * sizeof(double));
static_assert(sizeof(MeshEdge) == 2 && sizeof(MeshTetrahedron) == 4);

/// Takes, roles, labels and bodies.
void write_descriptions(Hdf5Writer& writer, const LibraryColumns& columns);
/// Poses and meshes: nearly all of the file.
void write_pairs(Hdf5Writer& writer, const LibraryColumns& columns);

/// Whether the columns fit together is for MotionLibrary to say.
/// @param largest_in_memory_bytes  poses and meshes that are more become views of the file
LibraryColumns read_library_tables(const Hdf5Reader& reader, std::uint64_t largest_in_memory_bytes);

}  // namespace abrazo
