#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/interaction_mesh.hpp"

namespace abrazo::widgets {

enum class SelectionKind : std::uint8_t { None, Joints, Edge, Tetrahedron, Candidate };

/// A selected or hovered item, valid in every frame and view. Joints, edges and tetrahedra are identified by
/// their vertices of the pair, a candidate by its library pair.
struct Selection {
  SelectionKind kind = SelectionKind::None;
  /// Joints in the order they were selected, at least one; ends of an edge or corners of a tetrahedron
  /// ascending.
  std::vector<std::uint8_t> vertices;
  int pair = -1;  ///< of the library; for candidates only

  bool operator==(const Selection&) const = default;
  explicit operator bool() const { return kind != SelectionKind::None; }
  bool is_of_mesh() const { return *this && kind != SelectionKind::Candidate; }
  /// The joint selected last; -1 if no joint is selected.
  int last_joint() const { return kind == SelectionKind::Joints ? vertices.back() : -1; }
  bool has(int vertex) const;

  static Selection joint(int vertex);
  static Selection edge(const MeshEdge& edge);
  static Selection tetrahedron(const MeshTetrahedron& cell);
  static Selection candidate(int pair);
};

enum class SelectionChange { Replace, Add, Toggle };

/// The selection after choosing an item. Joints accumulate; other items replace the selection, or clear it if
/// chosen again.
Selection changed(const Selection& before, const Selection& item, SelectionChange how);

/// The same joints, or the corresponding edge or tetrahedron, of the other character; the leader's root for
/// an empty selection.
Selection other_character(const Selection& selection);

/// "leader lhand"
std::string vertex_name(int vertex);
/// "leader lhand, follower rhand", "leader lhand — follower rhand", "pair 1342".
std::string name_of(const Selection& selection);

}  // namespace abrazo::widgets
