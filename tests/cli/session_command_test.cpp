#include "core/session/file/project.hpp"
#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::session_command_test {
namespace {

using ::testing::HasSubstr;

using SessionCommand = CommandLineTest;

TEST_F(SessionCommand, TellsWhereTheDataIsAndWhatIsMissing) {
  write("lib.h5", "pairs");
  Project project;
  project.data.push_back(*reference_to(path("lib.h5"), DataReference::Use::Library, path("s.abrazo")));
  project.data.push_back(*reference_to(path("lib.h5"), DataReference::Use::Motion, path("s.abrazo")));
  project.data[1].relative_path = "gone.bvh";
  project.data[1].absolute_path = path("gone.bvh");
  project.markers.add(1, "clap");
  ASSERT_TRUE(save_project(path("s.abrazo"), project));
  write("lib.h5", "other");
  const auto told = nlohmann::json::parse(run("session info s.abrazo --json").out);
  EXPECT_EQ(told["version"], 1);
  EXPECT_EQ(told["markers"], 1);
  EXPECT_EQ(told["data"][0]["use"], "library");
  EXPECT_EQ(told["data"][0]["state"], "changed");
  EXPECT_EQ(told["data"][1]["state"], "missing");
  EXPECT_THAT(run("session info s.abrazo").out, HasSubstr("version    1\n"));
  EXPECT_THAT(run("session info s.abrazo").out, HasSubstr("missing: "));
}

TEST_F(SessionCommand, NamesInASessionNeitherSteerATerminalNorPassForLinesOfTheAnswer) {
  Project project;
  project.annotations[hostile_name];
  project.data.push_back(DataReference{});
  project.data[0].relative_path = hostile_name;
  ASSERT_TRUE(save_project(path("s.abrazo"), project));
  expect_harmless(run("session info s.abrazo").out);
}

TEST_F(SessionCommand, RefusesWhatIsNoneWithOneSentence) {
  write("notes.txt",
        "This is a letter, and much longer than the head of a database would have to be for it.");
  expect_failure(run("session info notes.txt"), "not a session file");
  expect_failure(run("session info nothing.abrazo"), "there is no such file");
}

}  // namespace
}  // namespace abrazo::test::session_command_test
