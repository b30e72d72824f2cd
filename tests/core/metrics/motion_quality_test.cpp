#include "core/metrics/motion_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::motion_quality_test {
namespace {

constexpr ToeRest rest = {0.04, 0.05};
constexpr double step_s = 1.0 / 60;

/// A partner of whom every step can be given another source and place.
struct Partner {
  MotionQuality quality{rest};
  PartnerStep step = {.partner = test::standing_pose(), .source = {.take = 2, .time_s = 4}};

  /// @param advance_s  of the source
  void continues(double advance_s, double moved_m = 0) {
    step.source.time_s += advance_s;
    step.time_s += step_s;
    step.partner.col(0).array() += moved_m;
    quality.add(step);
  }
};

TEST(MotionQuality, PaceIsTheTimeInTheTakeByTheTimeThatPassed) {
  Partner partner;
  partner.continues(0);
  for (int i = 0; i < 60; ++i) partner.continues(i < 30 ? step_s : i < 45 ? 0 : 2 * step_s);
  const auto f = partner.quality.figures();
  EXPECT_NEAR(f.pace_p50, 1, 1e-9);
  EXPECT_NEAR(f.pace_p05, 0, 1e-9);
  EXPECT_NEAR(f.pace_p95, 2, 1e-9);
  EXPECT_NEAR(f.standing_share, 0.25, 1e-12);
  EXPECT_NEAR(f.source_pace_share, 0.5, 1e-12);
  EXPECT_EQ(f.changes_per_s, 0);
  EXPECT_TRUE(std::isnan(f.step_at_change_max_m)) << "there was no change";
}

TEST(MotionQuality, AnotherTakeOrRoleAStepBackAndALeapAheadAreChanges) {
  const auto changes = [](const auto& change) {
    Partner partner;
    for (int i = 0; i < 31; ++i) partner.continues(step_s);
    change(partner.step);
    for (int i = 0; i < 30; ++i) partner.continues(step_s);
    return partner.quality.figures().changes_per_s;  // in one second
  };
  EXPECT_NEAR(changes([](PartnerStep& step) { step.source.take = 3; }), 1, 1e-9);
  EXPECT_NEAR(changes([](PartnerStep& step) { step.source.swapped = true; }), 1, 1e-9);
  EXPECT_NEAR(changes([](PartnerStep& step) { step.source.time_s -= 2 * step_s; }), 1, 1e-9);
  EXPECT_NEAR(changes([](PartnerStep& step) { step.source.time_s += 20 * step_s; }), 1, 1e-9);
  EXPECT_EQ(changes([](PartnerStep& step) { step.source.time_s += 19 * step_s; }), 0);
  EXPECT_EQ(changes([](PartnerStep&) {}), 0);
}

TEST(MotionQuality, AChangeThatTheStepSpeaksOfIsOneAndHasNoPace) {
  Partner partner;
  partner.continues(step_s);
  partner.step.source_changed = true;
  partner.continues(3 * step_s);
  const auto f = partner.quality.figures();
  EXPECT_NEAR(f.changes_per_s, 60, 1e-9);
  EXPECT_TRUE(std::isnan(f.pace_p50));
}

TEST(MotionQuality, WhatItsOwnVelocityExplainsIsNoStepAtAChange) {
  Partner partner;
  for (int i = 0; i < 10; ++i) partner.continues(step_s, 0.02);
  partner.continues(step_s, 0.20);  // not at a change
  partner.continues(step_s, 0.02);
  partner.continues(step_s, 0.02);
  partner.continues(5, 0.02);
  EXPECT_NEAR(partner.quality.figures().step_at_change_max_m, 0, 1e-9);
  partner.continues(5, 0.07);
  EXPECT_NEAR(partner.quality.figures().step_at_change_max_m, 0.05, 1e-9);
}

TEST(MotionQuality, LockedToeBasesHoverAboveTheirOwnRest) {
  Partner partner;
  partner.step.partner(joints::left_toe_base, 1) = 0.06;
  partner.step.partner(joints::right_toe_base, 1) = 0.06;
  partner.continues(step_s);
  EXPECT_TRUE(std::isnan(partner.quality.figures().hover_p90_m)) << "neither is locked";
  partner.step.locked = {true, false};
  partner.continues(step_s);
  partner.step.locked = {false, true};
  partner.continues(step_s);
  const auto f = partner.quality.figures();
  EXPECT_NEAR(f.hover_mean_m, 0.015, 1e-12);
  EXPECT_NEAR(f.hover_p90_m, 0.019, 1e-12);
}

TEST(MotionQuality, AnInterruptionIsNoChangeAndNoTime) {
  Partner partner;
  for (int i = 0; i < 31; ++i) partner.continues(step_s);
  partner.quality.interrupt();
  partner.step.time_s += 100;
  partner.step.source.take = 7;
  partner.continues(0);
  for (int i = 0; i < 30; ++i) partner.continues(5);
  EXPECT_NEAR(partner.quality.figures().changes_per_s, 30, 1e-9) << "in the second half of one second";
}

TEST(PartnerStep, OfAFrameIsItsPartnerItsSourceAndItsLocks) {
  const auto library = test::small_library();
  FrameResult frame;
  frame.result = library->pose(10);
  frame.candidates.resize(3);
  frame.candidates[2].pair = library->find_pair("second", 30, false);
  frame.selected = 2;
  frame.source_changed = true;
  frame.foot_locks = {{.active_body = true, .left = true}, {.active_body = false, .left = false}};
  const PartnerStep step = partner_step(frame, 7, *library, false);
  EXPECT_EQ(step.partner, Pose(frame.passive()));
  EXPECT_EQ(step.time_s, 7);
  EXPECT_EQ(step.source.take, library->find_take("second"));
  EXPECT_NEAR(step.source.time_s, 0.5, 1e-12);
  EXPECT_TRUE(step.source_changed);
  EXPECT_EQ(step.locked, (std::array{false, true}));
  const PartnerStep leader = partner_step(frame, 7, *library, true);
  EXPECT_EQ(leader.partner, Pose(frame.active()));
  EXPECT_EQ(leader.locked, (std::array{true, false}));
}

}  // namespace
}  // namespace abrazo::motion_quality_test
