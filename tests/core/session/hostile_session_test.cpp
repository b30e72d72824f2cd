// Session files that somebody made to harm, and what lies beside them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_edit.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::hostile_session_test {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

/// A recorded session that statements of its maker can be added to.
class HostileSession : public testing::Test, protected test::TemporaryFolder {
 protected:
  HostileSession() {
    test::DrivenSession session;
    session.keeper->recorder = *Recorder::open(path_, test::session_facts());
    session.run_until(0.3);
    EXPECT_TRUE(session.keeper->recorder->finish());
  }
  /// As its maker would: with a database that is not held back by anything.
  void run(const std::string& sql) {
    const std::string command = "sqlite3 '" + path_ + "' \"" + sql + "\"";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }
  /// All the ways in which a session is opened.
  void expect_refused(const std::string& why) {
    const std::string before = *read_whole_file(path_);
    const auto file = SessionFile::open(path_);
    ASSERT_FALSE(file);
    EXPECT_THAT(file.error().text(), AllOf(HasSubstr("s.abrazo"), HasSubstr(why)));
    for (const Status& status :
         {Status(Recorder::open(path_, test::session_facts()) ? Status(Done{}) : Status(Error{"", ""})),
          save_project(path_, Project{}), edit_session_takes(path_, {{"take 1", "x"}}),
          copy_session(path_, TemporaryFolder::file("copy.abrazo")),
          load_project(path_) ? Status(Done{}) : Status(Error{"", ""})})
      EXPECT_FALSE(status);
    EXPECT_EQ(*read_whole_file(path_), before) << "it is left as it is";
  }

  const std::string path_ = TemporaryFolder::file("s.abrazo");
};

TEST_F(HostileSession, ATriggerIsRefused) {
  run("CREATE TRIGGER evil AFTER INSERT ON frames BEGIN DELETE FROM poses; END");
  expect_refused("a trigger 'evil'");
}

TEST_F(HostileSession, AViewInPlaceOfATableIsRefused) {
  // Reading it would never end.
  run("DROP TABLE markers; CREATE VIEW markers AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 "
      "FROM n) "
      "SELECT i AS id, 1 AS run, 1.0 AS time_s, 'x' AS name FROM n");
  expect_refused("a view in place of its table 'markers'");
}

TEST_F(HostileSession, AVirtualTableInPlaceOfATableIsRefused) {
  run("DROP TABLE view_state; CREATE VIRTUAL TABLE view_state USING fts5(key, value)");
  expect_refused("a virtual table in place of its table 'view_state'");
}

TEST_F(HostileSession, AViewThatTheProgramNeverMadeIsNeverRead) {
  run("DROP VIEW sources; CREATE VIEW sources AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 "
      "FROM n) "
      "SELECT i AS frame, 1.0 AS time_s, 'x' AS take, 1 AS take_frame, 0 AS swapped, '' AS label FROM n");
  const auto file = SessionFile::open(path_);
  ASSERT_TRUE(file) << file.error().text();
  std::size_t sources = 0;
  ASSERT_TRUE((*file)->each_source(-1e9, 1e9, [&](const SessionSource&) -> Status {
    ++sources;
    return Done{};
  }));
  EXPECT_EQ(sources, (*file)->contents().frames);
}

TEST_F(HostileSession, ViewsAndTablesOfSomebodysOwnDoNoHarm) {
  run("CREATE VIEW mine AS SELECT count(*) FROM frames; CREATE TABLE notes (text TEXT); CREATE INDEX i ON "
      "poses (time_s)");
  EXPECT_TRUE(SessionFile::open(path_));
  EXPECT_TRUE(save_project(path_, Project{}));
}

TEST_F(HostileSession, IsReadWithoutBeingAbleToWrite) {
  auto database = SessionDatabase::open(path_, SessionDatabase::Access::Read);
  ASSERT_TRUE(database);
  EXPECT_FALSE(database->execute("DELETE FROM frames"));
  EXPECT_FALSE(
      database->execute("ATTACH '" + TemporaryFolder::file("other.db") + "' AS o; CREATE TABLE o.t (x)"));
  EXPECT_FALSE(std::filesystem::exists(TemporaryFolder::file("other.db")) &&
               std::filesystem::file_size(TemporaryFolder::file("other.db")) > 0);
}

