#pragma once

#include <span>

#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Maximum number of tetrahedra of a Delaunay tetrahedralisation of 50 points.
inline constexpr std::size_t most_tetrahedra = pair_vertex_count * (pair_vertex_count - 3) / 2;

/// Upper bound of the norm of all coordinates of a pair [m]: beyond it, costs (sums of squares) could no
/// longer distinguish pairs, or overflow.
inline constexpr double farthest_m = 1e8;

// Checks of one row, in nanoseconds: repeated whenever a mapped row is used.

/// False if a coordinate is NaN.
bool is_within_reach(const PairPose& pose);
/// Whether edges have the smaller vertex first, ascend, are unique and refer to joints, as the solver's
/// neighbour tables require.
bool is_in_order(std::span<const MeshEdge> edges);
bool names_vertices(std::span<const MeshTetrahedron> tetrahedra);

/// Checks that columns are consistent. Skips poses and meshes of a mapped file: RowGuard checks each row on
/// use, so that opening does not read a file larger than memory.
/// @throws std::invalid_argument with the inconsistency
void check_columns(const LibraryColumns& columns);

}  // namespace abrazo
