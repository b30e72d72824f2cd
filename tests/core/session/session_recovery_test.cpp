#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "core/session/file/library_reference.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::session_recovery_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Bytes = std::vector<char>;

Bytes bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::string& path, const Bytes& bytes, std::size_t size) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(size));
}

/// Some seconds with a take that is still open, as they are on disk while it is recorded.
struct CutOff {
  CutOff() : path(folder.file("s.abrazo")) {
    session.keeper->recorder = *Recorder::open(path, test::session_facts());
    session.run_until(0.5);
    session.keeper->recorder->begin_take("salsa 3");
    session.run_until(2.2);
    const Clip clip = test::swinging_take("user", 60, 4).a;
    for (const Pose& pose : clip.poses)
      session.keeper->recorder->pose_received(test::received("Ana", session.now_s, pose));
    EXPECT_TRUE(session.keeper->recorder->flush());
    // What a power cut would leave.
    file = bytes_of(path);
    log = bytes_of(path + "-wal");
  }
  std::string copy(const std::string& name) const {
    const std::string copied = folder.file(name);
    write_bytes(copied, file, file.size());
    write_bytes(copied + "-wal", log, log.size());
    return copied;
  }
  test::TemporaryFolder folder;
  std::string path;
  test::DrivenSession session;
  Bytes file, log;
};

/// Everything that a file has is read; @return frames that could be, or -1 when it is refused
std::int64_t read_all(const std::string& path, const std::vector<FrameSnapshotPtr>& recorded) {
  const auto file = SessionFile::open(path);
  if (!file) {
    EXPECT_FALSE(file.error().message.empty());
    return -1;
  }
  std::int64_t frames = 0;
  const auto pass = (*file)->each_frame(-1e18, 1e18, [&](const FrameSnapshot& frame) -> Status {
    // What is given out is what was recorded: damage is never taken for data.
    if (frame.index < recorded.size()) {
      EXPECT_EQ(frame.result.result, recorded[frame.index]->result.result);
      EXPECT_EQ(frame.user, recorded[frame.index]->user);
    }
    ++frames;
    return Done{};
  });
  if (pass && pass->damaged > 0) {
    EXPECT_FALSE(pass->damage.empty());
  }
  (void)(*file)->each_pose(std::nullopt, -1e18, 1e18, [](const ReceivedPose&) { return Done{}; });
  if (const auto store = RecordedFrames::open(path, test::session_library())) {
    (void)(*store)->span();
    (void)(*store)->at(1);
    (void)(*store)->range(0, 10, 5);
    (void)(*store)->state_before(40);
  }
  return frames;
}

TEST(SessionRecovery, AFileThatWasCutOffOpensAndSaysWhatItHas) {
  const CutOff cut;
  const std::string path = cut.copy("cut.abrazo");
  const auto file = SessionFile::open(path);
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_EQ((*file)->contents().frames, cut.session.keeper->frames.size());
  const std::string frames = std::to_string(cut.session.keeper->frames.size());
  EXPECT_THAT((*file)->recovery(),
              ElementsAre("the recording was cut off; recovered " + frames + " frames up to 00:02.183",
                          "the take 'salsa 3' was still being recorded; it ends at 00:02.183"));
  ASSERT_EQ((*file)->contents().takes.size(), 1U);
  EXPECT_TRUE((*file)->contents().takes[0].interrupted);
  EXPECT_EQ((*file)->contents().takes[0].last_frame, cut.session.keeper->frames.back()->index);
  EXPECT_FALSE((*file)->is_being_recorded());
  EXPECT_EQ(read_all(path, cut.session.keeper->frames),
            static_cast<std::int64_t>(cut.session.keeper->frames.size()));
}

TEST(SessionRecovery, GoingOnInItEndsTheTakeThatWasOpen) {
  const CutOff cut;
  const std::string path = cut.copy("cut.abrazo");
  auto recorder = Recorder::open(path, test::session_facts());
  ASSERT_TRUE(recorder) << recorder.error().text();
  ASSERT_TRUE((*recorder)->finish());
  const auto file = SessionFile::open(path);
  EXPECT_FALSE((*file)->contents().takes[0].interrupted);
  EXPECT_NEAR((*file)->contents().takes[0].end_s, 2.2, 0.02);
  EXPECT_FALSE((*file)->contents().runs[0].finished);
  EXPECT_TRUE((*file)->contents().runs[1].finished);
}

TEST(SessionRecovery, ALogCutAnywhereLosesItsEndAlone) {
  const CutOff cut;
  const std::string path = cut.folder.file("cut.abrazo");
  std::int64_t before = 0;
  for (std::size_t part = 0; part <= 24; ++part) {
    const std::size_t size = cut.log.size() * part / 24;
    std::filesystem::remove(path + "-shm");
    write_bytes(path, cut.file, cut.file.size());
    write_bytes(path + "-wal", cut.log, size);
    const std::int64_t frames = read_all(path, cut.session.keeper->frames);
    EXPECT_GE(frames, before) << part;  // the more of it there is, the more frames
    before = std::max(before, frames);
  }
  EXPECT_EQ(before, static_cast<std::int64_t>(cut.session.keeper->frames.size()));
}

