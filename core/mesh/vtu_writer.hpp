#pragma once

#include <span>
#include <string>

#include "core/mesh/interaction_mesh.hpp"

namespace abrazo {

/// The interaction mesh of one solved frame, for writing. Refers to values that must outlive it.
struct MeshFrame {
  double time_s = 0;
  const PairPose& positions;  ///< vertices of the result, world [m]
  const PairPose& reference;  ///< vertices of the selected pair, which defines the mesh, world [m]
  std::span<const MeshEdge> edges;
  std::span<const MeshTetrahedron> tetrahedra;
  std::span<const double> edge_weights;      ///< per edge
  std::span<const double> edge_residuals_m;  ///< per edge
};

/// VTK's XML file of an unstructured grid: the 50 joints, one tetrahedron (VTK type 10) per tetrahedron of
/// the mesh and one line (3) per edge, in this order.
///   points: body (0 active, 1 passive), joint (0..24), displacement [m] from the reference
///   cells:  kind (0 tetrahedron, 1 edge), inter_body (0, 1: joins the two bodies), and
///           edges: weight, residual [m], length [m], length_change [m] from the reference
///           tetrahedra: volume [m^3, signed], volume_ratio to that in the reference
/// Fields that a cell does not have are NaN. Numbers read back to the same doubles.
/// @throws std::invalid_argument if the numbers of weights, residuals and edges differ
std::string write_vtu(const MeshFrame& frame);

/// One file of a series.
struct SeriesFile {
  double time_s = 0;
  std::string name;  ///< relative to the collection
};

/// VTK's collection of files over time for ParaView (.pvd).
std::string write_pvd(std::span<const SeriesFile> files);

}  // namespace abrazo
