#include "core/opening/session_frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/file/session_database.hpp"
#include "tests/core/opening/opening_files.hpp"

namespace abrazo::session_frames_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Half a second, recorded with a library that lies beside it.
class SessionFramesTest : public testing::Test {
 protected:
  void SetUp() override {
    const test::LibraryPtr library = test::built_of(test::two_takes(folder)).library;
    library_file = folder.file("dance.h5");
    ASSERT_TRUE(write_library(*library, library_file));
    path = folder.file("s.abrazo");
    test::record(path, library, library_file);
  }
  void change(const std::string& sql) const {
    auto database = SessionDatabase::open(path, SessionDatabase::Access::Write);
    ASSERT_TRUE(database) << database.error().text();
    ASSERT_TRUE(database->execute(sql));
    ASSERT_TRUE(database->close());
  }
  /// The frames of a walk by index; -1 for one that cannot be read.
  static std::vector<int> indices(const SessionFrames& session) {
    std::vector<int> found;
    SessionWalk walk(session);
    for (;;) {
      const auto frame = walk.next();
      if (frame && !*frame) return found;
      found.push_back(frame ? static_cast<int>((*frame)->index) : -1);
    }
  }

  test::TemporaryFolder folder;
  std::string path, library_file;
};

TEST_F(SessionFramesTest, AreGoneThroughInTheirOrderWithMeshAndSource) {
  const auto session = open_session_frames(path);
  ASSERT_TRUE(session) << session.error().text();
  EXPECT_THAT(session->warnings, IsEmpty());
  SessionWalk walk(*session);
  std::uint64_t index = session->contents.first_frame;
  for (auto frame = walk.next(); *frame; frame = walk.next()) {
    EXPECT_EQ((*frame)->index, index++);
    EXPECT_NE((*frame)->library, nullptr);
    EXPECT_FALSE((*frame)->result.edges.empty());
  }
  EXPECT_EQ(index, session->contents.last_frame + 1);
}

TEST_F(SessionFramesTest, ThatAreDamagedAreSaidOnEveryWalkAndDoNotEndIt) {
  change("UPDATE frames SET active = zeroblob(10) WHERE frame = 3");
  change("DELETE FROM frames WHERE frame = 5 OR frame > 7");
  const auto session = open_session_frames(path);
  ASSERT_TRUE(session) << session.error().text();
  for (int walks = 0; walks < 2; ++walks) EXPECT_THAT(indices(*session), ElementsAre(0, 1, 2, -1, 4, 6, 7));
  SessionWalk walk(*session);
  for (int frame = 0; frame < 3; ++frame) ASSERT_TRUE(walk.next());
  EXPECT_THAT(walk.next().error().text(), HasSubstr("s.abrazo: its frame 3 cannot be read: "));
}

TEST_F(SessionFramesTest, HaveNoMeshWithoutTheirLibraryUntilItIsGiven) {
  const std::string elsewhere = folder.file("moved.h5");
  std::filesystem::rename(library_file, elsewhere);
  const auto without = open_session_frames(path);
  ASSERT_TRUE(without) << without.error().text();
  EXPECT_THAT(without->warnings, ElementsAre(HasSubstr("dance.h5")));
  EXPECT_TRUE((*SessionWalk(*without).next())->result.edges.empty());
  const auto given = open_session_frames(path, elsewhere);
  ASSERT_TRUE(given) << given.error().text();
  EXPECT_FALSE((*SessionWalk(*given).next())->result.edges.empty());
}

TEST_F(SessionFramesTest, AreRefusedWhereNothingWasRecorded) {
  const std::string project = folder.file("project.abrazo");
  test::save(project, test::built_of(test::two_takes(folder, "others")));
  EXPECT_THAT(open_session_frames(project).error().text(), HasSubstr("project.abrazo: has no frames"));
}

}  // namespace
}  // namespace abrazo::session_frames_test
