// Reading videos: the picture with a number is the one that carries it, however it was come to.
#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <numeric>
#include <opencv2/videoio.hpp>
#include <random>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/video/frame_cache.hpp"
#include "core/video/picture_times.hpp"
#include "core/video/video_codec.hpp"
#include "core/video/video_reader.hpp"
#include "core/video/video_writer.hpp"
#include "tests/core/video/coded_video.hpp"

namespace abrazo::test::video_reader_test {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class VideoFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    folder_ = fs::path(testing::TempDir()) / ("video_" + name + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path at(const std::string& name) const { return folder_ / name; }
  fs::path written(const std::string& name, const std::string& content) const {
    std::ofstream(at(name), std::ios::binary) << content;
    return at(name);
  }
  static std::string refusal(const fs::path& file) {
    const auto reader = VideoReader::open(file, {});
    return reader ? "" : reader.error().text();
  }

 private:
  fs::path folder_;
};

cv::Mat rgb_of(const cv::Mat& bgr) {
  cv::Mat rgb(bgr.size(), CV_8UC3);
  std::array<int, 6> swap = {0, 2, 1, 1, 2, 0};
  cv::mixChannels(&bgr, 1, &rgb, 1, swap.data(), 3);
  return rgb;
}

void expect_exact(VideoReader& reader, const std::vector<int>& order) {
  for (const int index : order) {
    const auto frame = reader.frame(index);
    ASSERT_TRUE(frame) << frame.error().text();
    EXPECT_EQ((*frame)->index, index);
    ASSERT_EQ(code_of(**frame), index);
    EXPECT_EQ((*frame)->time_s, reader.facts().times_s[static_cast<std::size_t>(index)]);
  }
}

std::vector<int> every_which_way(int pictures) {
  std::vector<int> order = {pictures - 1, 0, pictures - 2, pictures / 2, pictures / 2 + 1, pictures / 2 - 1};
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i) order.push_back(static_cast<int>(random() % static_cast<unsigned>(pictures)));
  for (int i = pictures - 1; i > pictures - 30; --i) order.push_back(i);
  return order;
}

struct Coding {
  const char* fourcc;
  const char* file;
};
class EveryCoding : public VideoFile, public testing::WithParamInterface<Coding> {};

TEST_P(EveryCoding, GivesThePictureThatWasAskedFor) {
  const Coding coding = GetParam();
  if (!write_coded_video(at(coding.file), coding.fourcc, 200, 25))
    GTEST_SKIP() << "OpenCV here has no encoder for " << coding.fourcc;
  auto reader = VideoReader::open(at(coding.file), {});
  ASSERT_TRUE(reader) << reader.error().text();
  EXPECT_EQ(reader->facts().frames(), 200);
  EXPECT_NEAR(reader->facts().rate_hz, 25, 1e-6);
  EXPECT_TRUE(reader->facts().is_even);
  EXPECT_NEAR(reader->facts().duration_s(), 8, 1e-6);
  EXPECT_EQ(reader->facts().width, 320);
  expect_exact(*reader, every_which_way(200));
}
// MPEG-2 and H.264 are written with pictures that depend on later ones.
INSTANTIATE_TEST_SUITE_P(Codings, EveryCoding,
                         testing::Values(Coding{"mp4v", "a.mp4"}, Coding{"MJPG", "a.avi"},
                                         Coding{"avc1", "a.mp4"}, Coding{"mpg2", "a.mkv"},
                                         Coding{"VP80", "a.webm"}),
                         [](const auto& coding) { return std::string(coding.param.fourcc); });

