#include "core/base/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "core/base/file_series.hpp"
#include "core/base/output_file.hpp"

namespace abrazo::atomic_file_test {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
 protected:
  AtomicFileTest() : folder_(fs::temp_directory_path() / ("abrazo_atomic_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~AtomicFileTest() override { fs::remove_all(folder_); }
  fs::path folder_;
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
};

TEST_F(AtomicFileTest, AppearsUnderItsNameOnlyWhenCommitted) {
  AtomicFile file(folder_ / "out.csv");
  std::ofstream(file.partial()) << "content";
  EXPECT_FALSE(fs::exists(folder_ / "out.csv"));
  ASSERT_TRUE(file.commit());
  EXPECT_EQ(read_whole_file(folder_ / "out.csv").value(), "content");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFileTest, LeavesNothingBehindWhenAbandoned) {
  {
    AtomicFile file(folder_ / "out.csv");
    std::ofstream(file.partial()) << "half";
  }
  EXPECT_EQ(files(), 0u);
}

TEST_F(AtomicFileTest, KeepsTheOldFileUntilTheNewOneIsWhole) {
  ASSERT_TRUE(write_whole_file(folder_ / "out.csv", "old"));
  {
    AtomicFile file(folder_ / "out.csv");
    std::ofstream(file.partial()) << "half";
  }
  EXPECT_EQ(read_whole_file(folder_ / "out.csv").value(), "old");
  ASSERT_TRUE(write_whole_file(folder_ / "out.csv", "new"));
  EXPECT_EQ(read_whole_file(folder_ / "out.csv").value(), "new");
}

TEST_F(AtomicFileTest, IsWrittenUnderANameThatNobodyCanForesee) {
  const AtomicFile one(folder_ / "out.csv"), other(folder_ / "out.csv");
  EXPECT_NE(one.partial(), other.partial()) << "of one process and one target";
  EXPECT_TRUE(fs::is_regular_file(one.partial())) << "nobody else can have the name any more";
  EXPECT_EQ(files(), 2u);
  EXPECT_EQ(AtomicFile(folder_ / "film.mp4", ".mp4").partial().extension(), ".mp4");
}

TEST_F(AtomicFileTest, AFileIsMadeOnlyWhereNothingHasItsName) {
  EXPECT_TRUE(make_new_file(folder_ / "new"));
  EXPECT_FALSE(make_new_file(folder_ / "new"));
  EXPECT_EQ(errno, EEXIST);
  fs::create_symlink(folder_ / "nowhere", folder_ / "link");
  EXPECT_FALSE(make_new_file(folder_ / "link"));
  EXPECT_EQ(errno, EEXIST);
  EXPECT_FALSE(fs::exists(folder_ / "nowhere"));
}

TEST_F(AtomicFileTest, WritesBytesAsTheyAre) {
  const std::string bytes("a\r\n\0b", 5);
  ASSERT_TRUE(write_whole_file(folder_ / "bytes", bytes));
  EXPECT_EQ(read_whole_file(folder_ / "bytes").value(), bytes);
}

TEST_F(AtomicFileTest, AFileThatIsWriteProtectedIsNotReplaced) {
  const fs::path kept = folder_ / "kept.csv";
  ASSERT_TRUE(write_whole_file(kept, "old"));
  fs::permissions(kept, fs::perms::owner_read);
  for (const Status& refused : {write_whole_file(kept, "new"), check_output(kept.string(), {})}) {
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), testing::HasSubstr("kept.csv: is write-protected"));
  }
  EXPECT_EQ(read_whole_file(kept).value(), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFileTest, WhatReplacesAPrivateFileIsPrivate) {
  ASSERT_TRUE(write_whole_file(folder_ / "own.csv", "old"));
  const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(folder_ / "own.csv", own);
  ASSERT_TRUE(write_whole_file(folder_ / "own.csv", "new"));
  EXPECT_EQ(fs::status(folder_ / "own.csv").permissions(), own);
}

TEST_F(AtomicFileTest, ALinkThatIsPutInPlaceOfThePartialFileIsNotWrittenThrough) {
  const fs::path victim = folder_ / "victim";
  ASSERT_TRUE(write_whole_file(victim, "three years"));
  for (const bool is_hard : {false, true}) {
    AtomicFile file(folder_ / "out.csv");
    fs::remove(file.partial());
    is_hard ? fs::create_hard_link(victim, file.partial()) : fs::create_symlink(victim, file.partial());
    EXPECT_FALSE(file.write("new")) << is_hard;
    const Status named = file.commit();
    ASSERT_FALSE(named) << is_hard;
    EXPECT_THAT(named.error().text(), testing::HasSubstr("out.csv: was not written: another program"));
    EXPECT_EQ(read_whole_file(victim).value(), "three years") << is_hard;
  }
  EXPECT_EQ(files(), 1u) << "the link is taken away, and out.csv never came to be";
}

TEST_F(AtomicFileTest, ASeriesWithAFolderInItsWayReplacesNothing) {
  ASSERT_TRUE(write_whole_file(folder_ / "0.csv", "old"));
  fs::create_directory(folder_ / "1.csv");
  {
    FileSeries series;
    for (const char* name : {"0.csv", "1.csv"})
      ASSERT_TRUE(series.add((folder_ / name).string(), "new")) << name;
    const Status done = series.commit();
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().text(), testing::HasSubstr("1.csv: is a folder"));
  }
  EXPECT_EQ(read_whole_file(folder_ / "0.csv").value(), "old");
  EXPECT_EQ(files(), 2u);
}

