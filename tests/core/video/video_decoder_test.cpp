// The thread that decodes: only the newest request counts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "core/video/video_decoder.hpp"
#include "tests/core/video/coded_video.hpp"

namespace abrazo::test::video_decoder_test {
namespace {

/// Waits until the decoder said that something is new and it is so.
class Bell {
 public:
  std::function<void()> ring() {
    return [this] {
      const std::lock_guard lock(mutex_);
      rung_.notify_all();
    };
  }
  template <typename Condition>
  bool until(Condition reached) {
    std::unique_lock lock(mutex_);
    // Looked at anew now and then: it may have come true between looking and waiting.
    for (int i = 0; i < 6000; ++i) {
      if (reached()) return true;
      rung_.wait_for(lock, std::chrono::milliseconds(10));
    }
    return false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable rung_;
};

std::filesystem::path coded_file(int pictures) {
  const auto file =
      std::filesystem::path(testing::TempDir()) / ("decoder" + std::to_string(::getpid()) + ".mp4");
  EXPECT_TRUE(write_coded_video(file, "mp4v", pictures, 25));
  return file;
}

TEST(VideoDecoder, OpensAndShowsTheNewestRequest) {
  const auto file = coded_file(120);
  Bell bell;
  VideoDecoder decoder(file, bell.ring());
  for (const int index : {100, 3, 50, 77}) decoder.request(index);
  ASSERT_TRUE(bell.until([&] { return decoder.newest() && decoder.newest()->index == 77; }));
  EXPECT_EQ(decoder.state(), VideoDecoder::State::Open);
  EXPECT_EQ(decoder.facts()->frames(), 120);
  EXPECT_EQ(decoder.opened(), 1);
  EXPECT_EQ(decoder.requested(), 77);
  EXPECT_EQ(code_of(*decoder.newest()), 77);
  for (int index = 78; index < 90; ++index) {
    decoder.request(index);
    ASSERT_TRUE(bell.until([&] { return decoder.newest()->index == index; }));
    EXPECT_EQ(code_of(*decoder.newest()), index);
  }
  decoder.request(10'000);
  EXPECT_TRUE(bell.until([&] { return decoder.newest()->index == 119; }))
      << "the last one stands for later ones";
  std::filesystem::remove(file);
}

TEST(VideoDecoder, SaysWhyAFileDoesNotOpen) {
  Bell bell;
  VideoDecoder decoder("no/such.mp4", bell.ring());
  ASSERT_TRUE(bell.until([&] { return decoder.state() == VideoDecoder::State::Failed; }));
  EXPECT_THAT(decoder.trouble().error().text(), testing::HasSubstr("does not exist"));
  EXPECT_EQ(decoder.newest(), nullptr);
}

TEST(VideoDecoder, StopsWhileItIsOpening) {
  const auto file = coded_file(300);
  { const VideoDecoder decoder(file, {}); }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace abrazo::test::video_decoder_test
