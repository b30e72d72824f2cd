#include "widgets/scene/values/scene_tree_rows.hpp"

#include <algorithm>
#include <cctype>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {
namespace {

bool contains(std::string_view name, std::string_view part) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(name.begin(), name.end(), part.begin(), part.end(), same) != name.end();
}

void add_joints(std::vector<TreeRow>& rows, const TreeRow& character, std::string_view filter) {
  for (int joint = 0; joint < joint_count; ++joint) {
    const int vertex = character.character * joint_count + joint;
    const std::string name(joint_names[static_cast<std::size_t>(joint)]);
    // "leader lhand" finds it, too.
    if (!contains(vertex_name(vertex), filter)) continue;
    rows.push_back({filter.empty() ? name : vertex_name(vertex), character.depth + 1, {}, {}, vertex, -1});
  }
}

}  // namespace

const std::vector<TreeRow>& part_rows() {
  using P = ScenePart;
  static const std::vector<TreeRow> all = {
      {"User", 0, {P::User}, "The motion as received"},
      {"Result", 0, {P::Leader, P::Follower}, "Both characters as they were solved"},
      {"Leader", 1, {P::Leader}, "The character that leads", -1, 0},
      {"Follower", 1, {P::Follower}, "The character that follows", -1, 1},
      {"Selected pair", 0, {P::SelectedPair}, "The selected recorded pair, placed at the user"},
      {"Interaction mesh", 0, {P::MeshBetween, P::MeshWithin}, "Edges that connect nearby joints"},
      {"between bodies", 1, {P::MeshBetween}, "Edges of the interaction mesh from one body to the other"},
      {"within bodies", 1, {P::MeshWithin}, "Edges of the interaction mesh within a body"},
      {"tetrahedra",
       1,
       {P::Tetrahedra},
       "Cells of the interaction mesh, coloured by how their volume changed"},
      {"Constraints", 0, {P::Bones, P::FootLocks, P::Contacts, P::Touches}, "What the solver keeps"},
      {"bones", 1, {P::Bones}, "Lengths that are kept"},
      {"foot locks", 1, {P::FootLocks}, "A ring for each locked foot"},
      {"collisions", 1, {P::Contacts}, "Limbs of the two bodies that overlap"},
      {"contacts", 1, {P::Touches}, "Hands that hold one another, feet on the floor"},
      {"Joints", 0, {P::Joints}, "The 25 joints of each character"},
      {"Comparison", 0, {P::Comparison}, "The bodies of runs A and B"},
      {"Morph steps", 0, {P::MorphSteps}, "The poses on the way from the selected pair to the result"},
      {"Trails",
       0,
       {P::Trails},
       "Where the selected joints were in the last moments; the hands while none is selected"},
      {"Look-ahead",
       0,
       {P::LookAhead},
       "Where root, head, hands and feet of the partner go in the next second, if the recording continues "
       "after the selected pair. Shorter where its take ends"},
      {"Floor", 0, {P::Floor}, "The floor; its stronger lines are a metre apart"}};
  return all;
}

std::vector<TreeRow> tree_rows(const std::array<bool, 2>& open, std::string_view filter) {
  std::vector<TreeRow> rows;
  for (const TreeRow& row : part_rows()) {
    if (contains(row.name, filter)) {
      rows.push_back(row);
      if (!filter.empty()) rows.back().depth = 0;
    }
    if (row.character < 0) continue;
    if (!filter.empty() || open[static_cast<std::size_t>(row.character)]) {
      const std::size_t first = rows.size();
      // The name of a character finds the character, not each of its joints.
      if (filter.empty() || !contains(row.name, filter)) add_joints(rows, row, filter);
      if (!filter.empty())
        for (std::size_t r = first; r < rows.size(); ++r) rows[r].depth = 0;
    }
  }
  return rows;
}

bool is_on(const TreeRow& row, const PartVisibility& visibility) {
  return std::any_of(row.parts.begin(), row.parts.end(),
                     [&visibility](ScenePart p) { return visibility[static_cast<std::size_t>(p)]; });
}

PartVisibility toggled(const TreeRow& row, PartVisibility visibility) {
  const bool on = !is_on(row, visibility);
  for (const ScenePart part : row.parts) visibility[static_cast<std::size_t>(part)] = on;
  return visibility;
}

}  // namespace abrazo::widgets
