#include "widgets/scene/actors/mesh_actors.hpp"

#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abrazo::widgets {
namespace {

using Line = std::array<int, 2>;
using Rgba = std::array<unsigned char, 4>;

constexpr double strong_share = 0.45;  // of the map, from which an edge is drawn thicker
constexpr double cell_shrink = 0.06;   // a gap that separates neighbouring cells

}  // namespace

void MeshActors::addTo(vtkRenderer* solid, vtkRenderer* in_front) {
  for (LineSet* lines : {&m_within, &m_between_lines, &m_between_strong}) lines->addTo(solid);
  m_cells.addTo(solid, in_front);
  m_between_through.addTo(in_front);
}

void MeshActors::setColours(const Palette& palette, double pixel_ratio) {
  const auto style = [pixel_ratio](LineSet& lines, const QColor& colour, double width, double opacity) {
    lines.setColour(colour, opacity);
    lines.setWidth(width * pixel_ratio);
  };
  const QColor thin = palette.dark ? QColor("#aab4c4") : QColor("#3c4552");
  style(m_within, thin, 1, palette.dark ? 0.26 : 0.30);
  style(m_between_lines, palette.text, 1.6, 1);
  style(m_between_strong, palette.text, 3, 1);
  style(m_between_through, palette.text, 1.4, 0.34);
  m_cells.setColours(palette, pixel_ratio);
}

void MeshActors::setVisibility(const PartVisibility& visibility) {
  m_visibility = visibility;
  m_stale = true;
  m_cells.setVisible(isOn(ScenePart::Tetrahedra));
}

/// Edges stay where the cells were: between exploded cells they would only be in the way.
bool MeshActors::showsEdges(ScenePart part) const {
  return isOn(part) && !m_exploded;
}

void MeshActors::show(const FrameResult& result, const MeshLook& look) {
  const bool exploded = look.apart > 0 && isOn(ScenePart::Tetrahedra);
  m_stale |= exploded != m_exploded;
  m_exploded = exploded;
  for (LineSet* lines : {&m_between_lines, &m_between_strong, &m_between_through})
    lines->setVisible(showsEdges(ScenePart::MeshBetween));
  m_within.setVisible(showsEdges(ScenePart::MeshWithin));
  // With a filter by length or value the shown edges change with every pose.
  if (m_stale || result.edges != m_edges || !look.filter.is_open() || m_filtered) rebuildEdges(result, look);
  m_stale = false;
  m_filtered = !look.filter.is_open();
  const std::span<const double> points(result.result.data(), pair_vertex_count * 3);
  for (LineSet* lines : {&m_between_lines, &m_between_strong, &m_between_through, &m_within})
    lines->setPoints(points);
  colourEdges(look);
  showCells(result, look);
}

void MeshActors::rebuildEdges(const FrameResult& result, const MeshLook& look) {
  m_edges = result.edges;
  m_between.clear();
  m_shown_edges.clear();
  m_between_count = 0;
  std::vector<Line> between, within;
  for (std::size_t e = 0; e < m_edges.size(); ++e) {
    const bool joins = is_inter_body(m_edges[e]);
    m_between_count += joins;
    if (!look.filter.passes(result.result, m_edges[e])) continue;
    const double value = e < look.scalars.size() ? look.scalars[e] : std::numeric_limits<double>::quiet_NaN();
    if (!look.filter.passes_value(value)) continue;
    if (joins) m_between.push_back(e);
    (joins ? between : within).push_back({m_edges[e][0], m_edges[e][1]});
    if (showsEdges(joins ? ScenePart::MeshBetween : ScenePart::MeshWithin))
      m_shown_edges.push_back(m_edges[e]);
  }
  m_between_lines.setLines(between);
  m_between_through.setLines(between);
  m_within.setLines(within);
}

void MeshActors::colourEdges(const MeshLook& look) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Rgba> strong_colours;
  std::vector<Line> strong;
  m_between_colours.clear();
  for (const std::size_t e : m_between) {
    const double value = e < look.scalars.size() ? look.scalars[e] : none;
    const auto [r, g, b] = look.scale.colour(value);
    m_between_colours.push_back({r, g, b, 255});
    if (!(std::abs(value) >= strong_share * look.scale.upper) || look.scale.upper <= 0) continue;
    strong.push_back({m_edges[e][0], m_edges[e][1]});
    strong_colours.push_back(m_between_colours.back());
  }
  m_between_lines.setCellColours(m_between_colours);
  m_between_through.setCellColours(m_between_colours);
  m_between_strong.setLines(strong);
  m_between_strong.setCellColours(strong_colours);
}

void MeshActors::showCells(const FrameResult& result, const MeshLook& look) {
  const std::vector<CellVolume> all = cell_volumes(result);
  m_inverted = inverted_count(all);
  m_shown_cells.clear();
  if (!isOn(ScenePart::Tetrahedra)) return;
  std::vector<CellVolume> shown;
  for (std::size_t c = 0; c < all.size(); ++c) {
    const MeshTetrahedron& cell = result.tetrahedra[c];
    if (!isOn(ScenePart::MeshWithin) && !joins_bodies(cell)) continue;
    if (!look.filter.passes(result.result, cell)) continue;
    m_shown_cells.push_back(cell);
    shown.push_back(all[c]);
  }
  m_cells.show(spread_cells(result.result, m_shown_cells, look.apart, cell_shrink), shown, look.doublings);
}

}  // namespace abrazo::widgets
