#pragma once

#include <algorithm>

#include "core/mesh/interaction_mesh.hpp"

namespace abrazo {

/// The vertex of the same joint on the pair's other body.
template <typename Vertex>
constexpr Vertex vertex_of_other_body(Vertex vertex) {
  return static_cast<Vertex>((vertex + joint_count) % pair_vertex_count);
}

/// An edge with the bodies exchanged; the lower vertex is first, as in every mesh.
constexpr MeshEdge edge_of_other_body(const MeshEdge& edge) {
  const auto a = vertex_of_other_body(edge[0]), b = vertex_of_other_body(edge[1]);
  return {std::min(a, b), std::max(a, b)};
}

/// The same for a tetrahedron; its vertices keep their order.
constexpr MeshTetrahedron tetrahedron_of_other_body(MeshTetrahedron tetrahedron) {
  for (auto& vertex : tetrahedron) vertex = vertex_of_other_body(vertex);
  return tetrahedron;
}

}  // namespace abrazo
