#pragma once

#include <limits>
#include <vector>

#include "core/mesh/interaction_mesh.hpp"
#include "widgets/common/selection.hpp"

namespace abrazo::widgets {

/// Which edges and cells of the interaction mesh are shown, beside the switches for between and within
/// bodies.
struct MeshFilter {
  static constexpr double no_limit = std::numeric_limits<double>::infinity();
  double shortest_m = 0;
  double longest_m = no_limit;
  Selection isolated;             ///< only what meets at its joints, or what it is itself; nothing for all
  std::vector<Selection> hidden;  ///< what meets at their joints, or what they are themselves

  bool operator==(const MeshFilter&) const = default;
  bool is_open() const { return *this == MeshFilter{}; }
  bool passes(const PairPose& pair, const MeshEdge& edge) const;
  /// A cell passes when every edge has a length that does, and when it belongs to what is isolated.
  bool passes(const PairPose& pair, const MeshTetrahedron& cell) const;
};

}  // namespace abrazo::widgets
