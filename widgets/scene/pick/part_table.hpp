#pragma once

#include <string>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/common/selection.hpp"

namespace abrazo::widgets {

enum class TableOf { Joints, Edges, Tetrahedra };

/// Figures of the parts of one frame, a row each.
struct PartTable {
  struct Row {
    Selection item;
    std::string name;
    std::vector<double> values;  ///< one per column; NaN where there is none
  };
  std::vector<std::string> columns;  ///< with unit: "length [m]"
  std::vector<Row> rows;
};

/// The parts that belong to a selection: the joints themselves, the edges and tetrahedra at any of them; the
/// ends and cells of an edge; the corners and edges of a tetrahedron. Without a selection of the mesh: all.
/// @param before  the frame before, for velocities; may be null
PartTable part_table(const FrameSnapshot& frame, const FrameSnapshot* before, TableOf of,
                     const Selection& selection);

/// A header line, then a line for each row; empty fields for NaN.
std::string csv_of(const PartTable& table);

}  // namespace abrazo::widgets
