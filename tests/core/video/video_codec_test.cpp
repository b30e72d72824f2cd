#include "core/video/video_codec.hpp"

#include <gtest/gtest.h>

namespace abrazo::video_codec_test {
namespace {

namespace fs = std::filesystem;

TEST(VideoCodecPlaces, AreBesideTheProgramAndWhereItIsInstalled) {
  const std::vector<fs::path> places = video_codec_places("/opt/abrazo/bin/abrazo-workbench");
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0], "/opt/abrazo/bin/libabrazo-video.so");
  EXPECT_EQ(places[1].lexically_normal().string().rfind("/opt/abrazo/lib", 0), 0U) << places[1];
}

TEST(VideoCodecPlaces, AreNeverInTheFolderThatTheProgramWasStartedFrom) {
  for (const char* unknown : {"", "abrazo-workbench", "./bin/abrazo-workbench"})
    EXPECT_TRUE(video_codec_places(unknown).empty()) << unknown;
}

}  // namespace
}  // namespace abrazo::video_codec_test
