// Two streamed performers become a paired take.
#include "core/session/run/pair_capture.hpp"

#include <gtest/gtest.h>

namespace abrazo::pair_capture_test {
namespace {

/// A pose whose every coordinate is its time.
ReceivedPose pose_of(const std::string& performer, double time_s) {
  ReceivedPose received;
  received.performer = performer;
  received.pose.time_s = time_s;
  received.pose.pose = Pose::Constant(time_s);
  return received;
}

void stream(PairCapture& capture, const std::string& performer, double from_s, double to_s, double rate_hz) {
  for (int i = 0; from_s + i / rate_hz <= to_s + 1e-9; ++i)
    capture.add(pose_of(performer, from_s + i / rate_hz));
}

class CapturedPair : public testing::Test {
 protected:
  CapturedPair() : capture("Ana", "Ben") {
    stream(capture, "Ana", 10, 14, 120);
    stream(capture, "Ben", 10.5, 13.5, 60);
    stream(capture, "Cleo", 0, 20, 60);
  }
  PairCapture capture;
  PairCapture::Wishes wishes{"salsa 001", ActivePerformer::B, "turn", 0, 0};
};

TEST_F(CapturedPair, LastsAsLongAsBothAreThere) {
  EXPECT_NEAR(capture.state().length_s, 3, 1e-9);
  EXPECT_EQ(capture.state().b, 181U);
}

TEST_F(CapturedPair, HasTheLowerRateAndPosesOfTheSameInstant) {
  const auto take = capture.take(wishes);
  ASSERT_TRUE(take) << take.error().text();
  EXPECT_DOUBLE_EQ(take->fps, 60);
  ASSERT_EQ(take->a.poses.size(), 181U);
  ASSERT_EQ(take->b.poses.size(), 181U);
  for (const std::size_t frame : {0UL, 77UL, 180UL}) {
    const double time_s = 10.5 + static_cast<double>(frame) / 60;
    EXPECT_NEAR(take->a.poses[frame](3, 1), time_s, 1e-9);
    EXPECT_NEAR(take->b.poses[frame](3, 1), time_s, 1e-9);
  }
}

TEST_F(CapturedPair, HasTheRoleAndTheLabelThroughout) {
  const auto take = capture.take(wishes);
  ASSERT_TRUE(take);
  EXPECT_EQ(active_at(*take, 0), ActivePerformer::B);
  EXPECT_EQ(active_at(*take, 180), ActivePerformer::B);
  EXPECT_EQ(label_at(take->labels, 100), "turn");
  wishes.leads = ActivePerformer::Unknown;
  wishes.label.clear();
  const auto bare = capture.take(wishes);
  EXPECT_TRUE(bare->roles.empty());
  EXPECT_TRUE(bare->labels.empty());
}

TEST_F(CapturedPair, IsCutAtBothEnds) {
  wishes.in_s = 0.5;
  wishes.out_s = 1;
  const auto take = capture.take(wishes);
  ASSERT_TRUE(take);
  EXPECT_EQ(take->a.poses.size(), 91U);
  EXPECT_NEAR(take->a.poses.front()(0, 0), 11, 1e-9);
  wishes.out_s = 2.3;
  EXPECT_FALSE(capture.take(wishes)) << "too little is left";
}

TEST_F(CapturedPair, RefusesATakeInWhichSomebodyWasLost) {
  stream(capture, "Ben", 14, 16, 60);
  stream(capture, "Ana", 14.01, 16, 120);
  const auto take = capture.take(wishes);
  ASSERT_FALSE(take);
  EXPECT_NE(take.error().text().find("Ben"), std::string::npos);
  EXPECT_NE(take.error().text().find("lost for 0.5 s"), std::string::npos) << take.error().text();
  wishes.in_s = 3.5;
  EXPECT_TRUE(capture.take(wishes)) << "what is cut off does not count";
}

TEST(PairCapture, NeedsBothPerformers) {
  PairCapture capture("Ana", "Ben");
  stream(capture, "Ana", 0, 3, 60);
  EXPECT_EQ(capture.state().length_s, 0);
  const auto take = capture.take({"x", ActivePerformer::A, "", 0, 0});
  ASSERT_FALSE(take);
  EXPECT_NE(take.error().text().find("Ben"), std::string::npos);
}

TEST(PairCapture, APoseLostHereAndThereDoesNotLowerTheRate) {
  PairCapture capture("Ana", "Ben");
  stream(capture, "Ana", 0, 4, 60);
  for (int i = 0; i <= 240; ++i)
    if (i % 20 != 7) capture.add(pose_of("Ben", i / 60.0));
  const auto take = capture.take({"salsa 001", ActivePerformer::A, "", 0, 0});
  ASSERT_TRUE(take) << take.error().text();
  EXPECT_EQ(take->fps, 60);
  ASSERT_EQ(take->b.poses.size(), 241U);
  EXPECT_NEAR(take->b.poses[7](3, 1), 7 / 60.0, 1e-9) << "straight between its neighbours";
}

TEST(PairCapture, PassesOverPosesThatAreNotNewer) {
  PairCapture capture("Ana", "Ben");
  capture.add(pose_of("Ana", 1));
  capture.add(pose_of("Ana", 1));
  capture.add(pose_of("Ana", 0.5));
  EXPECT_EQ(capture.state().a, 1U);
}

}  // namespace
}  // namespace abrazo::pair_capture_test
