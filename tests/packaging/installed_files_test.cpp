#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "core/base/text.hpp"
#include "tests/cli/run_command.hpp"
#include "tests/packaging/installed_files.hpp"

namespace abrazo::test::installed_files_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string below(const fs::path& folder, const fs::path& file) {
  return file.lexically_relative(folder).generic_string();
}

/// What the first group of an expression matches, in the order it stands there.
std::vector<std::string> matches(const std::string& text, const std::string& expression) {
  const std::regex pattern(expression);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

TEST(Installation, HasTheProgramsTheirPagesTheGuideAndTheLicence) {
  std::vector<std::string> wanted = {"bin/abrazo",
                                     "libexec/abrazo/abrazo-scene-reader",
                                     "libexec/abrazo-dev/abrazo-scene-reader",
                                     "share/man/man1/abrazo.1",
                                     "share/doc/abrazo/copyright",
                                     "share/doc/abrazo/docs/guide/index.md"};
  if (ABRAZO_HAS_WORKBENCH) {
    for (const char* name :
         {"bin/abrazo-render", "bin/abrazo-workbench", "share/man/man1/abrazo-render.1",
          "share/man/man1/abrazo-workbench.1", "share/applications/abrazo.desktop",
          "share/mime/packages/abrazo.xml", "share/metainfo/abrazo.metainfo.xml",
          "share/icons/hicolor/scalable/apps/abrazo.svg", "share/icons/hicolor/48x48/apps/abrazo.png",
          "share/icons/hicolor/128x128/apps/abrazo.png", "share/icons/hicolor/256x256/apps/abrazo.png"})
      wanted.emplace_back(name);
  }
  for (const std::string& name : wanted) EXPECT_TRUE(fs::is_regular_file(installed(name))) << name;
}

/// Debian packages that .ci/packages lists below a heading, those of every suite.
std::vector<std::string> packages_below(const std::string& heading) {
  std::vector<std::string> packages;
  bool is_below = false;
  const std::string list = content_of(fs::path(ABRAZO_SOURCE_DIR) / ".ci/packages");
  for (const std::string_view line : split_lines(list)) {
    if (line.starts_with('#')) is_below = line == "# " + heading;
    if (!is_below) continue;
    for (const std::string& package :
         matches(std::string(line.substr(0, line.find_first_of("#["))), "([a-z0-9][a-z0-9.+-]+)"))
      packages.push_back(package);
  }
  return packages;
}

TEST(Licences, NameEveryLibraryThatTheProgramsAreBuiltWith) {
  const std::string licences = content_of(installed("share/doc/abrazo/copyright"));
  EXPECT_NE(licences.find("GNU AFFERO GENERAL PUBLIC LICENSE"), std::string::npos) << licences.size();
  for (const char* heading : {"engine and command line", "Python module", "workbench"}) {
    const std::vector<std::string> packages = packages_below(heading);
    EXPECT_GT(packages.size(), 2U) << heading;
    for (const std::string& package : packages) {
      if (package.starts_with("fonts-")) continue;
      EXPECT_NE(licences.find(package), std::string::npos) << package << " of " << heading;
    }
  }
}

TEST(Licences, NameNothingThatTheProgramsAreNotBuiltWith) {
  std::set<std::string> built_with;
  for (const char* heading : {"engine and command line", "Python module", "workbench"})
    for (const std::string& package : packages_below(heading)) built_with.insert(package);
  const std::string licences = content_of(installed("share/doc/abrazo/copyright"));
  const std::string tables = licences.substr(0, licences.find("GNU AFFERO GENERAL PUBLIC LICENSE"));
  for (const std::string& package : matches(tables, R"(([a-z0-9]+[a-z0-9.-]*-dev)\b)"))
    EXPECT_TRUE(built_with.contains(package)) << package;
}

TEST(Licences, ComeWithTheNoticesOfWhatIsCompiledIn) {
  if (!fs::exists("/usr/share/doc/libeigen3-dev/copyright"))
    GTEST_SKIP() << "only Debian has them in one place";
  for (const char* package :
       {"libeigen3-dev", "libflann-dev", "nlohmann-json3-dev", "libcli11-dev", "libfmt-dev"})
    EXPECT_FALSE(
        content_of(installed("share/doc/abrazo/third-party/" + std::string(package) + ".txt")).empty())
        << package;
}

TEST(Installation, HasThePythonModuleWithItsStubs) {
  if (!ABRAZO_HAS_PYTHON) GTEST_SKIP() << "built without the Python module";
  const fs::path package = installed("lib/python3/dist-packages/abrazo");
  for (const char* name : {"__init__.py", "__init__.pyi", "py.typed"})
    EXPECT_TRUE(fs::is_regular_file(package / name)) << name;
  EXPECT_TRUE(fs::is_regular_file(package / "abrazo-scene-reader"));
  std::size_t modules = 0;
  for (const fs::path& file : installed_files("lib/python3/dist-packages/abrazo"))
    if (file.extension() == ".so") ++modules;
  EXPECT_EQ(modules, 1U);
}

TEST(Installation, HasThePartThatReadsVideos) {
  if (!ABRAZO_HAS_WORKBENCH) GTEST_SKIP() << "built without the workbench";
  EXPECT_TRUE(fs::is_regular_file(installed(ABRAZO_LIBRARIES) / "abrazo" / "libabrazo-video.so"));
}

TEST(Installation, NamesNeitherTheSourcesNorTheBuild) {
  for (const fs::path& file : installed_files()) {
    const std::string content = content_of(file);
    for (const std::string folder : {ABRAZO_SOURCE_DIR "/", ABRAZO_BUILD_DIR "/"})
      EXPECT_EQ(content.find(folder), std::string::npos) << file << " names " << folder;
  }
}

TEST(Installation, RunsTheProgramFromAnyPlace) {
  const fs::path elsewhere = fs::temp_directory_path() / ("abrazo-moved-" + std::to_string(::getpid()));
  fs::create_directories(elsewhere);
  fs::copy_file(installed("bin/abrazo"), elsewhere / "abrazo");
  const Outcome told =
      RunningCommand({(elsewhere / "abrazo").string(), "--version"}, fs::temp_directory_path()).wait();
  fs::remove_all(elsewhere);
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_THAT(told.out, ::testing::StartsWith("abrazo 0."));
}

/// Of reading a scene without an animation, which only its reader can tell.
std::string told_of_a_scene(const fs::path& program) {
  return RunningCommand(
             {program.string(), "motion", "info", ABRAZO_FIXTURES "/motion/broken/no_animation.gltf"},
             fs::temp_directory_path())
      .wait()
      .err;
}

TEST(Installation, FindsWhatReadsScenesAndRefusesThemWithoutIt) {
  EXPECT_THAT(told_of_a_scene(installed("bin/abrazo")), HasSubstr("holds no animation"));
  const fs::path elsewhere = fs::temp_directory_path() / ("abrazo-alone-" + std::to_string(::getpid()));
  fs::create_directories(elsewhere);
  fs::copy_file(installed("bin/abrazo"), elsewhere / "abrazo");
  EXPECT_THAT(told_of_a_scene(elsewhere / "abrazo"),
              HasSubstr("abrazo-scene-reader, which reads FBX, glTF and Collada, is missing"));
  fs::copy_file(installed("libexec/abrazo-dev/abrazo-scene-reader"), elsewhere / "abrazo-scene-reader");
  EXPECT_THAT(told_of_a_scene(elsewhere / "abrazo"), HasSubstr("holds no animation"));
  fs::remove_all(elsewhere);
}

TEST(Installation, OnlyWhatReadsScenesIsLinkedWithTheirLibrary) {
  for (const fs::path& file : installed_files()) {
    const std::string content = content_of(file);
    if (!content.starts_with("\x7f"
                             "ELF"))
      continue;
    const bool is_linked = content.find("libassimp.so") != std::string::npos;
    EXPECT_EQ(is_linked, file.filename() == "abrazo-scene-reader") << file;
  }
}

TEST(Installation, LinksOfTheGuideLeadToWhatIsInstalled) {
  for (const fs::path& page : installed_files("share/doc/abrazo/docs/guide")) {
    for (const std::string& link : matches(content_of(page), R"(\]\(([^)#\s:]+)(?:#[^)]*)?\))"))
      EXPECT_TRUE(fs::exists(page.parent_path() / link)) << page.filename() << " leads to " << link;
  }
}

TEST(InstalledHeaders, NameOnlyOneAnotherEigenAndTheStandardLibrary) {
  const fs::path root = installed("include/abrazo");
  const std::vector<fs::path> headers = installed_files("include");
  ASSERT_GT(headers.size(), 200U);
  for (const fs::path& header : headers) {
    const std::string text = content_of(header);
    for (const std::string& own : matches(text, "#include \"([^\"]+)\""))
      EXPECT_TRUE(fs::exists(root / own)) << below(root, header) << " includes " << own;
    for (const std::string& other : matches(text, "#include <([^>]+)>"))
      EXPECT_TRUE(other.starts_with("Eigen/") || other.find_first_of("./") == std::string::npos)
          << below(root, header) << " includes " << other;
  }
}

TEST(InstalledHeaders, CompileAloneAsTheirOwnSourceIncludesThemFirst) {
  const fs::path root = installed("include/abrazo");
  int sources = 0;
  for (const fs::path& header : installed_files("include")) {
    const std::string name = below(root, header);
    fs::path source = fs::path(ABRAZO_SOURCE_DIR) / name;
    source.replace_extension(".cpp");
    if (!fs::exists(source)) continue;  // compiled by tests/packaging/CMakeLists.txt
    const std::vector<std::string> includes = matches(content_of(source), "#include [<\"]([^>\"]+)[>\"]");
    ASSERT_FALSE(includes.empty()) << source;
    EXPECT_EQ(includes.front(), name) << source;
    ++sources;
  }
  EXPECT_GT(sources, 200);
}

TEST(InstalledHeaders, AreThoseOfTheEngineAndHaveTheirCodeInIt) {
  const std::string root = installed("include/abrazo").string();
  EXPECT_TRUE(fs::exists(root + "/core/synthesis/step/partner_synthesizer.hpp"));
  EXPECT_TRUE(fs::exists(root + "/core/video/camera_model.hpp"));
  EXPECT_FALSE(fs::exists(root + "/core/video/video_reader.hpp")) << "its code is in the workbench";
}

}  // namespace
}  // namespace abrazo::test::installed_files_test
