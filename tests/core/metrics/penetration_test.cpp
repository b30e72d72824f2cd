#include "core/metrics/penetration.hpp"

#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::penetration_test {
namespace {

/// Capsules of 13 cm around heads, nothing else.
CapsuleRadii heads() {
  CapsuleRadii radii{};
  radii[joints::Head - 1] = 0.13;
  return radii;
}

/// Head ends are 1 cm in front of either body, so 2 cm nearer than the bodies; `depth_m` of overlap.
PairPose heads_overlapping_by(double depth_m) {
  return test::facing_pair(0.02 + 0.26 - depth_m);
}

/// The passive left hand's end at `apart_m` from the active left hand's.
PairPose hands_apart(double apart_m) {
  PairPose pair = test::facing_pair(2);
  pair.row(joints::left_hand + joint_count) = pair.row(joints::left_hand) + Vec3(apart_m, 0, 0).transpose();
  pair.row(joints::left_wrist + joint_count) = pair.row(joints::left_hand + joint_count);
  return pair;
}

CapsuleRadii hands() {
  CapsuleRadii radii{};
  radii[joints::left_hand - 1] = 0.10;
  return radii;
}

/// Figures of one frame.
PenetrationMetric::Figures figures_of(const PairPose& pair, const PairPose& selected,
                                      const CapsuleRadii& active, const CapsuleRadii& passive) {
  PenetrationMetric metric;
  metric.add(pair, selected, active, passive);
  return metric.figures();
}

TEST(Penetration, IsTheDepthOfTwoCapsulesInOneAnother) {
  const PairPose pair = heads_overlapping_by(0.03);
  EXPECT_NEAR(figures_of(pair, pair, heads(), heads()).max_m, 0.03, 1e-9);
  EXPECT_NEAR(figures_of(heads_overlapping_by(-0.01), pair, heads(), heads()).max_m, 0, 1e-9);
}

TEST(Penetration, ExcessIsWhatTheRecordingDoesNotHave) {
  const PairPose recorded = heads_overlapping_by(0.02);
  EXPECT_NEAR(figures_of(heads_overlapping_by(0.03), recorded, heads(), heads()).excess_max_m, 0.01, 1e-9);
  EXPECT_NEAR(figures_of(heads_overlapping_by(0.015), recorded, heads(), heads()).excess_max_m, 0, 1e-9);
  EXPECT_NEAR(
      figures_of(heads_overlapping_by(0.03), heads_overlapping_by(-0.1), heads(), heads()).excess_max_m, 0.03,
      1e-9)
      << "room in the recording is no debt";
}

TEST(Penetration, OfHandsThatHoldOneAnotherIsNone) {
  EXPECT_NEAR(figures_of(hands_apart(0.12), hands_apart(0.12), hands(), hands()).max_m, 0, 1e-9);
  EXPECT_NEAR(figures_of(hands_apart(0.14), hands_apart(0.14), hands(), hands()).max_m, 0.06, 1e-9);
  EXPECT_NEAR(figures_of(hands_apart(0.14), hands_apart(0.12), hands(), hands()).max_m, 0, 1e-9)
      << "the reference decides who holds";
}

TEST(Penetration, RadiiBelongToTheirBody) {
  CapsuleRadii larger = heads();
  larger[joints::Head - 1] = 0.15;
  PairPose pair = heads_overlapping_by(0.03);
  EXPECT_NEAR(figures_of(pair, pair, larger, heads()).max_m, 0.05, 1e-9);
  EXPECT_EQ(figures_of(pair, pair, CapsuleRadii{}, heads()).max_m, 0);
}

TEST(Penetration, DoesNotChangeUnderATurnAndAShift) {
  const auto elsewhere = [](const PairPose& pair) {
    PairPose result;
    result.topRows<joint_count>() = test::moved(pair.topRows<joint_count>(), 0.7, {2, 0, -1});
    result.bottomRows<joint_count>() = test::moved(pair.bottomRows<joint_count>(), 0.7, {2, 0, -1});
    return result;
  };
  EXPECT_NEAR(figures_of(elsewhere(heads_overlapping_by(0.03)), elsewhere(heads_overlapping_by(0.02)),
                         heads(), heads())
                  .excess_max_m,
              0.01, 1e-9);
}

TEST(Penetration, OfARunIsTakenOverItsFrames) {
  PenetrationMetric metric;
  for (int frame = 0; frame < 98; ++frame)
    metric.add(heads_overlapping_by(0.005), heads_overlapping_by(0.005), heads(), heads());
  metric.add(heads_overlapping_by(0.03), heads_overlapping_by(0.02), heads(), heads());
  metric.add(heads_overlapping_by(0.05), heads_overlapping_by(0.05), heads(), heads());
  const PenetrationMetric::Figures figures = metric.figures();
  EXPECT_EQ(figures.frames, 100);
  EXPECT_NEAR(figures.deep_share, 0.02, 1e-12);
  EXPECT_NEAR(figures.mean_m, (98 * 0.005 + 0.03 + 0.05) / 100, 1e-9);
  EXPECT_NEAR(figures.p99_m, 0.03, 1e-9);
  EXPECT_NEAR(figures.max_m, 0.05, 1e-9);
  EXPECT_NEAR(figures.excess_p99_m, 0, 1e-9);
  EXPECT_NEAR(figures.excess_max_m, 0.01, 1e-9);
}

TEST(Penetration, MeasuredFramesCountLikeOthers) {
  PenetrationMetric metric;
  metric.add(0.04, 0.03);
  metric.add(heads_overlapping_by(0.02), heads_overlapping_by(0.02), heads(), heads());
  EXPECT_NEAR(metric.figures().mean_m, 0.03, 1e-9);
  EXPECT_NEAR(metric.figures().excess_max_m, 0.03, 1e-9);
}

TEST(Penetration, OfNothingIsNothing) {
  const PenetrationMetric::Figures figures = PenetrationMetric().figures();
  EXPECT_EQ(figures.frames, 0);
  EXPECT_EQ(figures.deep_share, 0);
  EXPECT_EQ(figures.max_m, 0);
}

}  // namespace
}  // namespace abrazo::penetration_test
