// A recording while the disk fills up, or somebody takes the file away.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "core/base/atomic_file.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/core/session/project_values.hpp"
#include "tests/core/session/recorded_session.hpp"
#include "tests/support/broken_world.hpp"

namespace abrazo::recording_faults_test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;

#define NEEDS_A_DISK(disk) \
  if (!(disk).mounted()) GTEST_SKIP() << "this user may not mount a disk of its own; needs root"

/// Two writes within it have the same time.
constexpr std::chrono::milliseconds kernel_tick(20);

struct Recorded : test::DrivenSession {
  explicit Recorded(const std::string& path) {
    auto opened = Recorder::open(path, test::session_facts());
    EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
    if (opened) keeper->recorder = std::move(*opened);
  }
  Recorder& recorder() { return *keeper->recorder; }
  std::size_t solved() const { return keeper->frames.size(); }
};

/// Indices of the frames of a file, which has to be whole.
std::vector<std::uint64_t> frames_in(const std::string& path) {
  std::vector<std::uint64_t> frames;
  const auto file = SessionFile::open(path);
  EXPECT_TRUE(file) << (file ? "" : file.error().text());
  if (!file) return frames;
  const auto pass = (*file)->each_frame(-1e9, 1e9, [&](const FrameSnapshot& frame) -> Status {
    frames.push_back(frame.index);
    return Done{};
  });
  EXPECT_TRUE(pass);
  EXPECT_EQ(pass->damaged, 0U) << pass->damage;
  return frames;
}

void expect_all(const std::vector<std::uint64_t>& frames, std::size_t count) {
  ASSERT_EQ(frames.size(), count);
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(frames[i], i);
}

/// With its log and the log's index, as a file manager takes them.
template <typename Take>
void take_all_of(const std::string& path, const Take& take) {
  for (const char* end : {"", "-wal", "-shm"}) take(path + end, end);
}

/// A session of another program, open, whose rows are committed to its log and nowhere else yet.
struct LiveSessionOfOthers {
  explicit LiveSessionOfOthers(const std::string& path)
      : database(*SessionDatabase::open(path, SessionDatabase::Access::Create)) {
    EXPECT_EQ(database.text("PRAGMA journal_mode=WAL")->value_or(""), "wal");
    EXPECT_TRUE(database.execute("CREATE TABLE theirs (row); INSERT INTO theirs VALUES (1), (2), (3)"));
  }
  /// As whoever opens the file sees them.
  std::int64_t rows() const {
    auto reader = *SessionDatabase::open(database.path(), SessionDatabase::Access::Read);
    const auto count = reader.integer("SELECT count(*) FROM theirs");
    EXPECT_TRUE(count) << count.error().text();
    return count ? count->value_or(-1) : -1;
  }
  SessionDatabase database;
};

class RecordingFaults : public testing::Test, protected test::TemporaryFolder {};

TEST_F(RecordingFaults, WhenTheDiskIsFullTheSessionGoesOnAndWithSpaceAgainNothingIsMissing) {
  const std::string path = file("s.abrazo");
  Recorded session(path);
  session.run_until(0.3);
  ASSERT_TRUE(session.recorder().flush());
  const std::size_t on_disk = session.recorder().state().frames;
  {
    const test::LimitedFiles full(4096);  // the log is written from its beginning again and again
    session.run_until(1);
    EXPECT_FALSE(session.recorder().flush());
    EXPECT_THAT(session.recorder().state().failure, HasSubstr("full"));
    EXPECT_EQ(session.recorder().state().frames, on_disk);
    session.run_until(2);
    EXPECT_GT(session.solved(), 2 * on_disk) << "nobody waits for the disk";
    EXPECT_EQ(frames_in(path).size(), on_disk) << "what was written opens meanwhile";
  }
  ASSERT_TRUE(session.recorder().flush());
  EXPECT_THAT(session.recorder().state().failure, IsEmpty());
  EXPECT_EQ(session.recorder().state().lost, 0U);
  ASSERT_TRUE(session.recorder().finish());
  expect_all(frames_in(path), session.solved());
}