TEST_F(VideoFile, OfVariableRateKeepsThePicturesTimes) {
  ASSERT_TRUE(write_coded_video(at("a.mp4"), "mp4v", 90, 30));
  const std::uint32_t tick = even_duration(at("a.mp4"));
  set_durations(at("a.mp4"), {{30, tick}, {30, tick * 3 / 2}, {30, tick / 2}});
  auto reader = VideoReader::open(at("a.mp4"), {});
  ASSERT_TRUE(reader) << reader.error().text();
  const VideoFacts& facts = reader->facts();
  ASSERT_EQ(facts.frames(), 90);
  EXPECT_FALSE(facts.is_even);
  EXPECT_NEAR(facts.rate_hz, 30, 0.1) << "of most pictures";
  EXPECT_NEAR(facts.times_s[29], 29 / 30.0, 1e-6);
  EXPECT_NEAR(facts.times_s[31], (30 + 1.5) / 30, 1e-6);
  EXPECT_NEAR(facts.times_s[85], (30 + 45 + 25 * 0.5) / 30, 1e-6);
  EXPECT_EQ(facts.index_at(1.06), 31);
  EXPECT_EQ(facts.index_at(-3), 0);
  EXPECT_EQ(facts.index_at(99), 89);
  expect_exact(*reader, every_which_way(90));
}

TEST_F(VideoFile, ShowsOnlyWhatItsEditListLeaves) {
  ASSERT_TRUE(write_coded_video(at("a.mp4"), "mp4v", 90, 30));
  const std::uint32_t tick = even_duration(at("a.mp4"));
  // It still says that it ends after the time of 90 pictures: 30, and 20 that stand three times as long.
  set_durations(at("a.mp4"), {{30, tick}, {30, 3 * tick}, {30, tick}});
  auto reader = VideoReader::open(at("a.mp4"), {});
  ASSERT_TRUE(reader) << reader.error().text();
  EXPECT_EQ(reader->facts().frames(), 50);
  EXPECT_THAT(reader->facts().warnings, Contains(HasSubstr("its header says 90 pictures, 50 can be shown")));
  expect_exact(*reader, every_which_way(50));
}

TEST_F(VideoFile, ThatSaysItIsTurnedIsShownUpright) {
  for (const int degrees : {90, 180, 270}) {
    // As a phone writes it: the picture lies, and the file says so.
    cv::Mat lying = coded_picture(5, {240, 320});
    const int back = degrees == 90    ? cv::ROTATE_90_COUNTERCLOCKWISE
                     : degrees == 180 ? cv::ROTATE_180
                                      : cv::ROTATE_90_CLOCKWISE;
    cv::rotate(lying, lying, back);
    const cv::Mat rgb = rgb_of(lying);
    const fs::path file = at("turned" + std::to_string(degrees) + ".mp4");
    auto writer = VideoWriter::open(file, rgb.cols, rgb.rows, 25);
    ASSERT_TRUE(writer);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(writer->add({rgb.data, rgb.total() * 3}, rgb.step));
    ASSERT_TRUE(writer->finish());
    set_rotation(file, degrees);
    auto reader = VideoReader::open(file, {});
    ASSERT_TRUE(reader) << reader.error().text();
    EXPECT_EQ(reader->facts().rotation_deg, degrees);
    EXPECT_EQ(reader->facts().width, 240);
    EXPECT_EQ(reader->facts().height, 320);
    EXPECT_EQ(code_of(**reader->frame(1)), 5) << degrees;
  }
}

// As the front camera of a phone writes it.
TEST_F(VideoFile, ThatSaysItIsMirroredIsShownAsItIsMeant) {
  for (const int degrees : {0, 90}) {
    cv::Mat meant = coded_picture(6, {320, 240}), mirrored;
    if (degrees == 90) cv::rotate(meant, meant, cv::ROTATE_90_COUNTERCLOCKWISE);
    cv::flip(meant, mirrored, 1);
    const cv::Mat coded = rgb_of(mirrored);
    const fs::path file = at("mirrored" + std::to_string(degrees) + ".mp4");
    auto writer = VideoWriter::open(file, coded.cols, coded.rows, 25);
    ASSERT_TRUE(writer);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(writer->add({coded.data, coded.total() * 3}, coded.step));
    ASSERT_TRUE(writer->finish());
    set_rotation(file, degrees, true);
    auto reader = VideoReader::open(file, {});
    ASSERT_TRUE(reader) << reader.error().text();
    EXPECT_TRUE(reader->facts().is_mirrored);
    EXPECT_EQ(reader->facts().rotation_deg, degrees);
    EXPECT_EQ(code_of(**reader->frame(1)), 6) << degrees;
    EXPECT_EQ(code_of(**reader->frame(0)), 6) << "after it began anew";
  }
}

