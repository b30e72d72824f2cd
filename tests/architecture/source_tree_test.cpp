// The rules of docs/architecture.md, on the tree as it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "tests/architecture/rules.hpp"

namespace abrazo::test::source_tree_test {
namespace {

const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> files = read_source_tree(ABRAZO_SOURCE_DIR);
  return files;
}

testing::AssertionResult holds(const Violations& violations) {
  if (violations.empty()) return testing::AssertionSuccess();
  testing::AssertionResult failure = testing::AssertionFailure();
  for (const std::string& violation : violations) failure << "\n  " << violation;
  return failure;
}

TEST(Architecture, TheTreeIsRead) {
  // Otherwise every rule below would hold for want of files.
  const auto count = std::ranges::count_if(
      tree(), [](const SourceFile& file) { return file.is_under("core/") && file.is_cpp(); });
  EXPECT_GT(count, 40);
}

TEST(Architecture, CoreKnowsNeitherQtNorVtk) {
  EXPECT_TRUE(holds(core_names_no_toolkit(tree())));
}

TEST(Architecture, CoreFoldersIncludeOnlyDownwards) {
  EXPECT_TRUE(holds(core_folders_include_downwards(tree())));
}

TEST(Architecture, RoomsIncludeOnlyDownwards) {
  EXPECT_TRUE(holds(rooms_include_downwards(tree())));
}

TEST(Architecture, ExceptionsOfRoomsAreNeeded) {
  EXPECT_TRUE(holds(room_exceptions_are_needed(tree())));
}

TEST(Architecture, NoFolderIsCrowded) {
  EXPECT_TRUE(holds(folders_are_not_crowded(tree())));
}

TEST(Architecture, ValuesOfTheSceneKnowNoToolkit) {
  EXPECT_TRUE(holds(scene_values_know_no_toolkit(tree())));
}

TEST(Architecture, LayersPointDown) {
  EXPECT_TRUE(holds(layers_point_down(tree())));
}

TEST(Architecture, TheCommandLineNeedsNoToolkit) {
  EXPECT_TRUE(holds(command_line_knows_no_widgets(tree())));
}

TEST(Architecture, ThePythonModuleIsCoresAlone) {
  EXPECT_TRUE(holds(python_knows_core_alone(tree())));
}

TEST(Architecture, TheRendererDrawsOnlyTheScene) {
  EXPECT_TRUE(holds(renderer_draws_only_the_scene(tree())));
}

TEST(Architecture, AThirdPartyIsNamedInOnePlace) {
  EXPECT_TRUE(holds(third_parties_have_one_place(tree())));
}

TEST(Architecture, WidgetsSeeSnapshotsAndNothingThatRuns) {
  EXPECT_TRUE(holds(widgets_see_only_snapshots(tree())));
}

TEST(Architecture, WidgetFoldersDoNotKnowEachOther) {
  EXPECT_TRUE(holds(widget_folders_are_strangers(tree())));
}

TEST(Architecture, CoreNamesNoOption) {
  EXPECT_TRUE(holds(core_names_no_option(tree())));
}

TEST(Architecture, SignalsAreEmittedByTheirOwnObject) {
  EXPECT_TRUE(holds(signals_are_of_their_own_object(tree())));
}

TEST(Architecture, TheMainWindowStaysSmall) {
  EXPECT_TRUE(holds(at_most_lines(tree(), "app/workbench/shell/main_window.cpp", 300)));
}

TEST(Architecture, AnActionStaysSmall) {
  EXPECT_TRUE(holds(at_most_lines(tree(), "app/workbench/", 150, "_actions.cpp")));
}

TEST(Architecture, HeadersArePragmaOnce) {
  EXPECT_TRUE(holds(headers_have_pragma_once(tree())));
}

TEST(Architecture, NoFileNamesAPathOfOneMachine) {
  EXPECT_TRUE(holds(no_path_of_a_machine(tree())));
}

TEST(Architecture, NothingUnknownIsAtTheTopLevel) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(ABRAZO_SOURCE_DIR))
    names.push_back(entry.path().filename().string());
  const auto ignored =
      std::ranges::find(tree(), ".gitignore", [](const SourceFile& file) { return file.path; });
  EXPECT_TRUE(
      holds(top_level_is_known(names, ignored == tree().end() ? source_file(".gitignore", "") : *ignored)));
}

TEST(Architecture, CorporaOfFuzzTargetsAreSmall) {
  const std::filesystem::path root = ABRAZO_SOURCE_DIR;
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "tests/fuzz/corpus"))
    if (entry.is_regular_file()) paths.push_back(entry.path().lexically_relative(root).generic_string());
  EXPECT_GT(paths.size(), 100U);
  EXPECT_TRUE(holds(corpora_are_small(paths)));
}

TEST(Architecture, TheOverviewStaysShort) {
  EXPECT_TRUE(holds(at_most_lines(tree(), "docs/architecture.md", 150)));
}

TEST(Architecture, LinksOfDocumentsLeadSomewhere) {
  Violations dead;
  for (const SourceFile& file : tree()) {
    if (!file.path.ends_with(".md")) continue;
    for (const DocumentLink& link : links_of(file)) {
      if (std::filesystem::exists(std::filesystem::path(ABRAZO_SOURCE_DIR) / link.target)) continue;
      dead.push_back(file.path + ":" + std::to_string(link.line) + ": there is no " + link.target);
    }
  }
  EXPECT_TRUE(holds(dead));
}

/// Benchmarks and fuzzers are not built with the rest, and a file that moves breaks them unseen.
TEST(Architecture, SourcesThatTheBuildNamesAreThere) {
  const std::filesystem::path root = ABRAZO_SOURCE_DIR;
  std::set<std::string> names;
  for (const SourceFile& file : tree()) names.insert(std::filesystem::path(file.path).filename().string());
  const std::regex source(R"((?:^|[\s"])([\w./-]*\w\.cpp)(?=$|[\s")]))"),
      variable(R"(set\((\w+) \$\{PROJECT_SOURCE_DIR\}/([^)]*)\))");
  Violations missing;
  int named = 0;
  for (const SourceFile& file : tree()) {
    if (!file.path.ends_with("CMakeLists.txt")) continue;
    const auto here = (root / file.path).parent_path();
    std::map<std::string, std::string> folders = {{"PROJECT_SOURCE_DIR", root.string()}};
    for (std::size_t n = 0; n < file.lines.size(); ++n) {
      std::string line = file.lines[n];
      if (std::smatch found; std::regex_search(line, found, variable))
        folders[found[1]] = (root / found[2].str()).string();
      for (const auto& [name, folder] : folders) {
        const std::string reference = "${" + name + "}";
        for (auto at = line.find(reference); at != std::string::npos; at = line.find(reference))
          line.replace(at, reference.size(), folder);
      }
      for (std::sregex_iterator at(line.begin(), line.end(), source), end; at != end; ++at) {
        const std::string path = (*at)[1];
        ++named;
        const bool is_name = path.find('/') == std::string::npos;  // its folder may be in a variable
        if (is_name ? names.contains(path) : std::filesystem::exists(here / path)) continue;
        missing.push_back(file.path + ":" + std::to_string(n + 1) + ": there is no " + path);
      }
    }
  }
  EXPECT_GT(named, 500);
  EXPECT_TRUE(holds(missing));
}

}  // namespace
}  // namespace abrazo::test::source_tree_test