/// A finished file, whole.
struct Finished {
  Finished() : path(folder.file("s.abrazo")) {
    session.keeper->recorder = *Recorder::open(path, test::session_facts());
    session.run_until(3);
    const Clip clip = test::swinging_take("user", 60, 4).a;
    for (const Pose& pose : clip.poses)
      session.keeper->recorder->pose_received(test::received("Ana", 1, pose));
    EXPECT_TRUE(session.keeper->recorder->finish());
    bytes = bytes_of(path);
  }
  test::TemporaryFolder folder;
  std::string path;
  test::DrivenSession session;
  Bytes bytes;
};

TEST(SessionRecovery, AFileCutAtAnyLengthGivesWhatIsLeftOrAnError) {
  const Finished whole;
  const std::string path = whole.folder.file("cut.abrazo");
  bool some_in_part = false;
  for (std::size_t part = 0; part <= 40; ++part) {
    write_bytes(path, whole.bytes, whole.bytes.size() * part / 40 + (part % 2 ? 137 : 0));
    const std::int64_t frames = read_all(path, whole.session.keeper->frames);
    some_in_part |= frames > 10 && frames < static_cast<std::int64_t>(whole.session.keeper->frames.size());
    if (part == 0) {
      EXPECT_EQ(frames, -1);
    }
  }
  EXPECT_TRUE(some_in_part);
}

TEST(SessionRecovery, FlippedBytesAreNoticedNotShown) {
  const Finished whole;
  const std::string path = whole.folder.file("flipped.abrazo");
  std::mt19937 random(7);
  std::int64_t least = 1 << 20;
  for (int round = 0; round < 60; ++round) {
    Bytes bytes = whole.bytes;
    for (int flips = 0; flips < 1 + round % 5; ++flips)
      bytes[random() % bytes.size()] ^= static_cast<char>(1 << (random() % 8));
    write_bytes(path, bytes, bytes.size());
    least = std::min(least, read_all(path, whole.session.keeper->frames));
  }
  EXPECT_LT(least, static_cast<std::int64_t>(whole.session.keeper->frames.size()));
}

TEST(SessionRecovery, APageOfRubbishCostsItsFramesOnly) {
  const Finished whole;
  const std::string path = whole.folder.file("rubbish.abrazo");
  constexpr std::size_t page = 16384;
  int in_part = 0;
  const auto all = static_cast<std::int64_t>(whole.session.keeper->frames.size());
  for (std::size_t at = page; at + page <= whole.bytes.size(); at += 5 * page) {
    Bytes bytes = whole.bytes;
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), page, '\xa5');
    write_bytes(path, bytes, bytes.size());
    const std::int64_t frames = read_all(path, whole.session.keeper->frames);
    if (frames > all / 2 && frames < all) ++in_part;
  }
  EXPECT_GT(in_part, 3);
}

TEST(SessionRecovery, WhatIsNoSessionFileIsSaidToBeNone) {
  const test::TemporaryFolder folder;
  const auto error_of = [](const std::string& path) {
    const auto file = SessionFile::open(path);
    return file ? std::string() : file.error().text();
  };
  const std::string path = folder.file("x.abrazo");
  EXPECT_THAT(error_of(path), HasSubstr("there is no such file"));
  write_bytes(path, {}, 0);
  EXPECT_THAT(error_of(path), HasSubstr("empty"));
  write_bytes(path, Bytes(5000, 'x'), 5000);
  EXPECT_THAT(error_of(path), HasSubstr("no SQLite database"));
  std::filesystem::remove(path);
  {
    auto database = SessionDatabase::open(path, SessionDatabase::Access::Create);
    ASSERT_TRUE(database->execute("CREATE TABLE songs (name TEXT)"));
  }
  EXPECT_THAT(error_of(path), HasSubstr("another program's SQLite database"));
  {
    auto database = SessionDatabase::open(path, SessionDatabase::Access::Write);
    ASSERT_TRUE(database->execute("PRAGMA application_id = 1096970874; PRAGMA user_version = 99"));
  }
  EXPECT_THAT(error_of(path),
              HasSubstr("version 99, this program reads version 1; open it with a newer Abrazo"));
}

TEST(SessionLibraryReference, NoticesAnotherLibrary) {
  const Finished whole;
  const SessionLibrary reference = (*SessionFile::open(whole.path))->contents().libraries.at(0);
  EXPECT_TRUE(check_session_library(reference, *test::session_library()));
  LibraryColumns columns = test::session_library()->columns();
  columns.poses[5](3, 1) += 1e-9;
  const Status other = check_session_library(reference, MotionLibrary(std::move(columns)));
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().text(), HasSubstr("other content"));
}

}  // namespace
}  // namespace abrazo::session_recovery_test