TEST_F(RecordingFaults, ARecordingThatEndsOnAFullDiskKeepsWhatWasCommittedAndANewOneCanBegin) {
  const test::SmallDisk disk(file("disk"), "2m");
  NEEDS_A_DISK(disk);
  const std::string path = file("disk/s.abrazo");
  Recorded session(path);
  session.run_until(0.4);
  ASSERT_TRUE(session.recorder().flush());
  session.run_until(8);
  EXPECT_FALSE(session.recorder().flush());
  EXPECT_THAT(session.recorder().state().failure, HasSubstr("the disk is full"));
  const std::size_t on_disk = session.recorder().state().frames;
  EXPECT_GT(on_disk, 20U);
  const Status finished = session.recorder().finish();
  ASSERT_FALSE(finished);
  EXPECT_THAT(finished.error().text(), AllOf(HasSubstr("the disk is full"), HasSubstr("are missing")));
  expect_all(frames_in(path), on_disk);

  ASSERT_TRUE(disk.grow("32m"));
  Recorded again(path);
  again.run_until(0.5);
  ASSERT_TRUE(again.recorder().finish());
  EXPECT_EQ(frames_in(path).size(), on_disk + again.solved());
}

TEST_F(RecordingFaults, ADiskThatBecomesReadOnlyIsSaid) {
  const test::SmallDisk disk(file("disk"), "16m");
  NEEDS_A_DISK(disk);
  const std::string path = file("disk/s.abrazo");
  Recorder::State state;
  std::size_t on_disk = 0;
  {
    Recorded session(path);
    session.run_until(0.5);
    ASSERT_TRUE(session.recorder().finish());
    on_disk = session.solved();
  }
  ASSERT_TRUE(disk.make_read_only());
  const auto refused = Recorder::open(path, test::session_facts());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), AnyOf(HasSubstr("may only be read"), HasSubstr("cannot be opened")));
  EXPECT_FALSE(save_project(path, Project{}));
  EXPECT_EQ(frames_in(path).size(), on_disk) << "it can still be looked at";
}

TEST_F(RecordingFaults, AFileThatIsDeletedWhileItIsRecordedIsSaidAndWrittenAgain) {
  const std::string path = file("s.abrazo");
  Recorded session(path);
  session.recorder().begin_take("salsa");
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().flush());
  fs::remove(path);
  session.run_until(1);
  ASSERT_TRUE(session.recorder().flush());
  EXPECT_THAT(session.recorder().state().failure, HasSubstr("the file was deleted while it is recorded"));
  session.run_until(1.5);
  const Status finished = session.recorder().finish();
  EXPECT_TRUE(finished) << finished.error().text();
  expect_all(frames_in(path), session.solved());
  EXPECT_EQ((*SessionFile::open(path))->contents().takes.at(0).name, "salsa");
  EXPECT_FALSE(fs::exists(path + "-wal"));
}

TEST_F(RecordingFaults, ADeletedFileWhoseNameIsTakenIsWrittenBesideIt) {
  const std::string path = file("s.abrazo");
  Recorded session(path);
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().flush());
  fs::remove(path);
  ASSERT_TRUE(write_whole_file(path, "somebody else's"));
  const Status finished = session.recorder().finish();
  ASSERT_FALSE(finished);
  EXPECT_THAT(finished.error().message, HasSubstr("s-deleted-"));
  EXPECT_EQ(*read_whole_file(path), "somebody else's");
  for (const auto& entry : fs::directory_iterator(fs::path(path).parent_path()))
    if (entry.path() != path) expect_all(frames_in(entry.path().string()), session.solved());
}

TEST_F(RecordingFaults, TheLogOfASessionThatTookADeletedFilesNameIsLeftAlone) {
  const std::string path = file("s.abrazo");
  Recorded session(path);
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().flush());
  take_all_of(path, [](const std::string& name, const char*) { fs::remove(name); });
  const LiveSessionOfOthers others(path);
  session.run_until(0.8);
  const Status finished = session.recorder().finish();
  ASSERT_FALSE(finished);
  EXPECT_THAT(finished.error().message, HasSubstr("s-deleted-"));
  EXPECT_EQ(others.rows(), 3);
  for (const auto& entry : fs::directory_iterator(fs::path(path).parent_path()))
    if (entry.path().string().find("-deleted-") != std::string::npos)
      expect_all(frames_in(entry.path().string()), session.solved());
}

TEST_F(RecordingFaults, TheLogOfASessionThatTookAMovedFilesNameIsLeftAlone) {
  const std::string path = file("s.abrazo"), moved = file("moved.abrazo");
  Recorded session(path);
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().flush());
  take_all_of(path, [&](const std::string& name, const char* end) { fs::rename(name, moved + end); });
  const LiveSessionOfOthers others(path);
  session.run_until(0.8);
  const Status finished = session.recorder().finish();
  ASSERT_FALSE(finished);
  EXPECT_THAT(finished.error().message, HasSubstr("whole, under its new name"));
  EXPECT_EQ(others.rows(), 3);
  expect_all(frames_in(moved), session.solved());
}

