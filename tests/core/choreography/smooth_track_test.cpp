#include "core/choreography/smooth_track.hpp"

#include <gtest/gtest.h>

namespace abrazo::smooth_track_test {
namespace {

TEST(SmoothTrack, FollowsAStraightLineExactly) {
  const SmoothTrack<double> track(2.0, 0.5, {1, 2, 3, 4, 5, 6, 7});
  for (double time = 2.5; time <= 4.5; time += 0.1)
    EXPECT_NEAR(track.at(time), 1 + (time - 2.0) / 0.5, 1e-12);
}

TEST(SmoothTrack, HoldsItsEndValuesOutside) {
  const SmoothTrack<double> track(0, 1, {3, -1, 8});
  EXPECT_NEAR(track.at(-50), 3, 1e-12);
  EXPECT_NEAR(track.at(50), 8, 1e-12);
}

TEST(SmoothTrack, StaysWithinItsControlsAtAStep) {
  const SmoothTrack<double> track(0, 1, {0, 0, 0, 0, 1, 1, 1, 1});
  double before = 0;
  for (double time = 0; time < 7; time += 0.01) {
    EXPECT_GE(track.at(time), before - 1e-12);
    EXPECT_LE(track.at(time), 1 + 1e-12);
    before = track.at(time);
  }
}

TEST(SmoothTrack, VelocityAndAccelerationAreContinuousAtTheControls) {
  const SmoothTrack<double> track(0, 1, {0, 3, -2, 5, 1, 1, 4});
  const double h = 1e-4;  // third derivative below 30: differences agree to 30 h
  for (int knot = 1; knot < 6; ++knot) {
    const auto slope = [&](double t) { return (track.at(t + h) - track.at(t)) / h; };
    const auto bend = [&](double t) {
      return (track.at(t + h) - 2 * track.at(t) + track.at(t - h)) / (h * h);
    };
    EXPECT_NEAR(slope(knot), slope(knot - h), 30 * h);
    EXPECT_NEAR(bend(knot - 2 * h), bend(knot + 2 * h), 150 * h);
  }
}

TEST(SmoothTrack, MinimumJerkStartsAndEndsAtRest) {
  EXPECT_EQ(minimum_jerk(-1), 0);
  EXPECT_EQ(minimum_jerk(2), 1);
  EXPECT_NEAR(minimum_jerk(0.5), 0.5, 1e-15);
  EXPECT_LT(minimum_jerk(1e-3), 1.1e-8);  // 10 u^3: no velocity, no acceleration
  EXPECT_LT(1 - minimum_jerk(1 - 1e-3), 1.1e-8);
}

TEST(SmoothTrack, BumpIsOneInTheMiddleAndNothingOutside) {
  EXPECT_EQ(smooth_bump(0), 0);
  EXPECT_EQ(smooth_bump(1.5), 0);
  EXPECT_NEAR(smooth_bump(0.5), 1, 1e-15);
}

}  // namespace
}  // namespace abrazo::smooth_track_test
