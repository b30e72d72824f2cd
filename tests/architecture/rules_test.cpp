// The rules themselves: each finds a planted violation, names its place, and leaves what is allowed alone.
#include "tests/architecture/rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace abrazo::test::rules_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

std::vector<SourceFile> one(const std::string& path, const std::string& text) {
  return {source_file(path, text)};
}

TEST(SourceFile, CountsLinesWithAndWithoutALastLineEnd) {
  EXPECT_THAT(source_file("a", "x\ny").lines, ElementsAre("x", "y"));
  EXPECT_THAT(source_file("a", "x\r\ny\n").lines, ElementsAre("x", "y"));
  EXPECT_THAT(source_file("a", "x\n\ny\n").lines, ElementsAre("x", "", "y"));
}

TEST(SourceFile, FindsIncludesHoweverTheyAreSpaced) {
  const std::vector<Include> found =
      includes_of(source_file("a.cpp", "#include <vector>\n  #  include \"core/a.hpp\"\n"));
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[1].path, "core/a.hpp");
  EXPECT_EQ(found[1].line, 2);
}

TEST(SourceFile, FindsTheLinksOfADocument) {
  const std::string text =
      "[a](b.md#part) and [c](../d.md)\n```\n[](not_a_link)\n```\n![e](images/f.png) "
      "[g](https://example.org) [h](#part)\n";
  const std::vector<DocumentLink> found = links_of(source_file("docs/guide/index.md", text));
  ASSERT_THAT(found, SizeIs(3));
  EXPECT_EQ(found[0].target, "docs/guide/b.md");
  EXPECT_EQ(found[1].target, "docs/d.md");
  EXPECT_EQ(found[2].target, "docs/guide/images/f.png");
  EXPECT_EQ(found[2].line, 5);
}

