#pragma once

#include <vector>

#include "core/mesh/interaction_mesh.hpp"

namespace abrazo::test {

/// Delaunay tetrahedra of a pair by CGAL, which shares nothing with TetGen: vertices of each ascending, and
/// they ascending. Points in general position have one Delaunay tetrahedralisation, so both find the same.
std::vector<MeshTetrahedron> cgal_tetrahedra(const PairPose& pair);

/// The same form of others' tetrahedra.
std::vector<MeshTetrahedron> in_ascending_order(std::vector<MeshTetrahedron> tetrahedra);

/// No vertex lies inside a tetrahedron's circumsphere, and the tetrahedra fill the hull: decided by CGAL's
/// exact predicates. What two tetrahedralisations that differ must both be: where five joints lie on one
/// sphere there are several.
bool is_delaunay(const PairPose& pair, const std::vector<MeshTetrahedron>& tetrahedra);

}  // namespace abrazo::test
