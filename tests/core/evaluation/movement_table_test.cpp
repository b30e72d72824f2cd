// How the partner moves, in a dance that is given by formulas. The expected figures were printed for the same
// dance by a program that was written apart from this one (another language, from traces), and are therefore
// a check of every definition.
#include "core/evaluation/tables/movement_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/evaluation/takes/take_synthesis.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/core/evaluation/evaluation_takes.hpp"

namespace abrazo::movement_table_test {
namespace {

constexpr int captured_frames = 400, first_frame = 30, steps = 300;

double sway(double k, double t) {
  return 0.3 * std::sin(0.5 * t + 1.7 * k) + 0.05 * std::sin(3.1 * t + 0.9 * k);
}

/// A follower whose feet lift and land, at t seconds.
Pose captured_partner(double t) {
  Pose pose;
  for (int j = 0; j < joint_count; ++j)
    pose.row(j) << 1 + 0.02 * j + sway(j, t), 0.9 + 0.03 * j + 0.5 * sway(j + 100, t), sway(j + 200, t);
  for (const int toe_base : {joints::left_toe_base, joints::right_toe_base})
    pose(toe_base, 1) = 0.05 + 0.08 * std::max(0.0, std::sin(5 * t + toe_base));
  return pose;
}

/// A leader whose hands come and go over the follower's.
Pose captured_user(double t) {
  Pose pose;
  for (int j = 0; j < joint_count; ++j)
    pose.row(j) << 0.02 * j + sway(j + 300, t), 0.9 + 0.03 * j + 0.5 * sway(j + 400, t), sway(j + 500, t);
  const Pose partner = captured_partner(t);
  int n = 0;
  for (const int hand : {joints::left_hand, joints::right_hand})
    pose.row(hand) =
        partner.row(hand) + Eigen::RowVector3d(0, 0.05 + 0.2 * std::abs(std::sin(0.8 * t + n++)), 0);
  return pose;
}

/// A partner who wavers and trembles about the captured one, and leaps every 50 frames.
Pose made_partner(int frame, double t) {
  Pose pose = captured_partner(t);
  for (int j = 0; j < joint_count; ++j)
    pose.row(j) += Eigen::RowVector3d(0.04 * sway(j + 600, 3 * t) + 0.15 * ((frame / 50) % 2),
                                      0.02 * sway(j + 700, 2 * t) + 0.004 * std::sin(37 * t + j),
                                      0.003 * std::sin(53 * t + j));
  return pose;
}

/// Two takes in turn, each for 50 frames, that now and then stand or go on by two frames.
SourceMoment source_at(int frame) {
  int at = 10 * (frame / 50);
  for (int k = 50 * (frame / 50); k < frame; ++k) at += k % 7 == 0 ? 0 : k % 11 == 0 ? 2 : 1;
  return {.take = (frame / 50) % 2, .time_s = at / 60.0};
}

struct Dance {
  PairedTake take;
  SynthesisedTake made;

  Dance(const std::string& name, double start_s) {
    take.name = name;
    take.fps = 60;
    for (int frame = 0; frame < captured_frames; ++frame) {
      take.a.poses.push_back(captured_user(frame / 60.0 + start_s));
      take.b.poses.push_back(captured_partner(frame / 60.0 + start_s));
    }
    made.take = &take;
    made.rate_hz = 60;
    for (int frame = first_frame; frame < first_frame + steps; ++frame) add(frame, start_s);
  }
  Dance(const Dance&) = delete;
  Dance& operator=(const Dance&) = delete;

