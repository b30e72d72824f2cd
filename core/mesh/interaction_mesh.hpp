#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// Two vertices of a pair, smaller index first. Vertex = active joint 0..24, passive joint 25..49.
using MeshEdge = std::array<std::uint8_t, 2>;
/// Four vertices of a pair.
using MeshTetrahedron = std::array<std::uint8_t, 4>;

/// Neighbourhood of the joints of two bodies: the Delaunay tetrahedralisation of one pair's 50 joints (paper
/// 3.4.1). Topology only; positions and weights belong to the pose it is used with.
struct InteractionMesh {
  std::vector<MeshEdge> edges;  ///< unique, ascending; every bone of both bodies is among them
  std::vector<MeshTetrahedron> tetrahedra;

  /// Treatment of a degenerate point set; Exact for nearly every captured pair.
  enum class Quality : std::uint8_t { Exact, Jittered, NearestNeighbours } quality = Quality::Exact;
};

inline bool is_inter_body(const MeshEdge& edge) {
  return edge[0] < joint_count && edge[1] >= joint_count;
}

/// Delaunay tetrahedralisation of a pair. Points closer than 1 mm are moved apart by a jitter of 1e-5 m that
/// depends only on their index; if no tetrahedralisation exists (all points in a plane), the union of the 8
/// nearest neighbours is used instead. Bone edges are always added. Never fails for finite input.
InteractionMesh tetrahedralize(const PairPose& pair);

/// Six times the signed volume of a tetrahedron [m^3].
double six_volumes(const PairPose& pair, const MeshTetrahedron& tetrahedron);

}  // namespace abrazo
