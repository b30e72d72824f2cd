#include "core/metrics/holds.hpp"

#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::holds_test {
namespace {

/// Hands on the x axis [m]; everything else far away.
struct Hands {
  double active_left, active_right, passive_left, passive_right;
};

PairPose pair_with(const Hands& hands) {
  PairPose pair = test::facing_pair(3);
  pair.row(joints::left_hand) << hands.active_left, 1, 1;
  pair.row(joints::right_hand) << hands.active_right, 1, 1;
  pair.row(joints::left_hand + joint_count) << hands.passive_left, 1, 1;
  pair.row(joints::right_hand + joint_count) << hands.passive_right, 1, 1;
  return pair;
}

TEST(Holds, ChangeByHowMuchTheHandsCameApartOrTogether) {
  HoldMetric metric;
  metric.add(pair_with({0, 1, 0.14, 0.92}), pair_with({0, 1, 0.10, 1.12}));
  EXPECT_EQ(metric.figures().holds, 2);
  EXPECT_NEAR(metric.figures().change_mean_m, 0.5 * (0.04 + 0.04), 1e-12) << "10 to 14 cm, 12 to 8 cm";
}

TEST(Holds, AreLostBeyond16Centimetres) {
  HoldMetric metric;
  metric.add(pair_with({0, 1, 0.14, 1.20}), pair_with({0, 1, 0.10, 1.12}));  // kept, lost
  metric.add(pair_with({0, 1, 0.11, 5}), pair_with({0, 1, 0.10, 5}));        // kept
  metric.add(pair_with({0, 1, 5, 1.05}), pair_with({0, 1, 5, 1.50}));        // shown, not recorded
  const HoldMetric::Figures figures = metric.figures();
  EXPECT_EQ(figures.holds, 3);
  EXPECT_EQ(figures.shown_holds, 2) << "14 cm is kept but would not count as a hold itself";
  EXPECT_NEAR(figures.change_mean_m, (0.04 + 0.08 + 0.01) / 3, 1e-12);
  EXPECT_NEAR(figures.kept, 2.0 / 3, 1e-12);
  EXPECT_NEAR(figures.precision, 1.0 / 2, 1e-12);
  EXPECT_NEAR(figures.f1, 4.0 / 7, 1e-12);
}

TEST(Holds, AShownHoldIsRightWhereTheRecordedHandsAreWithin16Centimetres) {
  HoldMetric metric;
  metric.add(pair_with({0, 1, 0.12, 5}), pair_with({0, 1, 0.15, 5}));
  EXPECT_EQ(metric.figures().holds, 0);
  EXPECT_EQ(metric.figures().precision, 1);
  metric.add(pair_with({0, 1, 0.12, 5}), pair_with({0, 1, 0.17, 5}));
  EXPECT_EQ(metric.figures().precision, 0.5);
}

TEST(Holds, OfTheCaptureAreHeldWithin20CentimetresAndRecalledWithin13) {
  HoldMetric metric(HoldMetric::captured_hold_held_m);
  metric.add(pair_with({0, 1, 0.12, 5}), pair_with({0, 1, 0.10, 5}));  // held and recalled
  metric.add(pair_with({0, 1, 0.19, 5}), pair_with({0, 1, 0.10, 5}));  // held
  metric.add(pair_with({0, 1, 0.21, 5}), pair_with({0, 1, 0.10, 5}));  // lost
  metric.add(pair_with({0, 1, 0.12, 5}), pair_with({0, 1, 0.25, 5}));  // nobody held
  const HoldMetric::Figures figures = metric.figures();
  EXPECT_EQ(figures.holds, 3);
  EXPECT_NEAR(figures.kept, 2.0 / 3, 1e-12);
  EXPECT_NEAR(figures.recall, 1.0 / 3, 1e-12);
  EXPECT_NEAR(figures.distance_mean_m, (0.12 + 0.19 + 0.21) / 3, 1e-12);
  EXPECT_NEAR(figures.precision, 1.0 / 2, 1e-12);
}

TEST(Holds, EveryHandMayHoldEitherHand) {
  HoldMetric metric;
  const PairPose crossed = pair_with({0, 1, 0.95, 0.05});
  metric.add(crossed, crossed);
  const PairPose all_four = pair_with({0, 0.02, 0.04, 0.06});
  metric.add(all_four, all_four);
  EXPECT_EQ(metric.figures().holds, 2 + 4);
  EXPECT_EQ(metric.figures().f1, 1);
}

TEST(Holds, NineteenOfTwentyChangeLessThanTheNinetyFifthPercentile) {
  HoldMetric metric;
  for (int change_cm = 0; change_cm <= 20; ++change_cm)
    metric.add(pair_with({0, 1, 0.10 + 0.01 * change_cm, 5}), pair_with({0, 1, 0.10, 5}));
  EXPECT_NEAR(metric.figures().change_p95_m, 0.19, 1e-12);
}

TEST(Holds, OfNobodyAreNone) {
  const HoldMetric::Figures figures = HoldMetric().figures();
  EXPECT_EQ(figures.holds, 0);
  EXPECT_EQ(figures.change_mean_m, 0);
  EXPECT_EQ(figures.f1, 0);
}

}  // namespace
}  // namespace abrazo::holds_test
