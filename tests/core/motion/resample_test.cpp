#include "core/motion/body/resample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/motion/body/body.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::resample_test {
namespace {

/// A body that walks along +X at 1 m/s.
StampedPose walking(double time_s) {
  return {time_s, test::moved(test::standing_pose(), 0, Vec3(time_s, 0, 0))};
}

TEST(Resample, UnevenStampsBecomeEven) {
  const std::vector<StampedPose> stamped = {walking(2.0), walking(2.013), walking(2.021), walking(2.042)};
  const EvenPoses even = resample(stamped, 100);
  ASSERT_EQ(even.poses.size(), 5U);
  EXPECT_EQ(even.timing.first_s, 2.0);
  EXPECT_FALSE(even.timing.unchanged);
  for (std::size_t i = 0; i < even.poses.size(); ++i)
    EXPECT_LT((even.poses[i] - walking(2.0 + 0.01 * static_cast<double>(i)).pose).norm(), 1e-12);
}

TEST(Resample, EvenStampsKeepTheirPosesBitForBit) {
  std::vector<StampedPose> stamped;
  for (int i = 0; i < 50; ++i) stamped.push_back(walking(0.1 + i / 60.0));
  const EvenPoses even = resample(stamped, 60);
  EXPECT_TRUE(even.timing.unchanged);
  ASSERT_EQ(even.poses.size(), stamped.size());
  for (std::size_t i = 0; i < stamped.size(); ++i) EXPECT_EQ(even.poses[i], stamped[i].pose);
}

TEST(Resample, BonesKeepTheirLengthsAlsoBetweenDistantPoses) {
  const Pose from = test::standing_pose();
  const Pose to = test::bent(from, joints::left_elbow, 2.0, Vec3::UnitZ());
  const Pose middle = blended(from, to, 0.5);
  EXPECT_LT(largest_length_difference(body_of(middle), body_of(from)), 1e-12);
  const auto forearm = [](const Pose& pose) {
    return Vec3((pose.row(joints::left_wrist) - pose.row(joints::left_elbow)).transpose()).normalized();
  };
  const double whole = std::acos(forearm(from).dot(forearm(to)));
  EXPECT_GT(whole, 0.9);
  EXPECT_NEAR(std::acos(forearm(from).dot(forearm(middle))), whole / 2, 1e-9);
  EXPECT_NEAR(std::acos(forearm(middle).dot(forearm(to))), whole / 2, 1e-9);
}

TEST(Resample, BlendingEndsAtBothPoses) {
  const auto take = test::swinging_take("t", 40, 3);
  EXPECT_LT((blended(take.a.poses[0], take.a.poses[30], 0) - take.a.poses[0]).norm(), 1e-12);
  EXPECT_LT((blended(take.a.poses[0], take.a.poses[30], 1) - take.a.poses[30]).norm(), 1e-12);
}

TEST(Resample, SaysWhereTheGapsAre) {
  std::vector<StampedPose> stamped;
  for (int i = 0; i < 20; ++i) stamped.push_back(walking(i * 0.01));
  for (int i = 0; i < 20; ++i) stamped.push_back(walking(1.19 + i * 0.01));
  for (int i = 0; i < 20; ++i) stamped.push_back(walking(1.48 + i * 0.01));
  const EvenPoses even = resample(stamped, 100);
  EXPECT_EQ(even.timing.gaps, 2U);
  EXPECT_NEAR(even.timing.longest_gap_s, 1.0, 1e-12);
  EXPECT_NEAR(even.timing.longest_gap_at_s, 0.19, 1e-12);
  EXPECT_EQ(even.timing.bridged, 99U + 9U) << "between the frames at the ends of each gap";
}

TEST(Resample, HasAsManyPosesAsItsTimingSaysWithoutThem) {
  std::vector<StampedPose> stamped;
  for (int i = 0; i < 30; ++i) stamped.push_back(walking(i / 30.0));
  for (int i = 0; i < 90; ++i) stamped.push_back(walking(1.4 + i / 60.0));
  for (const double rate_hz : {30.0, 50.0, 60.0}) {
    const EvenTiming timing = even_timing(times_of(stamped), rate_hz);
    EXPECT_EQ(resample(stamped, rate_hz).poses.size(), timing.frames) << rate_hz;
    EXPECT_GT(timing.bridged, 0U) << rate_hz;
    EXPECT_LT(timing.bridged, static_cast<std::size_t>(0.5 * rate_hz)) << rate_hz;
  }
}

TEST(Resample, AStampThatIsNotLaterIsLeftOutAndCounted) {
  const std::vector<StampedPose> stamped = {walking(0), walking(0.01), walking(0.005), walking(0.01),
                                            walking(0.02)};
  const EvenPoses even = resample(stamped, 100);
  EXPECT_EQ(even.timing.discarded, 2U);
  EXPECT_EQ(even.poses.size(), 3U);
}

TEST(Resample, OnePoseIsAClip) {
  const std::vector<StampedPose> one = {walking(3)};
  EXPECT_EQ(resample(one, 60).poses.size(), 1U);
  EXPECT_EQ(median_rate_hz(times_of(one)), 0);
}

TEST(Resample, NeedsPosesAndARate) {
  const std::vector<StampedPose> one = {walking(3)};
  EXPECT_THROW(resample({}, 60), std::invalid_argument);
  EXPECT_THROW(resample(one, 0), std::invalid_argument);
  EXPECT_THROW(resample(one, std::nan("")), std::invalid_argument);
}

TEST(MedianRate, IsNotMovedByAFewGaps) {
  std::vector<StampedPose> stamped;
  for (int i = 0; i < 100; ++i) stamped.push_back(walking(i / 120.0 + (i > 50 ? 3.0 : 0.0)));
  EXPECT_NEAR(median_rate_hz(times_of(stamped)), 120, 1e-6);
}

}  // namespace
}  // namespace abrazo::resample_test
