#include "core/metrics/run_summary.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::run_summary_test {
namespace {

/// The partner 3 cm behind the selected pair and `along_m` on its way; left hands 10 cm apart in the selected
/// pair.
FrameResult solved(double along_m, double excess_m = 0) {
  FrameResult frame;
  frame.status = StepStatus::Ok;
  frame.selected_pair = test::facing_pair(2);
  frame.selected_pair.row(joints::left_hand) =
      frame.selected_pair.row(joints::left_hand + joint_count) + Vec3(0, 0, -0.10).transpose();
  frame.selected_pair.col(0).array() += along_m;
  frame.result = frame.selected_pair;
  frame.result.bottomRows<joint_count>().col(2).array() += 0.03;
  frame.residual = {0.001 + along_m / 1000, 0.0001, 0.02 + excess_m, excess_m, 0.004};
  frame.timing.total_us = 100;
  return frame;
}

FrameResult failed() {
  FrameResult frame;
  frame.timing.total_us = 900;
  return frame;
}

class ARun : public testing::Test {
 protected:
  ARun() {
    FrameResult relaxed = solved(0.10, 0.004);
    relaxed.status = StepStatus::Relaxed;
    relaxed.source_changed = true;
    double time_s = 0;
    for (const FrameResult& frame : {solved(0), relaxed, failed(), solved(5), solved(5.05)})
      summary.add(frame, time_s += 0.1);
  }
  std::shared_ptr<const MotionLibrary> library = test::small_library();
  RunSummary summary{*library};
};

TEST_F(ARun, IsCountedAndTimed) {
  const RunSummary::Figures figures = summary.figures();
  EXPECT_EQ(figures.frames, 5U);
  EXPECT_EQ(figures.relaxed, 1U);
  EXPECT_EQ(figures.failed, 1U);
  EXPECT_EQ(figures.solve_us_p50, 100);
  EXPECT_EQ(RunSummary(*library).figures().frames, 0U);
}

TEST(RunSummary, ThePartnerOfAPassiveUserIsTheActiveBody) {
  const auto library = test::small_library();
  RunSummary summary(*library, UserRole::Passive);
  FrameResult frame = solved(0);
  summary.add(frame, 0);
  frame.result.topRows<joint_count>().col(0).array() += 0.05;
  summary.add(frame, 0.1);
  EXPECT_NEAR(summary.figures().behind_selected_mean_m, 0.025, 1e-12);
  EXPECT_NEAR(summary.figures().partner_displacement_mean_m, 0.05, 1e-12);
  EXPECT_NEAR(summary.figures().motion.movement.speed_p50_m_s, 0.5, 1e-12);
}

TEST_F(ARun, TakesItsFiguresFromSolvedFramesOnly) {
  const RunSummary::Figures figures = summary.figures();
  EXPECT_NEAR(figures.behind_selected_mean_m, 0.03, 1e-12);
  EXPECT_NEAR(figures.morph_rms_m, 0.004, 1e-12);
  EXPECT_NEAR(figures.bone_length_max, 0.00605, 1e-12);
  EXPECT_NEAR(figures.foot_lock_drift_max_m, 0.0001, 1e-12);
  EXPECT_EQ(figures.holds, 4U);
  EXPECT_NEAR(figures.hold_change_mean_m, 0.03, 1e-12);
  EXPECT_NEAR(figures.source_changes_per_100, 25, 1e-12);
  EXPECT_NEAR(summary.penetration().figures().excess_max_m, 0.004, 1e-12);
  EXPECT_NEAR(summary.penetration().figures().max_m, 0.024, 1e-12);
}

TEST_F(ARun, IsNotComparedAcrossAFailedStep) {
  EXPECT_NEAR(summary.figures().partner_displacement_mean_m, 0.5 * (0.10 + 0.05), 1e-12);
  EXPECT_EQ(summary.continuity().figures().steps, 4);
  EXPECT_NEAR(summary.figures().motion.movement.speed_p50_m_s, 0.5 * (1.0 + 0.5), 1e-12);
}

TEST_F(ARun, IsWrittenAsJson) {
  const auto json = nlohmann::json::parse(summary.json(15));
  EXPECT_EQ(json["pairs"], library->pair_count());
  EXPECT_EQ(json["steps"], 5);
  EXPECT_EQ(json["failed"], 1);
  EXPECT_NEAR(json["hold_change_mean_m"], 0.03, 1e-12);
  EXPECT_NEAR(json["partner_displacement_mean_m"], 0.075, 1e-12);
  EXPECT_EQ(json["solve_us"]["p50"], 100);
  const auto& movement = json["movement"];
  EXPECT_NEAR(movement["speed_p50_m_per_s"], 0.75, 1e-12);
  EXPECT_NEAR(movement["changes_per_s"], 5, 1e-9) << "one in two steps of a tenth of a second";
  EXPECT_TRUE(movement["hover_p90_m"].is_null()) << "no foot was locked";
  EXPECT_TRUE(movement["pace"].contains("p95"));
}

TEST_F(ARun, IsWrittenForPeople) {
  const std::string text = summary.text(15);
  EXPECT_NE(text.find("5 at 15 Hz, 1 relaxed, 1 failed"), std::string::npos) << text;
  EXPECT_NE(text.find("30.0 mm over 4 holds"), std::string::npos) << text;
  EXPECT_NE(text.find("3.0 cm"), std::string::npos) << text;
  EXPECT_NE(text.find("0.75 / 0.99 m/s"), std::string::npos) << text;
}

}  // namespace
}  // namespace abrazo::run_summary_test
