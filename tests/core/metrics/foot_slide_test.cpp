#include "core/metrics/foot_slide.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/motion/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::foot_slide_test {
namespace {

constexpr double floor_m = 0.04;  ///< where the toe bases of `standing_pose` rest

std::vector<Pose> sliding(double speed_m_s, double fps, double height_m = 0) {
  std::vector<Pose> poses;
  for (int frame = 0; frame <= static_cast<int>(fps); ++frame)
    poses.push_back(test::moved(test::standing_pose(), 0.4,
                                Vec3(0.6, 0, 0.8) * speed_m_s * frame / fps + Vec3(0, height_m, 0)));
  return poses;
}

std::vector<Pose> with_left_foot_in_the_air(std::vector<Pose> poses) {
  for (Pose& pose : poses) pose(joints::left_toe_base, 1) = 0.2;
  return poses;
}

TEST(FootSlide, OfSomeoneWhoStandsStillIsZero) {
  const FootSlide slide = measure_foot_slide(std::vector<Pose>(31, test::standing_pose()), 30, floor_m);
  EXPECT_EQ(slide.speed_m_s, 0);
  EXPECT_EQ(slide.weighted_m_s, 0);
  EXPECT_EQ(slide.landed_frames, 60);
  EXPECT_EQ(slide.foot_frames, 60);
}

TEST(FootSlide, IsTheSpeedOfAFootThatSlides) {
  for (const double fps : {15.0, 30.0, 60.0}) {
    const FootSlide slide = measure_foot_slide(sliding(0.2, fps), fps, floor_m);
    EXPECT_NEAR(slide.speed_m_s, 0.2, 1e-9) << fps;
    EXPECT_NEAR(slide.ankle_speed_m_s, 0.2, 1e-9) << fps;
    EXPECT_NEAR(slide.distance_m_per_s, 0.4, 1e-9) << "two feet, at " << fps;
    EXPECT_NEAR(slide.weighted_m_s, 0.2, 1e-9) << fps;
    EXPECT_EQ(slide.sliding_share, 0) << "2.5 cm in 1/30 s is 0.75 m/s, at " << fps;
    EXPECT_EQ(measure_foot_slide(sliding(0.8, fps), fps, floor_m).sliding_share, 1) << fps;
  }
}

TEST(FootSlide, LeavesFeetInTheAirOut) {
  const FootSlide slide = measure_foot_slide(with_left_foot_in_the_air(sliding(0.2, 60)), 60, floor_m);
  EXPECT_EQ(slide.landed_frames, 60);
  EXPECT_EQ(slide.foot_frames, 120);
  EXPECT_NEAR(slide.speed_m_s, 0.2, 1e-9);
  EXPECT_NEAR(slide.distance_m_per_s, 0.2, 1e-9) << "one foot";
  EXPECT_NEAR(slide.weighted_m_s, 0.1, 1e-9) << "mean over both feet, 0 for the one in the air";
}

TEST(FootSlide, AStepFromOrIntoTheAirIsNotASlide) {
  std::vector<Pose> poses(4, test::standing_pose());
  poses[1] = test::moved(poses[1], 0, {0.3, 0.1, 0});
  poses[2] = test::moved(poses[2], 0, {0.6, 0, 0});
  poses[3] = poses[2];
  const FootSlide slide = measure_foot_slide(poses, 60, floor_m);
  EXPECT_EQ(slide.landed_frames, 2) << "both feet, the last step only";
  EXPECT_EQ(slide.speed_m_s, 0);
}

TEST(FootSlide, LandsBelowTheHeightAskedFor) {
  EXPECT_EQ(measure_foot_slide(sliding(0.2, 60, 0.029), 60, floor_m).landed_frames, 120);
  EXPECT_EQ(measure_foot_slide(sliding(0.2, 60, 0.031), 60, floor_m).landed_frames, 0);
  EXPECT_EQ(measure_foot_slide(sliding(0.2, 60, 0.031), 60, floor_m).speed_m_s, 0);
  EXPECT_EQ(measure_foot_slide(sliding(0.2, 60, 0.031), 60, floor_m, 0.05).landed_frames, 120);
}

TEST(FootSlide, WeightFallsFromOneOnTheFloorToZeroAt25Millimetres) {
  const auto weighted = [](double height_m) {
    return measure_foot_slide(sliding(0.2, 60, height_m), 60, floor_m).weighted_m_s;
  };
  EXPECT_NEAR(weighted(0.0125), 0.2 * (2 - std::sqrt(2.0)), 1e-9);
  EXPECT_NEAR(weighted(0.026), 0, 1e-9);
  EXPECT_NEAR(weighted(-0.01), 0.2, 1e-9) << "not more below the floor";
}

TEST(FootSlide, APivotOnTheToesMovesTheAnkleOnly) {
  std::vector<Pose> poses(2, test::standing_pose());
  for (const int ankle : {joints::left_ankle, joints::right_ankle}) poses[1](ankle, 0) += 0.01;
  const FootSlide slide = measure_foot_slide(poses, 60, floor_m);
  EXPECT_EQ(slide.speed_m_s, 0);
  EXPECT_NEAR(slide.ankle_speed_m_s, 0.6, 1e-9);
}

TEST(FootSlide, RestHeightIsThatOfTheLowestFewFeet) {
  std::vector<Pose> poses(100, test::standing_pose());
  for (std::size_t frame = 10; frame < 100; ++frame) poses[frame].col(1).array() += 0.3;
  poses[0].col(1).array() -= 0.5;  // one glitch says nothing
  EXPECT_NEAR(toe_rest_height(poses), 0.04, 1e-12);
}

TEST(FootSlide, OfNothingIsNothing) {
  EXPECT_EQ(measure_foot_slide({}, 60, 0).foot_frames, 0);
  EXPECT_EQ(measure_foot_slide(std::vector<Pose>(1, test::standing_pose()), 60, 0.04).foot_frames, 0);
  EXPECT_EQ(toe_rest_height({}), 0);
  EXPECT_THROW(measure_foot_slide({}, 0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::foot_slide_test
