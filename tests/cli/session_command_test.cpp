#include <filesystem>

#include "core/session/file/project.hpp"
#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::session_command_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class SessionCommand : public CommandLineTest {
 protected:
  void old_session(const std::string& name) {
    std::filesystem::copy_file(std::string(ABRAZO_FIXTURES) + "/session/version_1.abrazo", path(name));
  }
};

TEST_F(SessionCommand, TellsWhatAnOldFileHasAndWhatMigrationWillDo) {
  old_session("old.abrazo");
  const Outcome outcome = run("session info old.abrazo");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("version    1"));
  EXPECT_THAT(outcome.out, HasSubstr("bring it to version 2"));
  EXPECT_THAT(outcome.out, HasSubstr("recorded   4 frames"));
  EXPECT_THAT(outcome.out, HasSubstr("take       salsa 3"));
  EXPECT_THAT(outcome.out, HasSubstr("annotated  the session: 3 in 3 tiers"));
}

TEST_F(SessionCommand, MigratesAnOldFileOnce) {
  old_session("old.abrazo");
  const Outcome outcome = run("session migrate old.abrazo");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "old.abrazo: version 1 is now version 2\n");
  EXPECT_EQ(run("session migrate old.abrazo").out, "old.abrazo: is of version 2 already\n");
  EXPECT_THAT(run("session info old.abrazo").out, Not(HasSubstr("migration")));
}

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
  EXPECT_EQ(told["version"], 2);
  EXPECT_EQ(told["migration"], "");
  EXPECT_EQ(told["markers"], 1);
  EXPECT_EQ(told["data"][0]["use"], "library");
  EXPECT_EQ(told["data"][0]["state"], "changed");
  EXPECT_EQ(told["data"][1]["state"], "missing");
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
  expect_failure(run("session migrate notes.txt"), "not a session file");
  expect_failure(run("session info nothing.abrazo"), "there is no such file");
  expect_failure(run("session migrate nothing.abrazo"), "there is no such file");
}

}  // namespace
}  // namespace abrazo::test::session_command_test