TEST_F(RecordingFaults, ADeletedFileIsNotWrittenAgainBesideALogThatIsNotItsOwn) {
  const std::string path = file("s.abrazo");
  Recorded session(path);
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().flush());
  take_all_of(path, [](const std::string& name, const char*) { fs::remove(name); });
  ASSERT_TRUE(write_whole_file(path + "-wal", "somebody else's"));
  const Status finished = session.recorder().finish();
  ASSERT_FALSE(finished);
  EXPECT_THAT(finished.error().message, HasSubstr("s-deleted-"));
  EXPECT_FALSE(fs::exists(path));
  EXPECT_EQ(*read_whole_file(path + "-wal"), "somebody else's");
}

TEST_F(RecordingFaults, AFileThatIsRenamedWhileItIsRecordedIsSaidAndIsWholeUnderItsNewName) {
  const std::string path = file("s.abrazo"), renamed = file("renamed.abrazo");
  Recorded session(path);
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().flush());
  fs::rename(path, renamed);
  session.run_until(1);
  ASSERT_TRUE(session.recorder().flush());
  EXPECT_THAT(session.recorder().state().failure, HasSubstr("moved or renamed while it is recorded"));
  const Status finished = session.recorder().finish();
  ASSERT_FALSE(finished);
  EXPECT_THAT(finished.error().message, HasSubstr("whole, under its new name"));
  expect_all(frames_in(renamed), session.solved());
}

TEST_F(RecordingFaults, AFileThatIsCutShortOrWrittenOverWhileItIsRecordedIsSaidAtOnce) {
  // By other programs, as it happens; our own descriptors would drop the locks of the recording.
  int number = 0;
  for (const std::string harm :
       {"truncate -s 100 ", "dd if=/dev/zero bs=64 count=1 conv=notrunc status=none of="}) {
    const std::string path = file("harmed_" + std::to_string(number++) + ".abrazo");
    Recorded session(path);
    session.run_until(0.5);
    ASSERT_TRUE(session.recorder().flush());
    EXPECT_THAT(session.recorder().state().failure, IsEmpty());
    ASSERT_EQ(std::system((harm + path).c_str()), 0);
    session.run_until(1);
    (void)session.recorder().flush();
    EXPECT_THAT(session.recorder().state().failure, HasSubstr("cut short or written over")) << harm;
    const Status finished = session.recorder().finish();
    ASSERT_FALSE(finished) << harm << ": a recording that may have lost something does not end well";
    EXPECT_THAT(finished.error().message,
                AnyOf(HasSubstr("look whether the session opens"), HasSubstr("the file is damaged")))
        << harm;
  }
}

TEST_F(RecordingFaults, WritingOverTheMiddleOfTheFileOrOfItsLogIsSaidAtOnce) {
  const std::string harm = "dd if=/dev/urandom bs=100 seek=300 count=1 conv=notrunc status=none of=";
  for (const std::string end : {"", "-wal"}) {
    const std::string path = file("harmed" + end + ".abrazo");
    Recorded session(path);
    session.run_until(0.5);
    ASSERT_TRUE(session.recorder().flush());
    ASSERT_GT(fs::file_size(path + end), 30'100U);
    EXPECT_THAT(session.recorder().state().failure, IsEmpty());
    std::this_thread::sleep_for(kernel_tick);
    ASSERT_EQ(std::system((harm + path + end).c_str()), 0);
    session.run_until(0.6);
    (void)session.recorder().flush();
    EXPECT_THAT(session.recorder().state().failure, HasSubstr("written over by another program"));
    EXPECT_FALSE(session.recorder().finish());
  }
}

TEST_F(RecordingFaults, ReadingAFileWhileItIsRecordedIsNoTrouble) {
  const std::string path = file("s.abrazo");
  Recorded session(path);
  for (double until_s = 0.5; until_s < 3; until_s += 0.5) {
    session.run_until(until_s);
    ASSERT_TRUE(session.recorder().flush());
    std::this_thread::sleep_for(kernel_tick);
    expect_all(frames_in(path), session.solved());
    ASSERT_EQ(std::system(("cat " + path + " " + path + "-wal > /dev/null").c_str()), 0);
    EXPECT_THAT(session.recorder().state().failure, IsEmpty());
  }
  EXPECT_TRUE(session.recorder().finish());
}

TEST_F(RecordingFaults, AnotherThatMayNotWriteIntoTheFileDoesNot) {
  const std::string path = file("s.abrazo");
  Recorded session(path);
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().flush());
  std::this_thread::sleep_for(kernel_tick);
  EXPECT_FALSE(save_project(path, Project()));
  EXPECT_FALSE(Recorder::open(path, test::session_facts()));
  session.run_until(0.6);
  ASSERT_TRUE(session.recorder().flush());
  EXPECT_THAT(session.recorder().state().failure, IsEmpty());
  EXPECT_TRUE(session.recorder().finish());
}