TEST_F(VideoFile, ThatSaysItIsTurnedByNoQuarterIsShownAsCodedAndThatIsSaid) {
  ASSERT_TRUE(write_coded_video(at("a.mp4"), "mp4v", 3, 25));
  set_rotation(at("a.mp4"), 45);
  auto reader = VideoReader::open(at("a.mp4"), {});
  ASSERT_TRUE(reader) << reader.error().text();
  EXPECT_EQ(reader->facts().rotation_deg, 0);
  EXPECT_THAT(reader->facts().warnings, Contains(HasSubstr("turns the pictures by 45 degrees")));
  EXPECT_EQ(code_of(**reader->frame(1)), 1);
}

TEST_F(VideoFile, ThatIsCutOffHasThePicturesThatAreThereAndSaysSo) {
  ASSERT_TRUE(write_coded_video(at("a.avi"), "MJPG", 100, 25));
  fs::resize_file(at("a.avi"), fs::file_size(at("a.avi")) * 6 / 10);
  auto reader = VideoReader::open(at("a.avi"), {});
  ASSERT_TRUE(reader) << reader.error().text();
  const int pictures = reader->facts().frames();
  EXPECT_GT(pictures, 40);
  EXPECT_LT(pictures, 70);
  EXPECT_THAT(reader->facts().warnings, Contains(HasSubstr("its header says 100 pictures")));
  expect_exact(*reader, {0, pictures - 2, 10, pictures - 3});
}

TEST_F(VideoFile, IsRefusedWithWhatItIsInstead) {
  EXPECT_THAT(refusal(at("none.mp4")), HasSubstr("none.mp4: does not exist; check the path"));
  EXPECT_THAT(refusal(at(".")), HasSubstr("is a folder"));
  EXPECT_THAT(refusal(written("empty.mp4", "")), HasSubstr("is empty (0 bytes)"));
  EXPECT_THAT(refusal(written("text.mp4", "take,start_frame,end_frame,label\n")),
              HasSubstr("is a text, not a video"));
  EXPECT_THAT(refusal(written("a.wav", std::string("RIFF\x24\0\0\0WAVEfmt ", 16) + std::string(40, '\0'))),
              HasSubstr("holds sound and no pictures"));
  EXPECT_THAT(refusal(written("s.mp4", std::string("SQLite format 3\0\x10\0", 18) + std::string(99, '\1'))),
              HasSubstr("is a session or another database"));
  std::string noise(5000, '\0');
  std::mt19937 random(3);
  for (char& c : noise) c = static_cast<char>(random());
  EXPECT_THAT(refusal(written("noise.mp4", noise)), HasSubstr("is not a video that can be read"));
}

TEST_F(VideoFile, WithoutItsIndexIsSaidToBeUnfinished) {
  ASSERT_TRUE(write_coded_video(at("a.mp4"), "mp4v", 100, 25));
  fs::resize_file(at("a.mp4"), fs::file_size(at("a.mp4")) / 2);
  EXPECT_THAT(refusal(at("a.mp4")), HasSubstr("without its index (\"moov\"): it was cut off"));
}

TEST_F(VideoFile, WithSoundAloneIsSaidToHaveNoPictures) {
  ASSERT_TRUE(write_coded_video(at("a.mp4"), "mp4v", 10, 25));
  std::string bytes = *read_whole_file(at("a.mp4"));
  for (std::size_t i = bytes.find("vide"); i != std::string::npos; i = bytes.find("vide", i))
    bytes.replace(i, 4, "soun");
  EXPECT_THAT(refusal(written("sound.mp4", bytes)), HasSubstr("sound and no pictures"));
}