TEST_F(HostileSession, LoadsNoExtension) {
  auto database = SessionDatabase::open(path_, SessionDatabase::Access::Read);
  EXPECT_FALSE(database->execute("SELECT load_extension('/nowhere/evil.so')"));
  const auto value = database->integer("SELECT length(zeroblob(300000000))");
  EXPECT_FALSE(value) << "a value larger than any of ours is refused before there is room made for it";
}

/// The end of a rollback journal that names another journal, as SQLite's file format describes it.
std::string journal_that_names(const std::string& victim) {
  const auto number = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
  };
  const std::string magic("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
  std::uint32_t sum = 0;
  for (const char c : victim) sum += static_cast<unsigned char>(c);
  const std::uint32_t page_bytes = 16384, sector = 512;
  std::string journal = magic + number(0) + number(1) + number(1) + number(sector) + number(page_bytes);
  journal.resize(sector, '\0');
  journal += number(0x40000000 / page_bytes + 1) + victim +
             number(static_cast<std::uint32_t>(victim.size())) + number(sum) + magic;
  return journal;
}

TEST_F(HostileSession, AJournalBesideItThatWouldDeleteAnotherFileIsRefused) {
  const std::string victim = TemporaryFolder::file("thesis.tex");
  ASSERT_TRUE(write_whole_file(victim, "three years"));
  ASSERT_TRUE(write_whole_file(path_ + "-journal", journal_that_names(victim)));
  const auto file = SessionFile::open(path_);
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().text(), HasSubstr("Move 's.abrazo-journal' away"));
  EXPECT_FALSE(Recorder::open(path_, test::session_facts()));
  EXPECT_FALSE(save_project(path_, Project{}));
  EXPECT_EQ(*read_whole_file(victim), "three years");
}

TEST_F(HostileSession, AnOrdinaryJournalIsStillPlayedBack) {
  ASSERT_TRUE(write_whole_file(path_ + "-journal", std::string(512, '\0')));
  EXPECT_TRUE(SessionFile::open(path_));
}

// Whoever opened one would wait for a writer, for ever.
TEST_F(HostileSession, APipeBesideItOrInItsPlaceIsRefused) {
  for (const char* ending : {"-journal", "-wal", "-shm"}) {
    const std::string pipe = path_ + ending;
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    expect_refused("s.abrazo" + std::string(ending) + "', which is a pipe");
    std::filesystem::remove(pipe);
  }
  const std::string pipe = TemporaryFolder::file("pipe.abrazo");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto file = SessionFile::open(pipe);
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().text(), HasSubstr("is a pipe, a socket or a device"));
  EXPECT_FALSE(save_project(pipe, Project{}));
}

TEST_F(HostileSession, ALinkInPlaceOfItsLogIsNotWrittenThrough) {
  const std::string victim = TemporaryFolder::file("thesis.tex");
  ASSERT_TRUE(write_whole_file(victim, "three years"));
  std::filesystem::create_symlink(victim, path_ + "-wal");
  (void)Recorder::open(path_, test::session_facts());
  (void)save_project(path_, Project{});
  EXPECT_EQ(*read_whole_file(victim), "three years");
}

TEST_F(HostileSession, ALinkToNowhereIsNotRecordedThrough) {
  const std::string nowhere = TemporaryFolder::file("startup.desktop"),
                    link = TemporaryFolder::file("link.abrazo");
  std::filesystem::create_symlink(nowhere, link);
  const auto recorder = Recorder::open(link, test::session_facts());
  ASSERT_FALSE(recorder);
  EXPECT_NE(recorder.error().text().find("startup.desktop, which does not exist; remove the link"),
            std::string::npos)
      << recorder.error().text();
  EXPECT_FALSE(std::filesystem::exists(nowhere));
}

