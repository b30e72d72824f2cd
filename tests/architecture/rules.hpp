#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/architecture/source_tree.hpp"

namespace abrazo::test {

/// What breaks a rule, as "file:line: why".
using Violations = std::vector<std::string>;

/// Which folders of core each folder may include from (docs/architecture.md).
const std::map<std::string, std::set<std::string>>& core_table();

// One function per rule of docs/architecture.md. Each looks only at the files that the rule concerns.
Violations core_names_no_toolkit(std::span<const SourceFile> files);
Violations core_folders_include_downwards(std::span<const SourceFile> files);
Violations layers_point_down(std::span<const SourceFile> files);
Violations command_line_knows_no_widgets(std::span<const SourceFile> files);
/// The renderer draws the scene alone: no window, no other views. Its options know no toolkit.
Violations renderer_draws_only_the_scene(std::span<const SourceFile> files);
Violations third_parties_have_one_place(std::span<const SourceFile> files);
Violations widgets_see_only_snapshots(std::span<const SourceFile> files);
Violations widget_folders_are_strangers(std::span<const SourceFile> files);
Violations headers_have_pragma_once(std::span<const SourceFile> files);
Violations no_path_of_a_machine(std::span<const SourceFile> files);

/// Files whose path starts with `prefix` have at most `most` lines.
Violations at_most_lines(std::span<const SourceFile> files, std::string_view prefix, int most);

}  // namespace abrazo::test