// A grey picture of 8192 x 8192 takes a megabyte in the file.
TEST_F(VideoFile, OfPicturesThatAreTooLargeIsRefusedBeforeOneIsRead) {
  constexpr int side = 8192;
  static_assert(double{side} * side == limits::video_pixels);
  for (const auto& [file, height] : {std::pair("largest.avi", side), std::pair("larger.avi", side + 8)}) {
    const cv::Mat grey(height, side, CV_8UC3, cv::Scalar(99, 99, 99));
    cv::VideoWriter video(at(file).string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25,
                          grey.size());
    if (!video.isOpened()) GTEST_SKIP() << "OpenCV here has no encoder for MJPG";
    video.write(grey);
  }
  EXPECT_EQ(refusal(at("largest.avi")), "");
  EXPECT_THAT(refusal(at("larger.avi")),
              HasSubstr("its pictures are 8192 x 8200; at most 8192 x 8192 can be shown"));
}

// Pictures may grow within a file, and how large they are is known once they are decoded.
TEST(VideoCodec, ReservesNoMoreAtOnceThanTheLargestPictureTakes) {
  ASSERT_TRUE(video_codec());
  const auto reserve = reinterpret_cast<void* (*)(std::size_t)>(::dlsym(RTLD_DEFAULT, "av_malloc"));
  const auto release = reinterpret_cast<void (*)(void*)>(::dlsym(RTLD_DEFAULT, "av_free"));
  ASSERT_TRUE(reserve && release);
  constexpr auto largest = 3 * static_cast<std::size_t>(limits::video_pixels);
  void* picture = reserve(largest);
  EXPECT_NE(picture, nullptr);
  release(picture);
  EXPECT_EQ(reserve(largest + (2U << 20U)), nullptr);
}

TEST_F(VideoFile, StopsOpeningWhenItIsToldTo) {
  ASSERT_TRUE(write_coded_video(at("a.mp4"), "mp4v", 50, 25));
  int told = 0;
  const auto reader = VideoReader::open(at("a.mp4"), [&](double fraction, std::string_view) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    return ++told < 5;
  });
  ASSERT_FALSE(reader);
  EXPECT_THAT(reader.error().text(), HasSubstr("cancelled"));
}

TEST(PictureTimes, FollowTheFileAndBeginAtZero) {
  VideoFacts facts;
  add_times(facts, {{400, 440, 480, 520}, 25, 4});
  EXPECT_THAT(facts.times_s, testing::ElementsAre(0, testing::DoubleEq(0.04), testing::DoubleEq(0.08),
                                                  testing::DoubleEq(0.12)));
  EXPECT_TRUE(facts.is_even);
  EXPECT_THAT(facts.warnings, IsEmpty());
}

TEST(PictureTimes, AreBelievedOverTheHeadersRate) {
  VideoFacts facts;
  add_times(facts, {{0, 40, 80, 120, 240}, 30, 5});
  EXPECT_NEAR(facts.rate_hz, 25, 1e-9);
  EXPECT_FALSE(facts.is_even);
  EXPECT_THAT(facts.warnings, Contains(HasSubstr("its header says 30 Hz, most pictures follow at 25 Hz")));
}