TEST_F(RecordingFaults, AFileThatIsPutBackIsNoTroubleAnyMore) {
  const std::string path = file("s.abrazo"), away = file("away.abrazo");
  Recorded session(path);
  session.run_until(0.3);
  ASSERT_TRUE(session.recorder().flush());
  fs::rename(path, away);
  session.run_until(0.6);
  ASSERT_TRUE(session.recorder().flush());
  ASSERT_FALSE(session.recorder().state().failure.empty());
  fs::rename(away, path);
  session.run_until(0.9);
  ASSERT_TRUE(session.recorder().flush());
  EXPECT_THAT(session.recorder().state().failure, IsEmpty());
  ASSERT_TRUE(session.recorder().finish());
  expect_all(frames_in(path), session.solved());
}

TEST_F(RecordingFaults, AFolderThatTakesNoFilesIsRefusedBeforeAnythingRuns) {
  ASSERT_TRUE(write_whole_file(file("plain"), "no folder"));
  const auto refused = Recorder::open(file("plain/s.abrazo"), test::session_facts());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("does its folder exist, and may it be written?"));
  EXPECT_FALSE(save_project(file("plain/s.abrazo"), Project{}));
}

TEST_F(RecordingFaults, AFileThatIsOpenMayBeDeletedWithoutHarmToWhoReadsIt) {
  const std::string path = file("s.abrazo");
  Recorded session(path);
  session.run_until(0.5);
  ASSERT_TRUE(session.recorder().finish());
  const auto opened = *SessionFile::open(path);
  fs::remove(path);
  std::size_t frames = 0;
  const auto pass = opened->each_frame(-1e9, 1e9, [&](const FrameSnapshot&) -> Status {
    ++frames;
    return Done{};
  });
  ASSERT_TRUE(pass);
  EXPECT_EQ(frames, session.solved());
}

// ---- projects ----

class ProjectFaults : public testing::Test, protected test::TemporaryFolder {
 protected:
  /// More than fits where the old one did.
  static Project large() {
    Project project;
    project.view["notes"] = std::string(2'000'000, 'x');
    return project;
  }
  const std::string path_ = TemporaryFolder::file("p.abrazo");
};

TEST_F(ProjectFaults, SavingOnAFullDiskLeavesTheOldFileWhole) {
  const Project old = test::ProjectMaker(3).make();
  ASSERT_TRUE(save_project(path_, old));
  {
    const test::LimitedFiles full(fs::file_size(path_) + 65536);
    const Status saved = save_project(path_, large());
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().text(), AllOf(HasSubstr("p.abrazo"), HasSubstr("full")));
  }
  const auto read = load_project(path_);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(*read, old);
  EXPECT_TRUE(save_project(path_, large()));
}

TEST_F(ProjectFaults, ANewProjectOnAFullDiskLeavesNothingBehind) {
  {
    const test::LimitedFiles full(100'000);
    EXPECT_FALSE(save_project(path_, large()));
  }
  for (const auto& left : fs::directory_iterator(fs::path(path_).parent_path())) ADD_FAILURE() << left;
}

TEST_F(ProjectFaults, SavingOnADiskThatIsReallyFullLeavesTheOldFileWhole) {
  const test::SmallDisk disk(file("disk"), "1m");
  NEEDS_A_DISK(disk);
  const Project old = test::ProjectMaker(4).make();
  const std::string path = file("disk/p.abrazo");
  ASSERT_TRUE(save_project(path, old));
  const Status saved = save_project(path, large());
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().text(), HasSubstr("the disk is full"));
  const auto read = load_project(path);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(*read, old);
}

}  // namespace
}  // namespace abrazo::recording_faults_test
