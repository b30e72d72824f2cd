#pragma once

#include <vector>

#include "core/mesh/interaction_mesh.hpp"

namespace abrazo::bench {

/// TetGen's Delaunay tetrahedra of a pair, called as its manual does, without what ours does for degenerate
/// poses. One call at a time, and none of ours beside it.
std::vector<MeshTetrahedron> tetgen_tetrahedra(const PairPose& pose);

}  // namespace abrazo::bench
