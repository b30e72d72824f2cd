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

/// Which rooms of its folder each room may include from, by folder.
using Rooms = std::map<std::string, std::set<std::string>>;
const std::map<std::string, Rooms>& room_table();

/// A file that includes from a room that its own room may not see. The list only becomes shorter: what is not
/// needed any more is itself a violation, and nothing is added.
struct RoomException {
  std::string_view file, include, why;
};
std::span<const RoomException> room_exceptions();

// One function per rule of docs/architecture.md. Each looks only at the files that the rule concerns.
Violations core_names_no_toolkit(std::span<const SourceFile> files);
Violations core_folders_include_downwards(std::span<const SourceFile> files);
Violations rooms_include_downwards(std::span<const SourceFile> files);
Violations room_exceptions_are_needed(std::span<const SourceFile> files);
/// No folder of core, widgets and app has more C++ files than a person looks through; rooms divide it.
Violations folders_are_not_crowded(std::span<const SourceFile> files);
/// What scenes are made of is reckoned without the toolkit that draws it.
Violations scene_values_know_no_toolkit(std::span<const SourceFile> files);
Violations layers_point_down(std::span<const SourceFile> files);
Violations command_line_knows_no_widgets(std::span<const SourceFile> files);
/// The Python module is core's alone: no toolkit, nothing of the programs.
Violations python_knows_core_alone(std::span<const SourceFile> files);
/// The renderer draws the scene alone: no window, no other views. Its options know no toolkit.
Violations renderer_draws_only_the_scene(std::span<const SourceFile> files);
Violations third_parties_have_one_place(std::span<const SourceFile> files);
Violations widgets_see_only_snapshots(std::span<const SourceFile> files);
Violations widget_folders_are_strangers(std::span<const SourceFile> files);
Violations headers_have_pragma_once(std::span<const SourceFile> files);
Violations no_path_of_a_machine(std::span<const SourceFile> files);

/// Core's sentences name no option of the command line, which other programs do not have: an Error carries a
/// Hint, and each program adds its words.
Violations core_names_no_option(std::span<const SourceFile> files);

/// A signal says what became of its object; whoever wants something of another asks it.
Violations signals_are_of_their_own_object(std::span<const SourceFile> files);

/// Files whose path starts with `prefix` and ends in `ending` have at most `most` lines.
Violations at_most_lines(std::span<const SourceFile> files, std::string_view prefix, int most,
                         std::string_view ending = {});

/// At the top level are the files and folders of a list, and what git ignores.
/// @param names  of what is at the top level
/// @param ignored  .gitignore
Violations top_level_is_known(std::span<const std::string> names, const SourceFile& ignored);
/// A corpus has few, chosen seeds; fuzzing grows it in the build folder.
/// @param paths  of the files in the folders of tests/fuzz/corpus
Violations corpora_are_small(std::span<const std::string> paths);

}  // namespace abrazo::test
