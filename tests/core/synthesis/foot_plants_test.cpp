#include "core/synthesis/motion/foot_plants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/library/build/motion_library_builder.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::foot_plants_test {
namespace {

constexpr double step_s = 1.0 / 60;
constexpr double rest_height = 0.04;

/// Both feet standing, drifting to the side; 2 cm over rest in the recording.
std::array<FootMoment, 2> drifting(double time_s, double speed) {
  std::array<FootMoment, 2> feet;
  for (std::size_t f = 0; f < 2; ++f) {
    const double side = f == 0 ? 0.1 : -0.1;
    feet[f].free = Vec3(side + speed * time_s, rest_height + 0.02, 0.1);
    feet[f].ankle = feet[f].free + Vec3(0, 0.05, -0.1);
    feet[f].hip = Vec3(side + speed * time_s, 0.9, 0);
    feet[f].leg_length = 0.87;
    feet[f].rest_height = rest_height;
    feet[f].recorded_height = rest_height + 0.02;
    feet[f].lands = true;
  }
  return feet;
}

TEST(FootPlants, AStandingFootStaysWhereItLandedAndDoesNotHover) {
  FootPlants plants;
  Vec3 landed = Vec3::Zero();
  for (int step = 0; step < 60; ++step) {
    const auto shown = plants.update(drifting(step * step_s, 0.1), step == 0 ? 0 : step_s);
    if (step == 0) landed = shown[0];
    EXPECT_TRUE(plants.feet()[0].planted);
    EXPECT_LT(std::hypot(shown[0].x() - landed.x(), shown[0].z() - landed.z()), 1e-9);
    if (step > 6) {
      EXPECT_LT(shown[0].y(), rest_height + 0.015);
    }
  }
}

TEST(FootPlants, AFootThatIsTooFarOffTakesAStepOneAtATime) {
  FootPlants plants;
  bool stepped = false;
  for (int step = 0; step < 300; ++step) {
    plants.update(drifting(step * step_s, 0.3), step == 0 ? 0 : step_s);
    stepped |= plants.feet()[0].steps || plants.feet()[1].steps;
    EXPECT_FALSE(plants.feet()[0].steps && plants.feet()[1].steps) << step;
  }
  EXPECT_TRUE(stepped);
}

TEST(FootPlants, AStepIsSixCentimetresHighInItsMiddleAndTheSameUpAndDown) {
  FootPlants plants;
  std::vector<double> heights;
  for (int step = 0; step < 300 && (heights.empty() || plants.feet()[0].steps); ++step) {
    const auto feet = drifting(step * step_s, 0.3);
    const auto shown = plants.update(feet, step == 0 ? 0 : step_s);
    const FootPlants::Foot& foot = plants.feet()[0];
    if (foot.steps) heights.push_back(shown[0].y() - feet[0].free.y() - foot.lift);
  }
  ASSERT_GE(heights.size(), 24U) << "0.4 s";
  EXPECT_NEAR(heights[12], 0.06, 1e-9);
  EXPECT_EQ(*std::max_element(heights.begin(), heights.end()), heights[12]);
  EXPECT_NEAR(heights[0], 0, 1e-9);
  for (std::size_t i = 1; i < 12; ++i) {
    EXPECT_NEAR(heights[12 - i], heights[12 + i], 1e-9) << i;
    const double share = static_cast<double>(i) / 24;
    EXPECT_NEAR(heights[i], 0.06 * std::pow(4 * share * (1 - share), 3), 1e-9) << i;
  }
}

TEST(FootPlants, AFootThatTheRecordingLiftsLeavesTheFloorBeforeItMoves) {
  FootPlants plants;
  double time_s = 0;
  for (; time_s < 0.5; time_s += step_s) plants.update(drifting(time_s, 0.1), step_s);
  const Vec3 stood = plants.feet()[0].shown;
  // High and fast in the recording at once, as after a change of source; what is free follows bit by bit.
  for (int step = 1; step <= 30; ++step) {
    auto feet = drifting(time_s, 0.1);
    feet[0].lands = false;
    feet[0].lands_in_s = 0.4;
    feet[0].recorded_height = rest_height + 0.15;
    feet[0].free += Vec3(1.5 * step * step_s, 0.2 * step * step_s, 0);
    const auto shown = plants.update(feet, step_s);
    const double moved_m = std::hypot(shown[0].x() - stood.x(), shown[0].z() - stood.z());
    if (shown[0].y() < rest_height + 0.02) {
      EXPECT_LT(moved_m, 1e-6) << step;
    }
    if (step == 30) {
      EXPECT_GT(moved_m, 0.3) << "it goes where it should all the same";
    }
  }
}

TEST(FootPlants, AFootThatLeavesTheFloorIsNotJerkedUp) {
  FootPlants plants;
  for (int step = 0; step < 60; ++step) plants.update(drifting(0, 0), step == 0 ? 0 : step_s);
  const double stood_m = plants.feet()[0].shown.y();
  auto feet = drifting(0, 0);
  feet[0].lands = false;
  feet[0].lands_in_s = 0.4;
  feet[0].recorded_height = rest_height + 0.15;
  const double risen_m = plants.update(feet, step_s)[0].y() - stood_m;
  ASSERT_TRUE(plants.feet()[0].planted);
  // A critically damped spring of 24/s: 1 - (1 + w t) exp(-w t) of the way to 6 cm over rest.
  const double way_m = rest_height + 0.06 - stood_m, passed = 24 * step_s;
  EXPECT_NEAR(risen_m, way_m * (1 - (1 + passed) * std::exp(-passed)), 1e-4);
}

TEST(FootPlants, AFootInTheAirMakesForWhereTheBodyGoes) {
  // The body is drawn 20 cm to the side; the left foot has been lifted and lands again, the right one stands.
  const auto shown_after = [](double body_goes_m) {
    FootPlants plants;
    std::array<Vec3, 2> shown;
    for (int step = 0; step < 90; ++step) {
      auto feet = drifting(0, 0);
      for (FootMoment& foot : feet) foot.body_goes = Vec3(step < 20 ? 0 : body_goes_m, 0, 0);
      if (step >= 20 && step < 50) {
        feet[0].lands = false;
        feet[0].lands_in_s = (50 - step) * step_s;
        feet[0].free.y() += 0.1;
        feet[0].recorded_height += 0.1;
      }
      shown = plants.update(feet, step == 0 ? 0 : step_s);
    }
    EXPECT_TRUE(plants.feet()[0].planted && plants.feet()[1].planted);
    return shown;
  };
  const auto here = shown_after(0), led = shown_after(0.2);
  EXPECT_NEAR(led[0].x() - here[0].x(), 0.4 * 0.2, 0.01) << "four tenths of the way, and stays there";
  EXPECT_NEAR(led[0].z(), here[0].z(), 1e-9);
  EXPECT_LT((led[1] - here[1]).norm(), 1e-9) << "the standing foot";
}

TEST(FootPlants, AFootThatWasLetGoForAnotherReasonStandsOnlyAfterItWasLifted) {
  FootPlants plants;
  for (int step = 0; step < 10; ++step) plants.update(drifting(0, 0), step == 0 ? 0 : step_s);
  ASSERT_TRUE(plants.feet()[0].planted);
  plants.let_go(0, plants.feet()[0].shown);
  for (int step = 0; step < 60; ++step) {
    plants.update(drifting(0, 0), step_s);
    EXPECT_FALSE(plants.feet()[0].planted) << step;
    EXPECT_TRUE(plants.feet()[1].planted) << step;
  }
  for (int step = 0; step < 20; ++step) {
    auto feet = drifting(0, 0);
    feet[0].lands = false;
    plants.update(feet, step_s);
  }
  plants.update(drifting(0, 0), step_s);
  EXPECT_TRUE(plants.feet()[0].planted);
}

TEST(FootPlants, AFootOfABentLegIsLeftBehindByAQuarterOfAMetreAtMost) {
  FootPlants plants;
  bool stepped = false;
  for (int step = 0; step < 300; ++step) {
    auto feet = drifting(step * step_s, 0.3);
    for (FootMoment& foot : feet) foot.hip.y() = 0.6;  // so that the leg would reach 0.7 m
    plants.update(feet, step == 0 ? 0 : step_s);
    for (std::size_t f = 0; f < 2; ++f) {
      const FootPlants::Foot& foot = plants.feet()[f];
      stepped |= foot.steps;
      // The other foot has to wait for a step of 0.4 s.
      if (foot.planted) {
        EXPECT_LT(std::abs(foot.anchor.x() - feet[f].free.x()), 0.25 + 0.4 * 0.3 + 0.02) << step;
      }
    }
  }
  EXPECT_TRUE(stepped);
}

TEST(FootPlants, AFootThatLandsSlidingComesToRestWithinATenthOfASecond) {
  FootPlants plants;
  constexpr double speed = 1.5;
  double time_s = 0;
  for (; time_s < 0.5; time_s += step_s) {
    auto feet = drifting(time_s, speed);
    feet[0].lands = false;
    plants.update(feet, step_s);
  }
  const auto feet = drifting(time_s, speed);
  const double landed = plants.update(feet, step_s)[0].x();
  ASSERT_TRUE(plants.feet()[0].planted);
  std::array<double, 30> at{};
  for (double& x : at) x = plants.update(feet, step_s)[0].x();
  EXPECT_NEAR(at.back() - landed, 0.03 * speed, 0.005) << "its speed dies within 0.03 s";
  EXPECT_LT(at.back() - at[6], 1e-3);
}

TEST(FootPlants, AFootThatIsTakenFarAwayOnTheFloorIsLetGoAtOnce) {
  FootPlants plants;
  for (int step = 0; step < 10; ++step) plants.update(drifting(0, 0), step == 0 ? 0 : step_s);
  ASSERT_TRUE(plants.feet()[0].planted);
  for (const double away_m : {0.1, 0.2}) {
    auto feet = drifting(0, 0);
    feet[0].lands = false;
    feet[0].free += Vec3(away_m, -0.02, 0);
    feet[0].recorded_height = rest_height;
    plants.update(feet, step_s);
    EXPECT_EQ(plants.feet()[0].planted, away_m < 0.15) << away_m;
  }
}

TEST(FootPlants, AFootThatRushesIsNotStoppedDead) {
  for (const double speed : {2.0, 4.0}) {
    FootPlants plants;
    double time_s = 0;
    for (; time_s < 0.5; time_s += step_s) {
      auto feet = drifting(time_s, speed);
      for (FootMoment& foot : feet) foot.lands = false;
      plants.update(feet, step_s);
    }
    plants.update(drifting(time_s, speed), step_s);
    EXPECT_EQ(plants.feet()[0].planted, speed < 3) << speed;
  }
}

TEST(FootPlants, ABentLegThatNothingHoldsIsLeftAsItIs) {
  Pose pose = test::standing_pose();
  pose.row(joints::left_hip + 1) += Eigen::RowVector3d(0, 0, 0.1);
  const Pose before = pose;
  place_foot(pose, body_of(pose), true, before.row(joints::left_toe_base), Vec3::UnitX());
  EXPECT_LT((pose - before).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(FootPlants, WhatIsShownNeverJumps) {
  FootPlants plants;
  std::array<Vec3, 2> before{};
  for (int step = 0; step < 400; ++step) {
    auto feet = drifting(step * step_s, 0.3);
    for (FootMoment& foot : feet) {
      foot.lands = step % 60 < 40;
      foot.lands_in_s = 0.3;
      foot.body_goes = Vec3(0, 0, step % 50 < 25 ? 0.2 : -0.2);
    }
    const auto shown = plants.update(feet, step == 0 ? 0 : step_s);
    for (std::size_t f = 0; step > 0 && f < 2; ++f) EXPECT_LT((shown[f] - before[f]).norm(), 0.06) << step;
    before = shown;
  }
}

TEST(FootPlants, ALegReachesWhereItCanAndKeepsItsBones) {
  const Pose standing = test::standing_pose();
  const Body body = body_of(standing);
  for (const Vec3& off : {Vec3(0.1, 0, 0), Vec3(0, 0, 0.4), Vec3(0.9, 0, 0)}) {
    Pose pose = standing;
    place_foot(pose, body, true, Vec3(standing.row(joints::left_toe_base)) + off, Vec3::UnitZ());
    EXPECT_LT(largest_length_difference(body_of(pose), body), 1e-6);
  }
}

TEST(FootPlants, ALegStretchesSoftlyUpToAlmostItsLength) {
  Pose standing = test::standing_pose();
  const int hip = joints::left_hip, ankle = hip + 2;
  standing.row(hip) -= Eigen::RowVector3d(0, 0.05, 0);  // so that the knee is bent
  const Body body = body_of(test::standing_pose());
  const double whole_m =
      body.bone_lengths[static_cast<std::size_t>(hip)] + body.bone_lengths[static_cast<std::size_t>(hip + 1)];
  const auto reach = [&](double away_m) {
    Pose pose = standing;
    place_foot(pose, body, true, Vec3(standing.row(joints::left_toe_base)) + Vec3(away_m, 0, 0),
               Vec3::UnitZ());
    return (pose.row(ankle) - pose.row(hip)).norm();
  };
  const double free_m = reach(0), room_m = 0.985 * whole_m - free_m;
  ASSERT_GT(room_m, 0.01);
  double before_m = free_m;
  for (const double away_m : {0.05, 0.1, 0.15, 0.2, 0.25}) {
    const Vec3 asked = Vec3(standing.row(ankle)) + Vec3(away_m, 0, 0) - Vec3(standing.row(hip));
    const double beyond_m = asked.norm() - free_m;
    EXPECT_NEAR(reach(away_m), free_m + room_m * (1 - std::exp(-beyond_m / room_m)), 1e-6) << away_m;
    EXPECT_GT(reach(away_m), before_m);
    before_m = reach(away_m);
  }
}

TEST(FootPlants, AFootThatIsLowAndSlowStandsInTheRecording) {
  PairedTake take = test::swinging_take("stands", 60, 1);
  for (Pose& pose : take.b.poses) pose = test::moved(test::standing_pose(), 3, Vec3(0, 0, 0.7));
  for (std::size_t frame = 30; frame < 60; ++frame)
    take.b.poses[frame].row(joints::left_toe_base) += Eigen::RowVector3d(0, 0.2, 0);
  std::vector<PairedTake> takes;
  takes.push_back(std::move(take));
  const MotionLibrary library = std::move(*build_library("stands", std::move(takes), {}, {}));
  EXPECT_TRUE(stands_in_recording(library, {10, 0, 1}, true));
  EXPECT_TRUE(stands_in_recording(library, {45, 0, 1}, false));
  EXPECT_FALSE(stands_in_recording(library, {45, 0, 1}, true));
  const int last = library.pair_count() - 1;
  EXPECT_TRUE(stands_in_recording(library, {0, 0, 1}, true)) << "where a take begins";
  EXPECT_TRUE(stands_in_recording(library, {last, 0, 1}, false)) << "where it ends";
  EXPECT_FALSE(stands_in_recording(library, {last, 0, 1}, true));
}

}  // namespace
}  // namespace abrazo::foot_plants_test
