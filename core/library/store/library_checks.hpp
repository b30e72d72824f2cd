#pragma once

#include <span>

#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// What a Delaunay tetrahedralisation of so many points has at most.
inline constexpr std::size_t most_tetrahedra = pair_vertex_count * (pair_vertex_count - 3) / 2;

/// A pair lies nearer to its origin than this [m], all its coordinates together: beyond it costs, which are
/// sums of squares, would no longer tell one pair from another, or be infinite.
inline constexpr double farthest_m = 1e8;

// Of one row, in nanoseconds: asked again whenever a mapped row is used.

/// Not so where a coordinate is no number.
bool is_within_reach(const PairPose& pose);
/// Smaller vertex first, ascending, none twice, all of them joints: what the solver's tables of neighbours
/// rely on.
bool is_in_order(std::span<const MeshEdge> edges);
bool names_vertices(std::span<const MeshTetrahedron> tetrahedra);

/// That columns fit together. Poses and meshes of a mapped file are left out: RowGuard looks at each when it
/// is used, so that opening does not read all of a file larger than memory.
/// @throws std::invalid_argument saying what does not fit
void check_columns(const LibraryColumns& columns);

}  // namespace abrazo