 private:
  void add(int frame, double start_s) {
    const auto at = static_cast<std::size_t>(frame);
    PairPose pair;
    pair << take.a.poses[at], made_partner(frame, frame / 60.0 + start_s);
    pair.topRows<joint_count>().col(0).array() += 0.01;
    made.results.push_back(pair);
    pair.bottomRows<joint_count>() = take.b.poses[at];
    pair.bottomRows<joint_count>().col(2).array() += 0.03;
    made.selected.push_back(pair);
    made.frames.push_back(frame);
    made.follows.push_back(frame > first_frame);
    made.times_s.push_back(frame / 60.0);
    made.sources.push_back(source_at(frame));
    made.source_changed.push_back(frame == 222);
    made.locked_feet.push_back({frame % 2 == 0, false});
  }
};

const MovementTable& measured() {
  static const Dance one("01", 0), two("02", 2.5);
  static const MovementTable table = [] {
    const std::vector<SynthesisedTake> takes = {one.made, two.made};
    return measure_movement(takes);
  }();
  return table;
}

TEST(MovementTable, AgreesWithAProgramThatWasWrittenApart) {
  const MovementFigures& f = measured().all;
  const auto expect = [](double value, double printed) {
    EXPECT_NEAR(value, printed, 1e-7 * printed + 1e-9);
  };
  expect(f.partner_error_m, 0.079898767);
  expect(f.selected_error_m, 0.03);
  expect(f.changes_per_s, 1.404682274);
  expect(f.standing_share, 0.140410959);
  expect(f.source_pace_share, 0.784246575);
  expect(f.speed_p50_m_s, 0.263341069);
  expect(f.captured_speed_p50_m_s, 0.225414124);
  expect(f.speed_p99_m_s, 8.993039511);
  expect(f.captured_speed_p99_m_s, 0.232449457);
  expect(f.acceleration_rms_m_s2, 108.575363990);
  expect(f.captured_acceleration_rms_m_s2, 1.054478725);
  expect(f.acceleration_ratio, 102.966145134);
  expect(f.slide_m_s, 0.377816821);
  expect(f.captured_slide_m_s, 0.205151126);
  expect(f.slide_share_fast, 0.224584159);
  expect(f.captured_slide_share_fast, 0.012396694);
  expect(f.hold_change_m, 0.039465461703);
  expect(f.captured_holds_held, 0.971880570);
  const auto& takes = measured().per_take;
  expect((takes[0].largest_step_m + takes[1].largest_step_m) / 2, 0.150196620);
}

TEST(MovementTable, IsTheMeanOverTheTakesAndOfLargestStepsTheLargest) {
  const MovementTable& table = measured();
  ASSERT_EQ(table.takes, (std::vector<std::string>{"01", "02"}));
  const MovementFigures &one = table.per_take[0], &two = table.per_take[1];
  EXPECT_NEAR(table.all.speed_p99_m_s, (one.speed_p99_m_s + two.speed_p99_m_s) / 2, 1e-12);
  EXPECT_EQ(table.all.step_at_change_max_m, std::max(one.step_at_change_max_m, two.step_at_change_max_m));
  EXPECT_EQ(table.all.captured_largest_step_m,
            std::max(one.captured_largest_step_m, two.captured_largest_step_m));
  EXPECT_GT(table.all.step_at_change_max_m, 0.1) << "it leaps at changes";
  EXPECT_LT(table.all.step_at_change_max_m, 0.2);
}

TEST(MovementTable, ThePartnerIsLateByItsLag) {
  Dance dance("late", 0);
  for (int step = steps - 1; step >= 0; --step) {
    const auto frame = static_cast<std::size_t>(first_frame + step - 6);
    dance.made.results[static_cast<std::size_t>(step)].bottomRows<joint_count>() = dance.take.b.poses[frame];
  }
  const std::vector<SynthesisedTake> takes = {dance.made};
  EXPECT_NEAR(measure_movement(takes).all.lag_s, 0.1, 1e-3);
}

TEST(MovementTable, LockedFeetHoverAboveTheRestOfTheCapturedFoot) {
  // The made partner's left toe base is where the captured one's is, but for 2 cm of wavering.
  EXPECT_GT(measured().all.hover_mean_m, 0.01);
  EXPECT_LT(measured().all.hover_p90_m, 0.11);
}

TEST(MovementTable, CurvesAscendFromTheLeastToTheLargestOfAllTakes) {
  const MovementTable& table = measured();
  for (const Percentiles* curve :
       {&table.made.speed_m_s, &table.captured.speed_m_s, &table.made.acceleration_m_s2, &table.pace}) {
    ASSERT_EQ(curve->size(), 101U);
    EXPECT_TRUE(std::is_sorted(curve->begin(), curve->end()));
  }
  EXPECT_NEAR(table.made.speed_m_s.back() / 60, table.all.largest_step_m, 1e-9);
}

TEST(MovementTable, OfWhatWasNotMeasuredThereIsNoFigure) {
  Dance dance("far", 0);
  for (PairPose& pair : dance.made.results) pair.bottomRows<joint_count>().col(1).array() += 5;
  const std::vector<SynthesisedTake> takes = {dance.made};
  const MovementTable table = measure_movement(takes);
  EXPECT_TRUE(std::isnan(table.all.slide_m_s)) << "no foot is on the floor";
  EXPECT_TRUE(std::isnan(table.all.captured_hold_precision)) << "nobody holds anybody";
  EXPECT_EQ(table.all.captured_holds_held, 0);
  EXPECT_EQ(table.all.landed_share, 0);
  EXPECT_TRUE(table.made.slide_m_s.empty());
}

TEST(MovementTable, EveryRowHasAKeyOfItsOwn) {
  std::vector<std::string_view> keys;
  for (const MovementRow& row : movement_rows()) keys.push_back(row.key);
  std::sort(keys.begin(), keys.end());
  EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

}  // namespace
}  // namespace abrazo::movement_table_test
