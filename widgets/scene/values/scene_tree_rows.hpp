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
  std::vector<ScenePart> parts;  ///< switched by its dot; a group switches all its parts; a joint has none
  std::string tip;               ///< tooltip; a joint has none
  int vertex = -1;               ///< of a joint
  int character = -1;            ///< 0 leader, 1 follower: expandable
};

/// Parts and groups, in the order of the tree. The first nine have keys.
const std::vector<TreeRow>& part_rows();
inline constexpr std::size_t rows_with_keys = 9;

/// The visible rows. @param open characters with visible joints; @param filter only rows with this text in
/// their name, ignoring case, including the joints of both characters; empty = all
std::vector<TreeRow> tree_rows(const std::array<bool, 2>& open, std::string_view filter);

/// Whether any of a row's parts is shown.
bool is_on(const TreeRow& row, const PartVisibility& visibility);
/// Toggles all parts of a row.
PartVisibility toggled(const TreeRow& row, PartVisibility visibility);

}  // namespace abrazo::widgets
