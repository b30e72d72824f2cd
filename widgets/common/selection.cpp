#include "widgets/common/selection.hpp"

#include <algorithm>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {

bool Selection::has(int vertex) const {
  return std::find(vertices.begin(), vertices.end(), vertex) != vertices.end();
}

Selection Selection::joint(int vertex) {
  return {SelectionKind::Joints, {static_cast<std::uint8_t>(vertex)}, -1};
}

Selection Selection::edge(const MeshEdge& edge) {
  return {SelectionKind::Edge, {std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}, -1};
}

Selection Selection::tetrahedron(const MeshTetrahedron& cell) {
  Selection item{SelectionKind::Tetrahedron, {cell.begin(), cell.end()}, -1};
  std::sort(item.vertices.begin(), item.vertices.end());
  return item;
}

Selection Selection::candidate(int pair) {
  return {SelectionKind::Candidate, {}, pair};
}

Selection changed(const Selection& before, const Selection& item, SelectionChange how) {
  if (how == SelectionChange::Replace) return item;
  if (!item) return before;  // a click with a key held that hits nothing takes nothing away
  const bool adds_up = before.kind == SelectionKind::Joints && item.kind == SelectionKind::Joints;
  if (!adds_up) return how == SelectionChange::Toggle && item == before ? Selection{} : item;
  Selection after = before;
  for (const std::uint8_t vertex : item.vertices) {
    const bool had = std::erase(after.vertices, vertex) > 0;
    if (!had || how == SelectionChange::Add) after.vertices.push_back(vertex);
  }
  return after.vertices.empty() ? Selection{} : after;
}

Selection other_character(const Selection& selection) {
  if (!selection.is_of_mesh()) return Selection::joint(joints::Root);
  Selection other = selection;
  for (std::uint8_t& vertex : other.vertices)
    vertex = static_cast<std::uint8_t>((vertex + joint_count) % pair_vertex_count);
  if (other.kind != SelectionKind::Joints) std::sort(other.vertices.begin(), other.vertices.end());
  return other;
}

std::string vertex_name(int vertex) {
  const std::string body = vertex < joint_count ? "leader " : "follower ";
  return body + std::string(joint_names[static_cast<std::size_t>(vertex % joint_count)]);
}

std::string name_of(const Selection& selection) {
  if (selection.kind == SelectionKind::Candidate) return "pair " + std::to_string(selection.pair);
  std::string name;
  for (const std::uint8_t vertex : selection.vertices) {
    if (!name.empty()) name += selection.kind == SelectionKind::Edge ? " — " : ", ";
    name += vertex_name(vertex);
  }
  return name;
}

}  // namespace abrazo::widgets
