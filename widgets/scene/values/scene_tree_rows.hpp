#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "widgets/common/selection.hpp"
#include "widgets/scene/values/scene_parts.hpp"

namespace abrazo::widgets {

/// One row of the scene tree: a part, a group of parts, or a joint of a character.
struct TreeRow {
  std::string name;
  int depth = 0;
  std::vector<ScenePart> parts;  ///< what its dot switches; a group switches all of its own; a joint has none
  std::string tip;               ///< what it is; a joint has none
  int vertex = -1;               ///< of a joint
  int character = -1;            ///< 0 leader, 1 follower: can be opened
};

/// Parts and groups, in the order of the tree. The first nine have keys.
const std::vector<TreeRow>& part_rows();
inline constexpr std::size_t rows_with_keys = 9;

/// The rows that are shown. @param open  whose joints; @param filter  only rows that have it in their name,
/// whatever the case, with the joints of both characters among them; empty for all
std::vector<TreeRow> tree_rows(const std::array<bool, 2>& open, std::string_view filter);

/// Whether any of a row's parts is shown.
bool is_on(const TreeRow& row, const PartVisibility& visibility);
/// All parts of a row the other way.
PartVisibility toggled(const TreeRow& row, PartVisibility visibility);

}  // namespace abrazo::widgets
