#pragma once

#include <limits>

#include "core/mesh/interaction_mesh.hpp"

namespace abrazo::widgets {

/// Which edges and cells of the interaction mesh are shown, beside the switches for between and within
/// bodies.
struct MeshFilter {
  static constexpr double no_limit = std::numeric_limits<double>::infinity();
  double shortest_m = 0;
  double longest_m = no_limit;
  int joint = -1;  ///< only what meets at this vertex of the pair; -1 for all

  bool operator==(const MeshFilter&) const = default;
  bool is_open() const { return *this == MeshFilter{}; }
  bool passes(const PairPose& pair, const MeshEdge& edge) const;
  /// A cell passes when every edge has a length that does, and when it has the joint.
  bool passes(const PairPose& pair, const MeshTetrahedron& cell) const;
};

}  // namespace abrazo::widgets
