#include "core/evaluation/takes/user_variant.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/motion/body/body.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::user_variant_test {
namespace {

using namespace test;

TEST(UserVariant, WithoutChangesTheMotionIsTheCapturedOne) {
  const Clip clip = swinging_take("take", 60, 1).a;
  EXPECT_EQ(as_performed_by({}, clip, 1).poses, clip.poses);
}

TEST(UserVariant, AnotherBuildHasTheLengthsAskedFor) {
  const Clip clip = swinging_take("take", 60, 1).a;
  const Clip other = as_performed_by({.legs = 1.1, .trunk = 0.9, .arms = 1.2}, clip, 1);
  const Body was = body_of(clip.poses[17]), is = body_of(other.poses[17]);
  EXPECT_NEAR(is.leg_length(), 1.1 * was.leg_length(), 1e-12);
  for (const int joint : {joints::LeftHumerus, joints::LeftWrist, joints::RightHumerus, joints::RightWrist}) {
    const auto bone = static_cast<std::size_t>(joint - 1);
    EXPECT_NEAR(is.bone_lengths[bone], 1.2 * was.bone_lengths[bone], 1e-12);
  }
  const auto spine = [](const Body& body) { return body.bone_lengths[joints::Thorax - 1]; };
  EXPECT_NEAR(spine(is), 0.9 * spine(was), 1e-12);
}

TEST(UserVariant, AFootThatStoodStillStandsStillOnTheFloorInAnotherBuild) {
  PairedTake take = swinging_take("take", 60, 1);
  const Clip other = as_performed_by({.legs = 0.85, .trunk = 1.1, .arms = 0.7}, take.a, 1);
  for (std::size_t frame = 0; frame < take.a.poses.size(); ++frame) {
    const Vec3 expected = 0.85 * take.a.poses[frame].row(joints::left_toe_base).transpose();
    EXPECT_LT((other.poses[frame].row(joints::left_toe_base).transpose() - expected).norm(), 1e-12);
  }
}

TEST(UserVariant, NoiseHasTheDeviationAskedFor) {
  const Clip clip = swinging_take("take", 600, 1).a;
  const Clip noisy = as_performed_by({.noise_m = 0.02}, clip, 7);
  double sum = 0, squares = 0;
  for (std::size_t frame = 0; frame < clip.poses.size(); ++frame) {
    sum += (noisy.poses[frame] - clip.poses[frame]).sum();
    squares += (noisy.poses[frame] - clip.poses[frame]).squaredNorm();
  }
  const double count = 600.0 * joint_count * 3;
  // 45 000 draws: the mean is within 4 / sqrt(n) deviations, the deviation within 4 / sqrt(2 n) of its value.
  EXPECT_NEAR(sum / count, 0, 4 * 0.02 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.02, 4 * 0.02 / std::sqrt(2 * count));
}

TEST(UserVariant, TheLastFrameThatCameStandsInForThoseLost) {
  const Clip clip = swinging_take("take", 6000, 1).a;
  const Clip gappy = as_performed_by({.lost_share = 0.2, .loss_burst_s = 0.05}, clip, 3);
  int lost = 0, gaps = 0;
  bool in_gap = false;
  for (std::size_t frame = 0; frame < clip.poses.size(); ++frame) {
    const bool is_lost = gappy.poses[frame] != clip.poses[frame];
    if (is_lost) {
      EXPECT_EQ(gappy.poses[frame], gappy.poses[frame - 1]);
    }
    lost += is_lost;
    gaps += is_lost && !in_gap;
    in_gap = is_lost;
  }
  EXPECT_NEAR(lost / 6000.0, 0.2, 0.04);                    // some 400 gaps, their lengths spread as a die's
  EXPECT_NEAR(static_cast<double>(lost) / gaps, 3.0, 0.5);  // 0.05 s of 60 Hz
}

TEST(UserVariant, ADelayShowsWhatWasAndBeginsWithTheFirstPose) {
  const Clip clip = swinging_take("take", 60, 1).a;
  const Clip late = as_performed_by({.delay_s = 0.1}, clip, 1);
  EXPECT_EQ(late.poses[3], clip.poses[0]);
  EXPECT_EQ(late.poses[6], clip.poses[0]);
  EXPECT_EQ(late.poses[59], clip.poses[53]);
}

TEST(UserVariant, SameSeedSameMotion) {
  const Clip clip = swinging_take("take", 60, 1).a;
  const UserVariant noisy{.noise_m = 0.01, .lost_share = 0.3};
  EXPECT_EQ(as_performed_by(noisy, clip, 5).poses, as_performed_by(noisy, clip, 5).poses);
  EXPECT_NE(as_performed_by(noisy, clip, 5).poses, as_performed_by(noisy, clip, 6).poses);
}

TEST(UserVariant, EveryUserOfTheReportHasANameOfItsOwnAndDiffers) {
  const Clip clip = swinging_take("take", 240, 1).a;
  std::set<std::string> names = {UserVariant{}.name};
  for (const auto& variants : {other_builds(), disturbances()})
    for (const UserVariant& variant : variants) {
      EXPECT_TRUE(names.insert(variant.name).second) << variant.name;
      EXPECT_NE(as_performed_by(variant, clip, 1).poses, clip.poses) << variant.name;
    }
}

}  // namespace
}  // namespace abrazo::user_variant_test