// What a stranger's file must not make the program open.
TEST_F(VideoFile, AListOfOtherFilesOrAddressesIsRefusedAndNothingOfItIsOpened) {
  ASSERT_TRUE(write_coded_video(at("other.mp4"), "mp4v", 20, 25));
  const std::string other = at("other.mp4").string();
  for (const std::string& list :
       {"#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\n" + other + "\n#EXT-X-ENDLIST\n",
        "ffconcat version 1.0\nfile '" + other + "'\n",
        std::string("#EXTM3U\n#EXTINF:1,\nhttp://127.0.0.1:9/x.ts\n"),
        "#EXTM3U\n#\x01\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\n" + other + "\n#EXT-X-ENDLIST\n",
        "ffconcat version 1.0\n#\x01\nfile '" + other + "'\n",
        std::string(
            "v=0\r\no=- 0 0 IN IP4 127.0.0.1\r\ns=x\r\nc=IN IP4 127.0.0.1\r\nm=video 5004 RTP/AVP 96\r\n"),
        std::string("<?xml version=\"1.0\"?><MPD profiles=\"urn:mpeg:dash:profile:full:2011\"></MPD>")})
    for (const char* name : {"a.mp4", "a.m3u8", "a.ffconcat", "a.sdp", "a.mpd"})
      EXPECT_THAT(refusal(written(name, list)), HasSubstr("list of other files or addresses"))
          << name << list;
}

TEST_F(VideoFile, OfAContainerThatIsNotReadIsRefusedByTheDecoderToo) {
  const auto codec = video_codec();
  ASSERT_TRUE(codec) << codec.error().text();
  ASSERT_TRUE(write_coded_video(at("other.mp4"), "mp4v", 20, 25));
  EXPECT_TRUE((*codec)->stream()->open(at("other.mp4")));
  const std::string other = at("other.mp4").string();
  for (const std::string& list :
       {"#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\n" + other + "\n#EXT-X-ENDLIST\n",
        "ffconcat version 1.0\nfile '" + other + "'\n"})
    for (const char* name : {"a.mp4", "a.m3u8", "a.ffconcat"})
      EXPECT_FALSE((*codec)->stream()->open(written(name, list))) << name << list;
}

TEST_F(VideoFile, AnAddressIsNoFile) {
  for (const char* name :
       {"http://127.0.0.1:9/a.mp4", "concat:/etc/passwd|/etc/group", "pipe:0", "file:///etc/passwd",
        "subfile,,start,0,end,9,,:/etc/passwd", "/dev/zero", "img_%03d.png"})
    EXPECT_THAT(refusal(name), testing::AnyOf(HasSubstr("does not exist"), HasSubstr("is not a video"),
                                              HasSubstr("cannot be read"), HasSubstr("is empty")))
        << name;
}

TEST(PictureTimes, ThatGoBackAreReplacedByTheNominalRateWithAWarning) {
  VideoFacts facts;
  add_times(facts, {{0, 40, 20, 60}, 50, 4});
  EXPECT_THAT(facts.times_s, testing::ElementsAre(0, 0.02, 0.04, 0.06));
  EXPECT_THAT(facts.warnings, Contains(HasSubstr("carry no times that go upwards; 50 Hz")));
}

TEST(PictureTimes, OfTheLastPicturesAreMendedWhereTheDecoderSaysZero) {
  PictureTimes times{{0, 40, 80, 120, 0, 0}, 25, 6};
  EXPECT_EQ(times.mend_end(), 4);
  EXPECT_THAT(times.stamps_ms, testing::ElementsAre(0, 40, 80, 120, 160, 200));
  PictureTimes broken{{0, 40, 0, 80}, 25, 4};
  EXPECT_EQ(broken.mend_end(), 4) << "only an end of zeros is mended";
  EXPECT_FALSE(broken.are_usable());
}

TEST(FrameCache, KeepsThoseUsedLastWithinItsBytes) {
  FrameCache cache(3000);
  const auto frame = [](int index) {
    auto made = std::make_shared<VideoFrame>();
    made->index = index;
    made->rgb.resize(1000);
    return VideoFramePtr(made);
  };
  for (int i = 0; i < 3; ++i) cache.add(frame(i));
  EXPECT_EQ(cache.find(0)->index, 0);
  cache.add(frame(3));
  EXPECT_TRUE(cache.holds(0)) << "was used since";
  EXPECT_FALSE(cache.holds(1));
  EXPECT_EQ(cache.bytes(), 3000u);
}

}  // namespace
}  // namespace abrazo::test::video_reader_test
