// How the time of a video goes with that of a session.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/video/video_sync.hpp"

namespace abrazo::test::video_sync_test {
namespace {

TEST(VideoSync, WithoutAPointBothBeginTogether) {
  EXPECT_DOUBLE_EQ(VideoSync{}.video_time(2.5), 2.5);
  EXPECT_DOUBLE_EQ((VideoSync{{}, 0.5}.video_time(3)), 1.5);
  EXPECT_DOUBLE_EQ((VideoSync{{}, 0.5}.subject_time(1.5)), 3);
}

TEST(VideoSync, OnePointGivesTheOffset) {
  const VideoSync sync{{{10, 3}}, 1};
  EXPECT_DOUBLE_EQ(sync.video_time(10), 3);
  EXPECT_DOUBLE_EQ(sync.video_time(12.5), 5.5);
  EXPECT_DOUBLE_EQ(sync.video_time(0), -7);
  const VideoSync slow{{{10, 3}}, 0.25};
  EXPECT_DOUBLE_EQ(slow.video_time(14), 4);
}

TEST(VideoSync, TwoPointsGiveTheDriftToo) {
  // A camera at 29.97 Hz whose file says 30: 1001 ms for every 1000.
  const VideoSync sync{{{5, 1}, {1005, 1002}}, 7};
  EXPECT_DOUBLE_EQ(sync.effective_rate(), 1.001);
  EXPECT_DOUBLE_EQ(sync.video_time(5), 1);
  EXPECT_DOUBLE_EQ(sync.video_time(1005), 1002);
  EXPECT_NEAR(sync.video_time(505), 501.5, 1e-12);
}

TEST(VideoSync, ThereAndBackIsTheSameTime) {
  for (const VideoSync& sync : {VideoSync{}, VideoSync{{{4, 9}}, 0.5}, VideoSync{{{0, 2}, {60, 61.9}}, 1}})
    for (const double subject_s : {-3.0, 0.0, 17.25, 3600.0})
      EXPECT_NEAR(sync.subject_time(sync.video_time(subject_s)), subject_s, 1e-9);
}

TEST(VideoSync, RefusesTimeThatStandsOrGoesBackwards) {
  EXPECT_TRUE(check_sync({}));
  EXPECT_TRUE(check_sync({{{1, 2}, {3, 4}}, 1}));
  EXPECT_FALSE(check_sync({{}, 0}));
  EXPECT_FALSE(check_sync({{{1, 2}, {1, 4}}, 1}));
  const Status backwards = check_sync({{{1, 4}, {3, 2}}, 1});
  ASSERT_FALSE(backwards);
  EXPECT_THAT(backwards.error().text(), testing::HasSubstr("2.000 s apart in the recording and -2.000 s"));
}

}  // namespace
}  // namespace abrazo::test::video_sync_test
