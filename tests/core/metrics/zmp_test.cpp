#include "core/metrics/zmp.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::zmp_test {
namespace {

constexpr double gravity = 9.81;

/// All mass 1 m above the origin; toe bases, which carry none, on the floor 4 cm to either side. So the
/// support polygon is 8 cm of the x axis.
Pose point_mass() {
  Pose pose = Pose::Zero();
  pose.col(1).setOnes();
  pose.row(joints::left_toe_base) << 0.04, 0, 0;
  pose.row(joints::right_toe_base) << -0.04, 0, 0;
  return pose;
}

Pose lifted(Pose pose, int toe_base, double height_m) {
  pose(toe_base, 1) = height_m;
  return pose;
}

std::vector<Pose> moving(const Pose& pose, double fps, double duration_s,
                         const std::function<Vec3(double)>& offset) {
  const int frames = static_cast<int>(std::lround(duration_s * fps));
  std::vector<Pose> poses;
  poses.reserve(static_cast<std::size_t>(frames));
  for (int frame = 0; frame < frames; ++frame) poses.push_back(test::moved(pose, 0, offset(frame / fps)));
  return poses;
}

/// Accelerating at `a` throughout; heights stay, whatever `a.y()` is, so that the feet keep their contact.
std::vector<Pose> accelerating(const Vec3& a, double fps = 60, const Pose& pose = point_mass()) {
  return moving(pose, fps, 1, [&](double t) { return Vec3(0.5 * a * t * t); });
}

ZmpSettings touching_anyhow() {
  ZmpSettings settings;
  settings.contact_height_m = 1000;
  return settings;
}

TEST(Zmp, OfSomeoneStandingStillIsInsideTheFeet) {
  const std::vector<Pose> poses(60, test::standing_pose());
  const ZmpError error = measure_zmp(poses, 60, {});
  EXPECT_EQ(error.error_m.size(), 50U);
  EXPECT_EQ(error.frames.front(), 5);
  EXPECT_EQ(error.frames.back(), 54);
  EXPECT_EQ(error.skipped_ends, 10);
  EXPECT_EQ(error.mean_m(), 0);
}

TEST(Zmp, OfSomeoneStandingStillIsUnderTheCentreOfMass) {
  Pose pose = point_mass();
  pose.row(joints::left_toe_base) << 0.30, 0, 0.40;  // both feet of the line from the origin to (0.3, 0.4)
  pose.row(joints::right_toe_base) << 0.30, 0, 0.40;
  for (const int joint :
       {joints::left_ankle, joints::right_ankle, joints::left_toe_tip, joints::right_toe_tip})
    pose.row(joint) << 0.30, 1, 0.40;
  const std::vector<Pose> poses(20, pose);
  const Vec3 centre = centre_of_mass(body_segments(SegmentTable::Mean), pose);
  const ZmpError error = measure_zmp(poses, 60, {});
  EXPECT_NEAR(error.mean_m(), std::hypot(0.30 - centre.x(), 0.40 - centre.z()), 1e-12);
}

TEST(Zmp, MovesAgainstTheAccelerationByHeightOverGravity) {
  // a h / g = 0.981 * 1 / 9.81 = 10 cm to the side, of which 4 cm are on the foot; 10 cm across it.
  EXPECT_NEAR(measure_zmp(accelerating({0.981, 0, 0}), 60, {}).mean_m(), 0.06, 1e-9);
  EXPECT_NEAR(measure_zmp(accelerating({-0.981, 0, 0}), 60, {}).mean_m(), 0.06, 1e-9);
  EXPECT_NEAR(measure_zmp(accelerating({0, 0, 0.981}), 60, {}).mean_m(), 0.10, 1e-9);
  EXPECT_NEAR(measure_zmp(accelerating({0.3, 0, 0}), 60, {}).mean_m(), 0, 1e-9) << "3 cm is on the foot";
}

TEST(Zmp, MovesFartherTheLessPressesOnTheFloor) {
  // Heights above the floor count: the pose sinks at g / 2, so the error is a h / (g - g / 2) - 4 cm.
  const double a = 0.2;
  const std::vector<Pose> poses = accelerating({a, -0.5 * gravity, 0});
  const ZmpError error = measure_zmp(poses, 60, touching_anyhow());
  ASSERT_EQ(error.error_m.size(), 50U);
  for (std::size_t n = 0; n < error.error_m.size(); ++n) {
    const double height = poses[static_cast<std::size_t>(error.frames[n])](joints::Root, 1);
    EXPECT_NEAR(error.error_m[n], std::max(0.0, std::abs(a * height / (0.5 * gravity)) - 0.04), 1e-9);
  }
}

TEST(Zmp, IsMeasuredFromTheFloorsHeight) {
  std::vector<Pose> poses = accelerating({0, 0, 0.981});
  for (Pose& pose : poses) pose.col(1).array() += 0.7;
  ZmpSettings settings;
  settings.floor_m = 0.7;
  EXPECT_NEAR(measure_zmp(poses, 60, settings).mean_m(), 0.10, 1e-9);
  settings.floor_m = 0.65;
  EXPECT_NEAR(measure_zmp(poses, 60, settings).mean_m(), 0.105, 1e-9);
}

TEST(Zmp, IsNotDefinedInFreeFall) {
  const ZmpError falling = measure_zmp(accelerating({0, -0.85 * gravity, 0}), 60, touching_anyhow());
  EXPECT_EQ(falling.skipped_free_fall, 50);
  EXPECT_TRUE(falling.error_m.empty());
  EXPECT_EQ(falling.mean_m(), 0);
  const ZmpError sinking = measure_zmp(accelerating({0, -0.75 * gravity, 0}), 60, touching_anyhow());
  EXPECT_EQ(sinking.skipped_free_fall, 0);
  EXPECT_EQ(sinking.error_m.size(), 50U);
}

TEST(Zmp, CountsOnlyFeetOnTheFloor) {
  // Only the left foot is down: from the ankle over the origin to the toe base at x = 4 cm.
  const Pose left_only = lifted(point_mass(), joints::right_toe_base, 0.11);
  EXPECT_NEAR(measure_zmp(accelerating({-0.981, 0, 0}, 60, left_only), 60, {}).mean_m(), 0.06, 1e-9);
  EXPECT_NEAR(measure_zmp(accelerating({0.981, 0, 0}, 60, left_only), 60, {}).mean_m(), 0.10, 1e-9);
  const Pose nearly = lifted(point_mass(), joints::right_toe_base, 0.09);
  EXPECT_NEAR(measure_zmp(accelerating({0.981, 0, 0}, 60, nearly), 60, {}).mean_m(), 0.06, 1e-9);
}

TEST(Zmp, ATipOnTheFloorIsContactToo) {
  Pose pose = lifted(lifted(point_mass(), joints::right_toe_base, 0.2), joints::left_toe_base, 0.2);
  EXPECT_EQ(measure_zmp(std::vector<Pose>(20, pose), 60, {}).skipped_no_support, 10);
  pose(joints::left_toe_tip, 1) = 0.05;
  EXPECT_EQ(measure_zmp(std::vector<Pose>(20, pose), 60, {}).skipped_no_support, 0);
}

TEST(Zmp, SkippedFramesAreCountedOnce) {
  const Pose jumping = lifted(lifted(point_mass(), joints::right_toe_base, 0.2), joints::left_toe_base, 0.2);
  std::vector<Pose> poses(30, point_mass());
  for (std::size_t frame = 10; frame < 17; ++frame) poses[frame] = jumping;
  const ZmpError error = measure_zmp(poses, 60, {});
  EXPECT_EQ(error.skipped_no_support, 7);
  EXPECT_EQ(error.skipped_ends, 10);
  EXPECT_EQ(error.error_m.size(), error.frames.size());
  EXPECT_EQ(static_cast<int>(error.error_m.size()) + error.skipped(), 30);
}

TEST(Zmp, WindowIsATriangleOverAccelerations) {
  // One frame is 5 mm off: accelerations d fps^2 (1, -2, 1), averaged with the weights 1 2 3 4 5 4 3 2 1 of
  // 25, are -2/25 d fps^2 in that frame, 1/25 d fps^2 five frames from it, and 0 elsewhere.
  std::vector<Pose> poses(40, lifted(point_mass(), joints::right_toe_base, 0.2));
  for (Pose& pose : poses) pose.row(joints::left_toe_base) << 0, 0, 0;  // the foot is a point
  poses[20].col(2).array() += 0.005;
  const ZmpError error = measure_zmp(poses, 60, {});
  for (std::size_t n = 0; n < error.error_m.size(); ++n) {
    const int from_it = std::abs(error.frames[n] - 20);
    const double acceleration = from_it == 0 ? 2 / 25.0 : from_it == 5 ? 1 / 25.0 : 0;
    EXPECT_NEAR(error.error_m[n], acceleration * 0.005 * 3600 / gravity, 1e-12) << error.frames[n];
  }
}

TEST(Zmp, WindowReachesAsFarInTimeAtEveryRate) {
  EXPECT_EQ(smoothing_half_width({}, 60), 4);
  EXPECT_EQ(smoothing_half_width({}, 30), 2);
  EXPECT_EQ(smoothing_half_width({}, 15), 1);
  ZmpSettings unsmoothed;
  unsmoothed.smoothing_s = 0;
  EXPECT_EQ(smoothing_half_width(unsmoothed, 60), 0);
  EXPECT_EQ(measure_zmp(std::vector<Pose>(20, point_mass()), 60, unsmoothed).skipped_ends, 2);
}

TEST(Zmp, DoesNotDependOnTheRateOfASmoothMotion) {
  for (const double fps : {15.0, 30.0, 60.0, 120.0})
    EXPECT_NEAR(measure_zmp(accelerating({0.981, 0, 0}, fps), fps, {}).mean_m(), 0.06, 1e-9) << fps;
  // Swaying at 0.5 Hz by 20 cm: a h / g reaches 20 cm.
  const auto sway = [](double t) { return Vec3(0, 0, 0.2 * std::sin(3.1415927 * t)); };
  const double at_60 = measure_zmp(moving(point_mass(), 60, 20, sway), 60, {}).mean_m();
  const double at_15 = measure_zmp(moving(point_mass(), 15, 20, sway), 15, {}).mean_m();
  EXPECT_NEAR(at_60, 2 / 3.1415927 * 0.2 * 9.8696 / gravity, 0.002);
  EXPECT_NEAR(at_15, at_60, 0.002);
}

TEST(Zmp, DoesNotChangeUnderATurnAndAShift) {
  std::vector<Pose> poses = test::swinging_take("swing", 120, 4).a.poses;
  for (std::size_t frame = 0; frame < poses.size(); ++frame)
    poses[frame] = test::moved(poses[frame], 0, {0.3 * std::sin(0.05 * static_cast<double>(frame)), 0, 0});
  std::vector<Pose> elsewhere;
  elsewhere.reserve(poses.size());
  for (const Pose& pose : poses) elsewhere.push_back(test::moved(pose, 1.1, {3, 0, -2}));
  const ZmpError here = measure_zmp(poses, 60, {});
  const ZmpError there = measure_zmp(elsewhere, 60, {});
  ASSERT_EQ(here.error_m.size(), there.error_m.size());
  EXPECT_GT(here.mean_m(), 0.001) << "a motion that has an error";
  for (std::size_t n = 0; n < here.error_m.size(); ++n) EXPECT_NEAR(here.error_m[n], there.error_m[n], 1e-9);
}

TEST(Zmp, AWiderSoleTakesItsMarginOff) {
  ZmpSettings settings;
  settings.sole_margin_m = 0.04;
  EXPECT_NEAR(measure_zmp(accelerating({0.981, 0, 0}), 60, settings).mean_m(), 0.02, 1e-9);
  settings.sole_margin_m = 0.08;
  EXPECT_EQ(measure_zmp(accelerating({0.981, 0, 0}), 60, settings).mean_m(), 0);
}

TEST(Zmp, TwoMotionsTogetherHaveTheMeanOfAllFrames) {
  ZmpError both = measure_zmp(accelerating({0.981, 0, 0}), 60, {});   // 50 frames at 6 cm
  both.append(measure_zmp(accelerating({0, 0, 0.981}, 30), 30, {}));  // 24 frames at 10 cm
  EXPECT_NEAR(both.mean_m(), (50 * 0.06 + 24 * 0.10) / 74, 1e-9);
  EXPECT_EQ(both.skipped_ends, 10 + 6);
}

TEST(Zmp, OfTooFewFramesIsNothing) {
  EXPECT_EQ(measure_zmp({}, 60, {}).skipped(), 0);
  EXPECT_EQ(measure_zmp({}, 60, {}).mean_m(), 0);
  const ZmpError error = measure_zmp(std::vector<Pose>(9, point_mass()), 60, {});
  EXPECT_EQ(error.skipped_ends, 9);
  EXPECT_TRUE(error.error_m.empty());
}

TEST(Zmp, RefusesAnImpossibleRateOrWindow) {
  const std::vector<Pose> poses(20, point_mass());
  EXPECT_THROW(measure_zmp(poses, 0, {}), std::invalid_argument);
  ZmpSettings settings;
  settings.smoothing_s = -0.1;
  EXPECT_THROW(measure_zmp(poses, 60, settings), std::invalid_argument);
}

TEST(ZmpComparison, IsOverTheFramesThatCountInBoth) {
  ZmpError captured, made;
  captured.frames = {5, 6, 7, 8};
  captured.error_m = {0.01, 0.02, 0.03, 0.04};
  made.frames = {6, 8, 9};  // 5 and 7 are free fall
  made.error_m = {0.10, 0.20, 0.30};
  ZmpComparison comparison;
  comparison.add(captured, made);
  EXPECT_EQ(comparison.common().frames, 2);
  EXPECT_NEAR(comparison.common().first_m, 0.03, 1e-12);
  EXPECT_NEAR(comparison.common().second_m, 0.15, 1e-12);
  ZmpComparison of_another;
  of_another.add(captured, captured);
  comparison.append(of_another);
  EXPECT_EQ(comparison.common().frames, 6);
  EXPECT_TRUE(std::isnan(ZmpComparison().common().second_m));
}

}  // namespace
}  // namespace abrazo::zmp_test
