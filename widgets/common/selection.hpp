#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/interaction_mesh.hpp"

namespace abrazo::widgets {

enum class SelectionKind : std::uint8_t { None, Joints, Edge, Tetrahedron, Candidate };

/// What a person has selected or points at: the same thing in every frame and in every view. Joints, edges
/// and tetrahedra are named by their vertices of the pair, a candidate by its pair of the library.
struct Selection {
  SelectionKind kind = SelectionKind::None;
  /// Joints in the order they were selected, at least one; ends of an edge or corners of a tetrahedron
  /// ascending.
  std::vector<std::uint8_t> vertices;
  int pair = -1;  ///< of the library; of a candidate only

  bool operator==(const Selection&) const = default;
  explicit operator bool() const { return kind != SelectionKind::None; }
  bool is_of_mesh() const { return *this && kind != SelectionKind::Candidate; }
  /// The joint that was selected last; -1 when it is no joint.
  int last_joint() const { return kind == SelectionKind::Joints ? vertices.back() : -1; }
  bool has(int vertex) const;

  static Selection joint(int vertex);
  static Selection edge(const MeshEdge& edge);
  static Selection tetrahedron(const MeshTetrahedron& cell);
  static Selection candidate(int pair);
};

enum class SelectionChange { Replace, Add, Toggle };

/// What is selected after an item was chosen. Joints add up; anything else replaces, and toggles off.
Selection changed(const Selection& before, const Selection& item, SelectionChange how);

/// The same joints, or the like edge or tetrahedron, of the other character; the leader's root for nothing.
Selection other_character(const Selection& selection);

/// "leader lhand"
std::string vertex_name(int vertex);
/// "leader lhand, follower rhand", "leader lhand — follower rhand", "pair 1342".
std::string name_of(const Selection& selection);

}  // namespace abrazo::widgets