TEST(ArchitectureRules, CatchQtAndVtkInCore) {
  EXPECT_THAT(core_names_no_toolkit(one("core/mesh/a.cpp", "\n#include <QString>\n")),
              ElementsAre(StartsWith("core/mesh/a.cpp:2: ")));
  EXPECT_THAT(core_names_no_toolkit(one("core/mesh/a.hpp", "#include <QtCore/QObject>\n")), SizeIs(1));
  EXPECT_THAT(core_names_no_toolkit(one("core/mesh/a.hpp", "#include <vtkActor.h>\n")), SizeIs(1));
  EXPECT_THAT(core_names_no_toolkit(one("widgets/scene/a.hpp", "#include <vtkActor.h>\n")), IsEmpty());
  EXPECT_THAT(core_names_no_toolkit(one("core/mesh/a.hpp", "#include <Eigen/QR>\n#include <queue>\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchCoreLinkingAToolkit) {
  EXPECT_THAT(
      core_names_no_toolkit(one("core/CMakeLists.txt", "target_link_libraries(a PRIVATE Qt5::Core)\n")),
      SizeIs(1));
  EXPECT_THAT(
      core_names_no_toolkit(one("core/CMakeLists.txt", "target_link_libraries(a ${VTK_LIBRARIES})\n")),
      SizeIs(1));
  EXPECT_THAT(core_names_no_toolkit(one("core/CMakeLists.txt", "# No Qt5, no VTK\n")), IsEmpty());
}

TEST(ArchitectureRules, CatchAnUpwardAndASidewaysInclude) {
  EXPECT_THAT(core_folders_include_downwards(one("core/mesh/a.cpp", "#include \"core/library/b.hpp\"\n")),
              ElementsAre(HasSubstr("core/mesh may not include from core/library")));
  EXPECT_THAT(
      core_folders_include_downwards(one("core/selection/a.cpp", "#include \"core/retarget/b.hpp\"\n")),
      SizeIs(1));
  EXPECT_THAT(core_folders_include_downwards(one("core/stream/a.cpp", "#include \"core/mesh/b.hpp\"\n")),
              SizeIs(1));
  EXPECT_THAT(core_folders_include_downwards(one("core/library/a.cpp", "#include \"core/mesh/b.hpp\"\n")),
              IsEmpty());
  EXPECT_THAT(core_folders_include_downwards(one("core/mesh/a.cpp", "#include \"core/mesh/b.hpp\"\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchAFolderWithoutARow) {
  EXPECT_THAT(core_folders_include_downwards(one("core/magic/a.cpp", "#include \"core/base/b.hpp\"\n")),
              ElementsAre(HasSubstr("has no row")));
}

TEST(ArchitectureRules, HaveATableWithoutCircles) {
  // Takes away again and again the folders that see only what is gone; a circle would stay.
  std::map<std::string, std::set<std::string>> left = core_table();
  std::set<std::string> gone;
  while (!left.empty()) {
    const auto lowest =
        std::ranges::find_if(left, [&](const auto& row) { return std::ranges::includes(gone, row.second); });
    ASSERT_NE(lowest, left.end()) << "a circle through " << left.begin()->first;
    gone.insert(lowest->first);
    left.erase(lowest);
  }
}

TEST(ArchitectureRules, CatchARoomThatSeesOneAboveOrBesideIt) {
  EXPECT_THAT(rooms_include_downwards(
                  one("core/session/file/a.cpp", "\n#include \"core/session/run/recorder.hpp\"\n")),
              ElementsAre(StartsWith("core/session/file/a.cpp:2: core/session/file may not include from "
                                     "core/session/run")));
  EXPECT_THAT(
      rooms_include_downwards(one("core/stream/vmc/a.hpp", "#include \"core/stream/natnet/b.hpp\"\n")),
      SizeIs(1));
  EXPECT_THAT(rooms_include_downwards(
                  one("app/workbench/video/a.cpp", "#include \"app/workbench/stream/stream_desk.hpp\"\n")),
              SizeIs(1));
  EXPECT_THAT(
      rooms_include_downwards(one("core/session/run/a.cpp", "#include \"core/session/file/b.hpp\"\n")),
      IsEmpty());
  EXPECT_THAT(rooms_include_downwards(one("core/session/run/a.cpp", "#include \"core/session/run/b.hpp\"\n")),
              IsEmpty());
  EXPECT_THAT(
      rooms_include_downwards(one("core/session/file/a.cpp", "#include \"core/stream/receive/b.hpp\"\n")),
      IsEmpty());
  EXPECT_THAT(rooms_include_downwards(
                  one("app/workbench/start/main.cpp", "#include \"app/workbench/stream/stream_desk.hpp\"\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchAFileInNoRoom) {
  EXPECT_THAT(rooms_include_downwards(one("core/session/a.cpp", "")),
              ElementsAre(HasSubstr("stands in no room of core/session")));
  EXPECT_THAT(rooms_include_downwards(one("core/session/cellar/a.cpp", "")),
              ElementsAre(HasSubstr("has no row")));
  EXPECT_THAT(rooms_include_downwards(one("core/session/CMakeLists.txt", "")), IsEmpty());
  EXPECT_THAT(rooms_include_downwards(one("core/mesh/a.cpp", "")), IsEmpty());
}

TEST(ArchitectureRules, CatchAnExceptionThatIsNotNeededAnyMore) {
  EXPECT_THAT(room_exceptions_are_needed({}), SizeIs(room_exceptions().size()));
  const RoomException& first = room_exceptions().front();
  const std::string text = "#include \"" + std::string(first.include) + "\"\n";
  EXPECT_THAT(room_exceptions_are_needed(one(std::string(first.file), text)),
              SizeIs(room_exceptions().size() - 1));
  EXPECT_THAT(rooms_include_downwards(one(std::string(first.file), text)), IsEmpty());
}

TEST(ArchitectureRules, HaveRoomsWithoutCircles) {
  for (const auto& [folder, rooms] : room_table()) {
    Rooms left = rooms;
    std::set<std::string> gone;
    while (!left.empty()) {
      const auto lowest = std::ranges::find_if(
          left, [&](const auto& row) { return std::ranges::includes(gone, row.second); });
      ASSERT_NE(lowest, left.end()) << "a circle through " << folder << "/" << left.begin()->first;
      gone.insert(lowest->first);
      left.erase(lowest);
    }
  }
}

TEST(ArchitectureRules, CatchACrowdedFolder) {
  std::vector<SourceFile> files;
  for (int i = 0; i < 51; ++i)
    files.push_back(source_file("core/session/file/f" + std::to_string(i) + ".cpp", ""));
  EXPECT_THAT(folders_are_not_crowded(files), ElementsAre(StartsWith("core/session/file has 51 files")));
  files.pop_back();
  EXPECT_THAT(folders_are_not_crowded(files), IsEmpty());
}

TEST(ArchitectureRules, CatchAValueOfTheSceneThatDraws) {
  EXPECT_THAT(scene_values_know_no_toolkit(one("widgets/scene/values/a.cpp", "#include <vtkActor.h>\n")),
              SizeIs(1));
  EXPECT_THAT(scene_values_know_no_toolkit(one("widgets/scene/actors/a.cpp", "#include <vtkActor.h>\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchALowerLayerThatKnowsAHigher) {
  EXPECT_THAT(layers_point_down(one("core/base/a.cpp", "#include \"widgets/common/b.hpp\"\n")), SizeIs(1));
  EXPECT_THAT(layers_point_down(one("widgets/scene/a.cpp", "#include \"app/workbench/b.hpp\"\n")), SizeIs(1));
  EXPECT_THAT(layers_point_down(one("app/workbench/a.cpp", "#include \"widgets/common/b.hpp\"\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchTheCommandLineReachingForWidgets) {
  EXPECT_THAT(command_line_knows_no_widgets(one("app/cli/a.cpp", "#include <QApplication>\n")), SizeIs(1));
  EXPECT_THAT(command_line_knows_no_widgets(one("app/workbench/a.cpp", "#include <QApplication>\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchAPythonModuleThatNeedsMoreThanCore) {
  EXPECT_THAT(python_knows_core_alone(one("app/python/a.cpp", "#include <vtkActor.h>\n")), SizeIs(1));
  EXPECT_THAT(python_knows_core_alone(one("app/python/a.cpp", "#include \"widgets/scene/b.hpp\"\n")),
              SizeIs(1));
  EXPECT_THAT(python_knows_core_alone(one("app/python/a.cpp", "#include \"app/cli/command_line.hpp\"\n")),
              SizeIs(1));
  EXPECT_THAT(python_knows_core_alone(one(
                  "app/python/a.cpp", "#include \"app/python/b.hpp\"\n#include \"core/base/text.hpp\"\n")),
              IsEmpty());
  EXPECT_THAT(third_parties_have_one_place(one("core/base/a.cpp", "#include <pybind11/numpy.h>\n")),
              SizeIs(1));
  EXPECT_THAT(third_parties_have_one_place(one("app/python/a.cpp", "#include <pybind11/numpy.h>\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchARendererThatOpensAWindow) {
  EXPECT_THAT(renderer_draws_only_the_scene(one("app/render/a.cpp", "#include \"widgets/plots/b.hpp\"\n")),
              SizeIs(1));
  EXPECT_THAT(renderer_draws_only_the_scene(one("app/render/a.cpp", "#include \"app/workbench/b.hpp\"\n")),
              SizeIs(1));
  EXPECT_THAT(renderer_draws_only_the_scene(one("app/render/render_options.cpp", "#include <QSize>\n")),
              SizeIs(1));
  EXPECT_THAT(renderer_draws_only_the_scene(
                  one("app/render/a.cpp", "#include <QImage>\n#include \"widgets/scene/b.hpp\"\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchAThirdPartyOutsideItsPlace) {
  EXPECT_THAT(third_parties_have_one_place(one("core/library/a.cpp", "#include <tetgen.h>\n")),
              ElementsAre(HasSubstr("TetGen may be named only in core/mesh/tetrahedralize.cpp")));
  EXPECT_THAT(third_parties_have_one_place(one("core/mesh/tetrahedralize.cpp", "#include <tetgen.h>\n")),
              IsEmpty());
  EXPECT_THAT(third_parties_have_one_place(
                  one("core/mesh/tetrahedralize.cpp", "#include <CGAL/Delaunay_triangulation_3.h>\n")),
              ElementsAre(HasSubstr("CGAL may be named only in tests/")));
  EXPECT_THAT(
      third_parties_have_one_place(one("core/library/store/pose_index.cpp", "#include <flann/flann.hpp>\n")),
      ElementsAre(HasSubstr("FLANN may be named only in core/library/store/flann_tree.cpp")));
  EXPECT_THAT(third_parties_have_one_place(one("core/session/a.cpp", "#include <hdf5.h>\n")), SizeIs(1));
  EXPECT_THAT(third_parties_have_one_place(one("widgets/plots/a.cpp", "#include <vtkActor.h>\n")), SizeIs(1));
  EXPECT_THAT(
      third_parties_have_one_place(one("app/workbench/a.cpp", "#include <QVTKOpenGLNativeWidget.h>\n")),
      SizeIs(1));
  EXPECT_THAT(third_parties_have_one_place(one("widgets/scene/a.cpp", "#include <opencv2/core.hpp>\n")),
              SizeIs(1));
  EXPECT_THAT(third_parties_have_one_place(one("widgets/plots/a.cpp", "#include <qcustomplot.h>\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchASecondPlaceOfAThirdParty) {
  const SourceFile first = source_file("core/session/a.cpp", "#include <sqlite3.h>\n");
  const SourceFile second = source_file("core/session/b.cpp", "#include <sqlite3.h>\n");
  EXPECT_THAT(third_parties_have_one_place(std::vector{first}), IsEmpty());
  EXPECT_THAT(third_parties_have_one_place(std::vector{first, second}),
              ElementsAre(StartsWith("core/session/b.cpp:1: ")));
  EXPECT_THAT(third_parties_have_one_place(one("core/session/a.hpp", "#include <sqlite3.h>\n")), SizeIs(1));
}

TEST(ArchitectureRules, CatchAWidgetThatReachesForTheSolver) {
  for (const char* header : {"core/session/run/solver_thread.hpp", "core/stream/receive/clip_source.hpp",
                             "core/motion/bvh/bvh.hpp", "core/synthesis/step/partner_synthesizer.hpp",
                             "core/library/store/motion_library_file.hpp", "core/base/atomic_file.hpp"}) {
    const std::string text = std::string("#include \"") + header + "\"\n";
    EXPECT_THAT(widgets_see_only_snapshots(one("widgets/scene/a.cpp", text)), SizeIs(1)) << header;
  }
  EXPECT_THAT(widgets_see_only_snapshots(
                  one("widgets/scene/a.cpp", "#include \"core/session/frames/command.hpp\"\n")),
              IsEmpty());
  EXPECT_THAT(widgets_see_only_snapshots(one("widgets/scene/a.cpp", "#include \"core/mesh/capsules.hpp\"\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchWidgetFoldersThatKnowEachOther) {
  EXPECT_THAT(widget_folders_are_strangers(one("widgets/scene/a.cpp", "#include \"widgets/plots/b.hpp\"\n")),
              SizeIs(1));
  EXPECT_THAT(widget_folders_are_strangers(one("widgets/scene/a.cpp", "#include \"widgets/common/b.hpp\"\n")),
              IsEmpty());
  EXPECT_THAT(widget_folders_are_strangers(one("widgets/scene/a.cpp", "#include \"widgets/scene/b.hpp\"\n")),
              IsEmpty());
}

TEST(ArchitectureRules, CatchAnOptionInASentenceOfCore) {
  for (const char* named : {R"re(return Error{"set the rate (--fps)", where};)re",
                            R"re(return {"no", "--up"};)re", R"re(  "with --joints NAME";  // why)re"})
    EXPECT_THAT(core_names_no_option(one("core/motion/a.cpp", named)), SizeIs(1)) << named;
  for (const char* fine : {R"re(colour = "var(--ink,#fff)";)re", R"re(--count;  // "--fps")re"})
    EXPECT_THAT(core_names_no_option(one("core/motion/a.cpp", fine)), IsEmpty()) << fine;
  EXPECT_THAT(core_names_no_option(one("app/cli/a.cpp", R"re(return " (--fps)";)re")), IsEmpty());
}

TEST(ArchitectureRules, CatchASignalOfAnotherObject) {
  for (const char* foreign :
       {"emit m_window.failed(why);", "emit panel->chosen(1);", "emit view()->sought(2);"})
    EXPECT_THAT(signals_are_of_their_own_object(one("app/a/b.cpp", foreign)), SizeIs(1)) << foreign;
  for (const char* own : {"emit chosen(1);", "emit this->kept();", "return emit failed(error.text());"})
    EXPECT_THAT(signals_are_of_their_own_object(one("widgets/a/b.cpp", own)), IsEmpty()) << own;
}

TEST(ArchitectureRules, CatchFilesThatGrewTooLong) {
  EXPECT_THAT(at_most_lines(one("docs/a.md", "1\n2\n3\n"), "docs/a.md", 2),
              ElementsAre(StartsWith("docs/a.md:3: 3 lines")));
  EXPECT_THAT(at_most_lines(one("docs/a.md", "1\n2\n3\n"), "docs/a.md", 3), IsEmpty());
  EXPECT_THAT(at_most_lines(one("docs/b.md", "1\n2\n3\n"), "docs/a.md", 2), IsEmpty());
  EXPECT_THAT(at_most_lines(one("app/a/b_actions.cpp", "1\n2\n3\n"), "app/", 2, "_actions.cpp"), SizeIs(1));
  EXPECT_THAT(at_most_lines(one("app/a/b_desk.cpp", "1\n2\n3\n"), "app/", 2, "_actions.cpp"), IsEmpty());
}

TEST(ArchitectureRules, CatchAnUnknownFileOrFolderAtTheTopLevel) {
  const SourceFile ignored = source_file(".gitignore", "/build/\n/out/\n*~\n");
  EXPECT_THAT(top_level_is_known(std::vector<std::string>{"files", "core", "a.log"}, ignored),
              ElementsAre(StartsWith("files at the top level"), StartsWith("a.log at the top level")));
  EXPECT_THAT(top_level_is_known(std::vector<std::string>{".git", "build", "out", "README.md~"}, ignored),
              IsEmpty());
  EXPECT_THAT(top_level_is_known(std::vector<std::string>{"build"}, source_file(".gitignore", "\n")),
              SizeIs(1));
}

TEST(ArchitectureRules, CatchACorpusThatGrew) {
  std::vector<std::string> paths;
  for (int i = 0; i < 12; ++i) paths.push_back("tests/fuzz/corpus/bvh/" + std::to_string(i));
  paths.push_back("tests/fuzz/corpus/trc/0");
  EXPECT_THAT(corpora_are_small(paths), IsEmpty());
  paths.push_back("tests/fuzz/corpus/bvh/12");
  EXPECT_THAT(corpora_are_small(paths), ElementsAre(StartsWith("tests/fuzz/corpus/bvh has 13 seeds")));
}

TEST(ArchitectureRules, CatchAHeaderWithoutPragmaOnce) {
  EXPECT_THAT(headers_have_pragma_once(one("core/a.hpp", "#include <vector>\n")), SizeIs(1));
  EXPECT_THAT(headers_have_pragma_once(one("core/a.hpp", "")), SizeIs(1));
  EXPECT_THAT(headers_have_pragma_once(one("core/a.hpp", "#pragma once\n")), IsEmpty());
  EXPECT_THAT(headers_have_pragma_once(one("core/a.cpp", "#include <vector>\n")), IsEmpty());
}

TEST(ArchitectureRules, CatchAPathOfOneMachine) {
  const std::string home = std::string("/") + "home/";
  EXPECT_THAT(no_path_of_a_machine(one("docs/a.md", "see\n`" + home + "me/x`\n")),
              ElementsAre(StartsWith("docs/a.md:2: ")));
  EXPECT_THAT(no_path_of_a_machine(one("docs/a.md", "https://example.org" + home + "\n")), IsEmpty());
}

}  // namespace
}  // namespace abrazo::test::rules_test
