#pragma once

#include "core/library/store/hdf5_file.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

// The tables of docs/library-file.md without the attributes of the format. Both directions throw Hdf5Problem.

inline constexpr const char* library_format_name = "abrazo motion library";
inline constexpr int library_format_version = 1;

// Rows are copied between file and memory without conversion.
static_assert(sizeof(PairPose) == 3 * pair_vertex_count * sizeof(double));
static_assert(sizeof(Features) == 15 * sizeof(double));
static_assert(sizeof(RootFrame) == 4 * sizeof(double));
static_assert(sizeof(MeshEdge) == 2 && sizeof(MeshTetrahedron) == 4);

/// Takes, roles, labels and bodies.
void write_descriptions(Hdf5Writer& writer, const LibraryColumns& columns);
/// Poses and meshes: nearly all of the file.
void write_pairs(Hdf5Writer& writer, const LibraryColumns& columns);

/// Does not check the consistency of columns; MotionLibrary does.
/// @param largest_in_memory_bytes above it, poses and meshes become views of the file
LibraryColumns read_library_tables(const Hdf5Reader& reader, std::uint64_t largest_in_memory_bytes);

}  // namespace abrazo
