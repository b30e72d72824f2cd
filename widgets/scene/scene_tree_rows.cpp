#include "widgets/scene/scene_tree_rows.hpp"

#include <algorithm>
#include <cctype>

#include "core/motion/joint_set.hpp"

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
    rows.push_back({filter.empty() ? name : vertex_name(vertex), character.depth + 1, {}, vertex, -1});
  }
}

}  // namespace

const std::vector<TreeRow>& part_rows() {
  using P = ScenePart;
  static const std::vector<TreeRow> all = {
      {"User", 0, {P::User}},
      {"Result", 0, {P::Leader, P::Follower}},
      {"Leader", 1, {P::Leader}, -1, 0},
      {"Follower", 1, {P::Follower}, -1, 1},
      {"Selected pair", 0, {P::SelectedPair}},
      {"Interaction mesh", 0, {P::MeshBetween, P::MeshWithin}},
      {"between bodies", 1, {P::MeshBetween}},
      {"within bodies", 1, {P::MeshWithin}},
      {"tetrahedra", 1, {P::Tetrahedra}},
      {"Constraints", 0, {P::Bones, P::FootLocks, P::Contacts, P::Touches}},
      {"bones", 1, {P::Bones}},
      {"foot locks", 1, {P::FootLocks}},
      {"collisions", 1, {P::Contacts}},
      {"contacts", 1, {P::Touches}},
      {"Joints", 0, {P::Joints}},
      {"Comparison", 0, {P::Comparison}},
      {"Morph steps", 0, {P::MorphSteps}},
      {"Trails", 0, {P::Trails}},
      {"Floor", 0, {P::Floor}}};
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