TEST_F(HostileSession, ALinkToASessionIsGoneOnIn) {
  const std::string link = TemporaryFolder::file("link.abrazo");
  std::filesystem::create_symlink(path_, link);
  EXPECT_TRUE(Recorder::open(link, test::session_facts()));
}

TEST_F(HostileSession, ALinkWhereACopyIsWrittenIsReplacedAndNotFollowed) {
  const std::string victim = TemporaryFolder::file("thesis.tex"), copy = TemporaryFolder::file("copy.abrazo");
  ASSERT_TRUE(write_whole_file(victim, "three years"));
  std::filesystem::create_symlink(victim, copy);
  EXPECT_TRUE(copy_session(path_, copy));
  EXPECT_TRUE(SessionFile::open(copy));
  EXPECT_EQ(*read_whole_file(victim), "three years");
}

TEST_F(HostileSession, ARowLongerThanASessionNeedsIsDamageThatIsNotRead) {
  constexpr int other_columns = 32;
  const auto why = [&](int bytes) {
    run("UPDATE settings SET json = printf('%*s', " + std::to_string(bytes) + ", '')");
    const auto file = SessionFile::open(path_);
    EXPECT_TRUE(file);
    return (*file)->frame(1).error().text();
  };
  EXPECT_THAT(why(limits::session_row_bytes - other_columns), HasSubstr("has 16777184 bytes of settings"));
  EXPECT_THAT(why(limits::session_row_bytes + 1), HasSubstr("the file is damaged (string or blob too big"));
}

TEST_F(HostileSession, ATextLongerThanARowMayBeIsNotWritten) {
  constexpr int other_columns = 32;
  for (const int beyond : {-other_columns, 0, 1}) {
    Project project;
    project.presets.assign(static_cast<std::size_t>(limits::session_row_bytes + beyond), ' ');
    const Status saved = save_project(path_, project);
    EXPECT_EQ(saved.ok(), beyond < 0) << beyond;
    if (!saved) {
      EXPECT_THAT(saved.error().text(), HasSubstr("a text is longer than the 16 MB"));
    }
  }
}

// The clock went back while it was recorded.
TEST_F(HostileSession, ARunDoesNotEndBeforeItBegan) {
  const std::string copy = TemporaryFolder::file("copy.abrazo");
  run("UPDATE runs SET begun_at = '2999-01-01T00:00:00Z', ended_at = NULL");
  ASSERT_TRUE(copy_session(path_, copy));
  auto database = SessionDatabase::open(copy, SessionDatabase::Access::Read);
  ASSERT_TRUE(database);
  EXPECT_EQ(database->integer("SELECT count(*) FROM runs WHERE ended_at >= begun_at")->value_or(0), 1);
}

/// The copy stayed, and looked like a recording that was cut off.
TEST_F(HostileSession, ACopyWhoseRunsCannotBeEndedLeavesNothingBehind) {
  // Two runs without an end, which may not have the same.
  run("UPDATE runs SET ended_at = NULL; CREATE TEMP TABLE one AS SELECT * FROM runs; UPDATE one SET id = id "
      "+ 1; INSERT INTO runs SELECT * FROM one; CREATE UNIQUE INDEX mine ON runs (ended_at)");
  const std::string copy = TemporaryFolder::file("copy.abrazo");
  const auto expect_nothing_new_beside = [&](const std::vector<std::string>& files) {
    const Status copied = copy_session(path_, copy);
    ASSERT_FALSE(copied);
    EXPECT_THAT(copied.error().text(), AllOf(HasSubstr("copy.abrazo"), Not(HasSubstr("partial"))));
    std::vector<std::string> left;
    for (const auto& each : std::filesystem::directory_iterator(TemporaryFolder::file("")))
      left.push_back(each.path().filename().string());
    EXPECT_THAT(left, UnorderedElementsAreArray(files));
  };
  expect_nothing_new_beside({"s.abrazo"});
  ASSERT_TRUE(write_whole_file(copy, "an older one"));
  expect_nothing_new_beside({"s.abrazo", "copy.abrazo"});
  EXPECT_EQ(*read_whole_file(copy), "an older one");
}

}  // namespace
}  // namespace abrazo::hostile_session_test
