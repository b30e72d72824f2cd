#include "core/video/video_writer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "core/base/atomic_file.hpp"
#include "tests/support/broken_world.hpp"

namespace abrazo::video_writer_test {
namespace {

namespace fs = std::filesystem;

class VideoWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("abrazo_video_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
  std::vector<std::uint8_t> picture_ = std::vector<std::uint8_t>(64 * 48 * 3, 90);
};

TEST_F(VideoWriterTest, WritesAsManyPicturesAsItWasGiven) {
  auto video = VideoWriter::open(folder_ / "a.mp4", 64, 48, 15);
  ASSERT_TRUE(video);
  for (int i = 0; i < 12; ++i) ASSERT_TRUE(video->add(picture_, 64 * 3));
  ASSERT_TRUE(video->finish());
  EXPECT_GT(fs::file_size(folder_ / "a.mp4"), 500u);
}

TEST_F(VideoWriterTest, LeavesNothingWhenItIsNotFinished) {
  {
    auto video = VideoWriter::open(folder_ / "a.mp4", 64, 48, 15);
    ASSERT_TRUE(video);
    ASSERT_TRUE(video->add(picture_, 64 * 3));
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(VideoWriterTest, RefusesWhatCannotBeAVideo) {
  EXPECT_FALSE(VideoWriter::open(folder_ / "a.mp4", 63, 48, 15));
  EXPECT_FALSE(VideoWriter::open(folder_ / "a.mp4", 64, 48, 0));
  const auto nowhere = VideoWriter::open(folder_ / "no" / "such" / "a.mp4", 64, 48, 15);
  ASSERT_FALSE(nowhere);
  EXPECT_NE(nowhere.error().text().find("check that the folder exists"), std::string::npos);
}

TEST_F(VideoWriterTest, RefusesAPictureThatIsTooSmall) {
  auto video = VideoWriter::open(folder_ / "a.mp4", 64, 48, 15);
  ASSERT_TRUE(video);
  EXPECT_FALSE(video->add(std::span(picture_).first(100), 64 * 3));
}

TEST_F(VideoWriterTest, OnAFullDiskSaysSoAndLeavesTheOldFilmWhole) {
  ASSERT_TRUE(write_whole_file(folder_ / "a.mp4", "the film of yesterday"));
  {
    const test::LimitedFiles full(200);
    auto video = VideoWriter::open(folder_ / "a.mp4", 64, 48, 15);
    ASSERT_TRUE(video);
    for (int i = 0; i < 60; ++i) (void)video->add(picture_, 64 * 3);
    const Status finished = video->finish();
    ASSERT_FALSE(finished);
    EXPECT_NE(finished.error().text().find("check that the disk is not full"), std::string::npos);
  }
  EXPECT_EQ(*read_whole_file(folder_ / "a.mp4"), "the film of yesterday");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(VideoWriterTest, DoesNotWriteThroughALinkThatSomebodyPutThere) {
  ASSERT_TRUE(write_whole_file(folder_ / "thesis.tex", "three years"));
  fs::create_symlink(folder_ / "thesis.tex", folder_ / "a.mp4");
  auto video = VideoWriter::open(folder_ / "a.mp4", 64, 48, 15);
  ASSERT_TRUE(video);
  for (int i = 0; i < 12; ++i) ASSERT_TRUE(video->add(picture_, 64 * 3));
  ASSERT_TRUE(video->finish());
  EXPECT_EQ(*read_whole_file(folder_ / "thesis.tex"), "three years");
}

TEST_F(VideoWriterTest, TakesNoNameForTheAddressOfAServer) {
  // As a file name it needs a folder "rtmp:", which is not there.
  const auto nowhere = VideoWriter::open("rtmp://127.0.0.1/live.mp4", 64, 48, 15);
  ASSERT_FALSE(nowhere);
  EXPECT_NE(nowhere.error().text().find("check that the folder exists"), std::string::npos);
}

}  // namespace
}  // namespace abrazo::video_writer_test
