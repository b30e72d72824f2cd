#pragma once

#include <limits>
#include <vector>

#include "core/mesh/interaction_mesh.hpp"
#include "widgets/common/selection.hpp"

namespace abrazo::widgets {

/// What a filter of the coloured value may ask for, in any of the units.
inline constexpr double greatest_value = 1e4;

/// Filter of the shown edges and cells of the interaction mesh, in addition to the switches for between and
/// within bodies.
struct MeshFilter {
  static constexpr double no_limit = std::numeric_limits<double>::infinity();
  double shortest_m = 0;
  double longest_m = no_limit;
  Selection isolated;             ///< only this item, or items at its joints; empty = all
  std::vector<Selection> hidden;  ///< these items, or items at their joints
  /// Of the coloured value, without its sign, in the unit of its `scalar_info`; of edges only.
  double least_value = 0, most_value = no_limit;

  bool operator==(const MeshFilter&) const = default;
  bool is_open() const { return *this == MeshFilter{}; }
  bool passes(const PairPose& pair, const MeshEdge& edge) const;
  /// An edge without a value passes if nothing is asked of it.
  bool passes_value(double value) const;
  /// A cell passes if the length of every edge passes and it belongs to the isolated item.
  bool passes(const PairPose& pair, const MeshTetrahedron& cell) const;
};

}  // namespace abrazo::widgets