TEST_F(AtomicFileTest, ASeriesThatFailsHalfWayTakesAwayWhatItAddedAndCountsWhatItReplaced) {
  ASSERT_TRUE(write_whole_file(folder_ / "1.csv", "old"));
  {
    FileSeries series;
    for (const char* name : {"0.csv", "1.csv", "2.csv"})
      ASSERT_TRUE(series.add((folder_ / name).string(), "new")) << name;
    for (const auto& entry : fs::directory_iterator(folder_))
      if (entry.path().filename().string().starts_with("2.csv.")) fs::remove(entry.path());
    const Status done = series.commit();
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().text(), testing::HasSubstr("2.csv"));
    EXPECT_THAT(done.error().text(), testing::HasSubstr("1 older file of the series was already replaced"));
  }
  EXPECT_FALSE(fs::exists(folder_ / "0.csv"));
  EXPECT_EQ(read_whole_file(folder_ / "1.csv").value(), "new");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFileTest, NamesTheFileThatCannotBeWrittenOrRead) {
  const Status written = write_whole_file(folder_ / "absent" / "out.csv", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().where, (folder_ / "absent" / "out.csv").string());
  EXPECT_THAT(read_whole_file(folder_ / "absent.csv").error().message,
              testing::HasSubstr("cannot be opened"));
  EXPECT_THAT(read_whole_file(folder_).error().message, testing::HasSubstr("is a folder"));
}

TEST_F(AtomicFileTest, APipeADeviceOrAGiantIsRefusedBeforeAnythingIsRead) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  for (const fs::path& path : {folder_ / "pipe", fs::path("/dev/zero")})
    EXPECT_THAT(read_whole_file(path).error().message, testing::HasSubstr("is a device or a pipe")) << path;
  ASSERT_TRUE(write_whole_file(folder_ / "giant.bvh", "HIERARCHY"));
  fs::resize_file(folder_ / "giant.bvh", limits::whole_file_bytes + 1);  // sparse: it takes no room
  EXPECT_THAT(read_whole_file(folder_ / "giant.bvh").error().text(),
              testing::AllOf(testing::HasSubstr("giant.bvh"), testing::HasSubstr("are read up to 4096 MB")));
  ASSERT_TRUE(write_whole_file(folder_ / "small.bvh", "HIERARCHY"));
  EXPECT_TRUE(read_whole_file(folder_ / "small.bvh", 9)) << "as large as is read";
  EXPECT_THAT(read_whole_file(folder_ / "small.bvh", 8).error().text(), testing::HasSubstr("Split it"));
}

}  // namespace
}  // namespace abrazo::atomic_file_test
