#pragma once

#include <vector>

#include "widgets/scene/actors/cell_actor.hpp"
#include "widgets/scene/actors/line_set.hpp"
#include "widgets/scene/values/mesh_filter.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"
#include "widgets/scene/values/scene_parts.hpp"

namespace abrazo::widgets {

/// Appearance of the interaction mesh in a frame.
struct MeshLook {
  std::vector<double> scalars;  ///< one per edge
  ColourScale scale;
  double doublings = 0;  ///< |log2 volume ratio| at the ends of the cells' colour map
  MeshFilter filter;
  double apart = 0;  ///< displacement of cells from the middle, share of their distance
};

/// Edges and tetrahedra of the interaction mesh. Keeps the shown ones for picking.
class MeshActors {
 public:
  void addTo(vtkRenderer* solid, vtkRenderer* in_front);
  void setColours(const Palette& palette, double pixel_ratio);
  void setVisibility(const PartVisibility& visibility);
  void show(const FrameResult& result, const MeshLook& look);
  void sortFor(const Vec3& eye, const Vec3& direction) { m_cells.sortFor(eye, direction); }

  const std::vector<MeshEdge>& shownEdges() const { return m_shown_edges; }
  const std::vector<MeshTetrahedron>& shownCells() const { return m_shown_cells; }
  /// The shown edges of the frame between the bodies, and their colours.
  const std::vector<std::size_t>& betweenEdges() const { return m_between; }
  const std::vector<std::array<unsigned char, 4>>& betweenColours() const { return m_between_colours; }
  /// 12 numbers per shown cell, world [m].
  std::span<const double> corners() const { return m_cells.corners(); }
  std::size_t betweenCount() const { return m_between_count; }  ///< of the frame, regardless of the filter
  int invertedCount() const { return m_inverted; }

 private:
  void rebuildEdges(const FrameResult& result, const MeshLook& look);
  void colourEdges(const MeshLook& look);
  void showCells(const FrameResult& result, const MeshLook& look);
  bool showsEdges(ScenePart part) const;
  bool isOn(ScenePart part) const { return m_visibility[static_cast<std::size_t>(part)]; }

  PartVisibility m_visibility = default_visibility;
  bool m_filtered = false;             ///< detects that a filter was removed
  bool m_exploded = false;             ///< cells are shown, and apart
  bool m_stale = true;                 ///< the shown topology is outdated
  std::vector<MeshEdge> m_edges;       ///< of the frame
  std::vector<std::size_t> m_between;  ///< shown ones between the two bodies
  std::vector<std::array<unsigned char, 4>> m_between_colours;
  std::size_t m_between_count = 0;
  int m_inverted = 0;
  std::vector<MeshEdge> m_shown_edges;
  std::vector<MeshTetrahedron> m_shown_cells;
  LineSet m_between_lines, m_between_strong, m_between_through, m_within;
  CellActor m_cells;
};

}  // namespace abrazo::widgets
