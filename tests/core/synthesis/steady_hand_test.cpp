#include "core/synthesis/motion/steady_hand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace abrazo {
namespace {

constexpr double frame_s = 1.0 / 60;

TEST(SteadyHand, TheFirstPositionIsTaken) {
  SteadyHand hand;
  hand.follow({1, 2, 3}, frame_s);
  EXPECT_EQ(hand.at, Vec3(1, 2, 3));
}

TEST(SteadyHand, ADancersHandIsFollowedWithoutLag) {
  SteadyHand hand;
  double furthest = 0;
  for (int f = 0; f < 600; ++f) {
    // 1.5 Hz by 25 cm: up to 22 m/s^2.
    const double phase = 2 * std::acos(-1.0) * 1.5 * f * frame_s;
    const Vec3 real(0.25 * std::sin(phase), 1.2, 0.25 * std::cos(phase));
    hand.follow(real, frame_s);
    if (f > 10) furthest = std::max(furthest, (hand.at - real).norm());
  }
  EXPECT_LT(furthest, 1e-3);
}

TEST(SteadyHand, AHandThatJumpsToAndFroIsNearlyStill) {
  SteadyHand hand;
  double least = 1, most = -1;
  for (int f = 0; f < 120; ++f) {
    hand.follow({f % 2 == 0 ? 0.02 : -0.02, 1, 0}, frame_s);
    if (f < 20) continue;
    least = std::min(least, hand.at.x());
    most = std::max(most, hand.at.x());
  }
  EXPECT_LT(most - least, 0.010) << "of 40 mm";
  EXPECT_NEAR(0.5 * (most + least), 0, 0.005);
}

TEST(SteadyHand, OfAJumpToAndFroAQuarterIsFollowedAndMoreInLongerSteps) {
  for (const auto& [rate_hz, share] :
       {std::pair(240.0, 0.25), {60.0, 0.25}, {40.0, 0.625}, {30.0, 1.0}, {20.0, 1.0}}) {
    SteadyHand hand;
    const double step_s = 1 / rate_hz, jump_m = 10 * step_s * step_s;  // not bounded by acceleration
    hand.follow({0, 1, 0}, step_s);
    hand.follow({jump_m, 1, 0}, step_s);
    ASSERT_NEAR(hand.at.x(), jump_m, 1e-12);
    hand.follow({0, 1, 0}, step_s);
    // Half of the jump's speed would have gone on.
    EXPECT_NEAR(hand.at.x(), 1.5 * jump_m * (1 - share), 1e-12) << rate_hz;
  }
}

TEST(SteadyHand, AHandThatReallyWentElsewhereIsReached) {
  SteadyHand hand;
  hand.follow({0, 1, 0}, frame_s);
  for (int f = 0; f < 20; ++f) hand.follow({0.3, 1, 0}, frame_s);
  EXPECT_NEAR(hand.at.x(), 0.3, 0.01);
}

TEST(SteadyHand, AtALowRateAHandMayTurnRoundFromFrameToFrame) {
  SteadyHand hand;
  for (int f = 0; f < 40; ++f) {
    const Vec3 real(f % 2 == 0 ? 0.05 : -0.05, 1, 0);
    hand.follow(real, 1.0 / 15);
    EXPECT_NEAR((hand.at - real).norm(), 0, 1e-9);
  }
}

TEST(SteadyHand, WithoutTimeItBeginsAnew) {
  SteadyHand hand;
  hand.follow({0, 1, 0}, frame_s);
  hand.follow({5, 1, 0}, 0);
  EXPECT_EQ(hand.at, Vec3(5, 1, 0));
  EXPECT_EQ(hand.speed, Vec3(0, 0, 0));
}

}  // namespace
}  // namespace abrazo
