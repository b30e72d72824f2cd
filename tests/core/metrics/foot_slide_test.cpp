#include "core/metrics/foot_slide.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::foot_slide_test {
namespace {

constexpr ToeRest rest = {0.04, 0.04};  ///< where the toe bases of `standing_pose` rest

std::vector<Pose> sliding(double speed_m_s, double fps, double height_m = 0) {
  std::vector<Pose> poses;
  for (int frame = 0; frame <= static_cast<int>(fps); ++frame)
    poses.push_back(test::moved(test::standing_pose(), 0.4,
                                Vec3(0.6, 0, 0.8) * speed_m_s * frame / fps + Vec3(0, height_m, 0)));
  return poses;
}

FootSlideMetric::Figures measured(const std::vector<Pose>& poses, double fps, const ToeRest& at = rest) {
  FootSlideMetric metric;
  for (std::size_t i = 1; i < poses.size(); ++i) metric.add(poses[i - 1], poses[i], 1 / fps, at);
  return metric.figures();
}

TEST(FootSlide, OfSomeoneWhoStandsStillIsZero) {
  const auto slide = measured(std::vector<Pose>(31, test::standing_pose()), 30);
  EXPECT_EQ(slide.mean_m_s, 0);
  EXPECT_EQ(slide.share_fast, 0);
  EXPECT_EQ(slide.landed, 60);
  EXPECT_EQ(slide.landed_share, 1);
}

TEST(FootSlide, IsTheHorizontalSpeedOfAFootThatSlidesAtAnyRate) {
  for (const double fps : {15.0, 30.0, 60.0}) {
    EXPECT_NEAR(measured(sliding(0.2, fps), fps).mean_m_s, 0.2, 1e-9) << fps;
    EXPECT_EQ(measured(sliding(0.29, fps), fps).share_fast, 0) << fps;
    EXPECT_EQ(measured(sliding(0.31, fps), fps).share_fast, 1) << fps;
  }
}

TEST(FootSlide, LeavesFeetInTheAirOut) {
  std::vector<Pose> poses = sliding(0.2, 60);
  for (Pose& pose : poses) pose(joints::left_toe_base, 1) = 0.2;
  const auto slide = measured(poses, 60);
  EXPECT_EQ(slide.landed, 60);
  EXPECT_EQ(slide.landed_share, 0.5);
  EXPECT_NEAR(slide.mean_m_s, 0.2, 1e-9);
}

TEST(FootSlide, AStepFromOrIntoTheAirIsNotASlide) {
  std::vector<Pose> poses(4, test::standing_pose());
  poses[1] = test::moved(poses[1], 0, {0.3, 0.1, 0});
  poses[2] = test::moved(poses[2], 0, {0.6, 0, 0});
  poses[3] = poses[2];
  const auto slide = measured(poses, 60);
  EXPECT_EQ(slide.landed, 2) << "both feet, the last step only";
  EXPECT_EQ(slide.mean_m_s, 0);
}

TEST(FootSlide, AFootIsLandedBelowThreeCentimetresAboveItsOwnRest) {
  EXPECT_EQ(measured(sliding(0.2, 60, 0.029), 60).landed, 120);
  EXPECT_EQ(measured(sliding(0.2, 60, 0.031), 60).landed, 0);
  EXPECT_EQ(measured(sliding(0.2, 60, 0.031), 60, {0.05, 0.04}).landed, 60) << "of the left foot";
}

TEST(FootSlide, APivotOnTheToesIsNone) {
  std::vector<Pose> poses(2, test::standing_pose());
  for (const int ankle : {joints::left_ankle, joints::right_ankle}) poses[1](ankle, 0) += 0.01;
  EXPECT_EQ(measured(poses, 60).mean_m_s, 0);
}

TEST(FootSlide, RestIsTheHeightOfTheLowestFewFeetOfEitherSide) {
  std::vector<Pose> poses(101, test::standing_pose());
  for (std::size_t frame = 10; frame < 101; ++frame) poses[frame].col(1).array() += 0.3;
  poses[0].col(1).array() -= 0.5;  // one glitch says nothing
  for (Pose& pose : poses) pose(joints::right_toe_base, 1) += 0.01;
  EXPECT_NEAR(toe_rest(poses)[0], 0.04, 1e-12);
  EXPECT_NEAR(toe_rest(poses)[1], 0.05, 1e-12);
}

TEST(FootSlide, OfNothingIsNotANumber) {
  EXPECT_EQ(measured({}, 60).landed, 0);
  EXPECT_TRUE(std::isnan(measured({}, 60).mean_m_s));
  EXPECT_TRUE(std::isnan(measured(sliding(0.2, 60, 1), 60).share_fast));
  EXPECT_EQ(measured(sliding(0.2, 60, 1), 60).landed_share, 0);
}

}  // namespace
}  // namespace abrazo::foot_slide_test
