#include "widgets/scene/pick/part_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "widgets/scene/pick/pick_facts.hpp"
#include "widgets/scene/values/mesh_cells.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"

namespace abrazo::widgets {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double mm_per_m = 1000, litres_per_m3 = 1000;
constexpr double longest_step_s = 0.2;  ///< after a gap a difference is no velocity

/// Whether a part with these vertices belongs to the selection.
template <typename Vertices>
bool belongs(const Vertices& part, const Selection& selection) {
  if (!selection.is_of_mesh()) return true;
  const auto in_selection = [&selection](int vertex) { return selection.has(vertex); };
  if (selection.kind == SelectionKind::Joints) return std::ranges::any_of(part, in_selection);
  const auto in_part = [&part](int vertex) { return std::ranges::find(part, vertex) != part.end(); };
  return std::ranges::all_of(part, in_selection) || std::ranges::all_of(selection.vertices, in_part);
}

PartTable table_of_joints(const FrameSnapshot& frame, const FrameSnapshot* before,
                          const Selection& selection) {
  PartTable table;
  table.columns = {"x [m]",
                   "y [m]",
                   "z [m]",
                   "vx [m/s]",
                   "vy [m/s]",
                   "vz [m/s]",
                   "speed [m/s]",
                   "from the selected pair [mm]",
                   "to the nearest of the other [m]"};
  const bool has_two = selection.kind == SelectionKind::Joints && selection.vertices.size() > 1;
  if (has_two) table.columns.push_back("to " + vertex_name(selection.last_joint()) + " [m]");
  const PairPose& pair = frame.result.result;
  const double step_s = before ? frame.time_s - before->time_s : 0;
  for (int vertex = 0; vertex < 2 * joint_count; ++vertex) {
    if (selection.is_of_mesh() && !selection.has(vertex)) continue;
    const JointFacts facts = joint_facts(frame, vertex);
    Vec3 velocity = Vec3::Constant(none);
    if (step_s > 0 && step_s < longest_step_s)
      velocity = (pair.row(vertex) - before->result.result.row(vertex)).transpose() / step_s;
    PartTable::Row row{
        Selection::joint(vertex),
        vertex_name(vertex),
        {facts.position.x(), facts.position.y(), facts.position.z(), velocity.x(), velocity.y(), velocity.z(),
         velocity.norm(), mm_per_m * facts.to_selected_m, facts.to_partner_m}};
    if (has_two) row.values.push_back((pair.row(vertex) - pair.row(selection.last_joint())).norm());
    table.rows.push_back(std::move(row));
  }
  return table;
}

PartTable table_of_edges(const FrameSnapshot& frame, const Selection& selection) {
  PartTable table;
  table.columns = {"length [m]", "in the selected pair [m]", "change [mm]", "weight", "residual [mm]",
                   "energy [%]"};
  const FrameResult& result = frame.result;
  std::array<std::vector<double>, mesh_scalar_count> scalars;
  for (const MeshScalar scalar :
       {MeshScalar::Residual, MeshScalar::Weight, MeshScalar::LengthChange, MeshScalar::EnergyShare})
    scalars[static_cast<std::size_t>(scalar)] = edge_scalars(frame, scalar);
  for (std::size_t e = 0; e < result.edges.size(); ++e) {
    const MeshEdge& edge = result.edges[e];
    if (!belongs(edge, selection)) continue;
    const auto value = [&](MeshScalar scalar) { return scalars[static_cast<std::size_t>(scalar)][e]; };
    const auto length = [&](const PairPose& pair) { return (pair.row(edge[0]) - pair.row(edge[1])).norm(); };
    table.rows.push_back(
        {Selection::edge(edge),
         vertex_name(edge[0]) + " — " + vertex_name(edge[1]),
         {length(result.result), length(result.selected_pair), value(MeshScalar::LengthChange),
          value(MeshScalar::Weight), value(MeshScalar::Residual), value(MeshScalar::EnergyShare)}});
  }
  return table;
}

PartTable table_of_cells(const FrameSnapshot& frame, const Selection& selection) {
  PartTable table;
  table.columns = {"volume [l]", "in the selected pair [l]", "ratio"};
  for (const MeshTetrahedron& cell : frame.result.tetrahedra) {
    if (!belongs(cell, selection)) continue;
    const CellVolume volume = cell_volume(frame.result.result, frame.result.selected_pair, cell);
    std::string name;
    for (const auto vertex : cell) name += (name.empty() ? "" : ", ") + vertex_name(vertex);
    table.rows.push_back({Selection::tetrahedron(cell),
                          std::move(name),
                          {litres_per_m3 * volume.volume_m3, litres_per_m3 * volume.reference_m3,
                           volume.is_flat ? none : volume.ratio}});
  }
  return table;
}

}  // namespace

PartTable part_table(const FrameSnapshot& frame, const FrameSnapshot* before, TableOf of,
                     const Selection& selection) {
  switch (of) {
    case TableOf::Joints:
      return table_of_joints(frame, before, selection);
    case TableOf::Edges:
      return table_of_edges(frame, selection);
    case TableOf::Tetrahedra:
      break;
  }
  return table_of_cells(frame, selection);
}

std::string csv_of(const PartTable& table) {
  std::string text = "part";
  for (const std::string& column : table.columns) text += "," + column;
  text += "\n";
  for (const PartTable::Row& row : table.rows) {
    text += "\"" + row.name + "\"";
    for (const double value : row.values) {
      std::array<char, 32> number{};
      if (std::isfinite(value)) std::snprintf(number.data(), number.size(), "%.9g", value);
      text += std::string(",") + number.data();
    }
    text += "\n";
  }
  return text;
}

}  // namespace abrazo::widgets
