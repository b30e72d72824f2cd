#include "core/metrics/run_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/metrics/run_summary.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::run_comparison_test {
namespace {

const std::shared_ptr<const MotionLibrary>& library() {
  static const auto small = test::small_library();
  return small;
}

/// A solved step whose partner stands `behind_m` beside the selected pair's.
FrameResult step_with(double behind_m) {
  FrameResult result;
  result.status = StepStatus::Ok;
  result.result = library()->pose(10);
  result.selected_pair = result.result;
  result.result.bottomRows<joint_count>().col(0).array() += behind_m;
  result.energy.deformation = 0.5;
  result.timing.total_us = 400;
  return result;
}

double at(const RunFigures& values, RunFigure figure) {
  return values[static_cast<std::size_t>(figure)];
}

class Steps {
 public:
  explicit Steps(std::vector<FrameResult> results, double rate_hz = 60) : results_(std::move(results)) {
    for (std::size_t i = 0; i < results_.size(); ++i)
      steps_.push_back({&results_[i], static_cast<double>(i) / rate_hz, i == 0});
  }
  std::vector<RunStep>& all() { return steps_; }
  RunFigures measured(UserRole role = UserRole::Active) const {
    return measure_run(steps_, *library(), role);
  }

 private:
  std::vector<FrameResult> results_;
  std::vector<RunStep> steps_;
};

TEST(RunComparison, TheLagIsHowFarThePartnerIsFromTheSelectedPair) {
  const Steps steps({step_with(0.02), step_with(0.02), step_with(0.05), step_with(0.05)});
  EXPECT_NEAR(at(steps.measured(), RunFigure::BehindSelected), 0.035, 1e-12);
  EXPECT_NEAR(at(steps.measured(), RunFigure::DeformationEnergy), 0.5, 1e-12);
  EXPECT_NEAR(at(steps.measured(), RunFigure::StepTime), 400e-6, 1e-12);
}

TEST(RunComparison, ThePartnerOfAPassiveUserIsTheActiveBody) {
  const Steps steps({step_with(0.02), step_with(0.02)});
  EXPECT_EQ(at(steps.measured(UserRole::Passive), RunFigure::BehindSelected), 0);
}

TEST(RunComparison, APartnerThatGlidesOverTheFloorSlides) {
  std::vector<FrameResult> results;
  for (int i = 0; i < 30; ++i) results.push_back(step_with(0.01 * i));
  const Steps steps(results);  // 1 cm a step at 60 Hz
  EXPECT_NEAR(at(steps.measured(), RunFigure::FootSlide), 0.6, 1e-6);
  EXPECT_NEAR(at(Steps(results, 30).measured(), RunFigure::FootSlide), 0.3, 1e-6);
}

TEST(RunComparison, AFreshStartIsNotASlide) {
  std::vector<FrameResult> results;
  for (int i = 0; i < 20; ++i) results.push_back(step_with(i < 10 ? 0 : 0.5));
  Steps steps(results);
  const double with_jump = at(steps.measured(), RunFigure::FootSlide);
  steps.all()[10].starts = true;
  EXPECT_GT(with_jump, 0.1);
  EXPECT_NEAR(at(steps.measured(), RunFigure::FootSlide), 0, 1e-9);
}

TEST(RunComparison, WhatCannotBeMeasuredIsNotANumber) {
  FrameResult failed = step_with(0);
  failed.status = StepStatus::Failed;
  const RunFigures values = Steps({failed, failed}).measured();
  EXPECT_TRUE(std::isnan(at(values, RunFigure::BehindSelected)));
  EXPECT_TRUE(std::isnan(at(values, RunFigure::ZmpError)));
  EXPECT_EQ(at(values, RunFigure::Unmet), 100);
  for (const double value : measure_run({}, *library(), UserRole::Active)) EXPECT_TRUE(std::isnan(value));
}

TEST(RunComparison, StepsAreComparedOneByOne) {
  Steps a({step_with(0), step_with(0.01)}), b({step_with(0.03), step_with(0.01)});
  const auto compared = compare_steps(a.all(), UserRole::Active, b.all(), UserRole::Active);
  const auto of = [](StepFigure figure) { return static_cast<std::size_t>(figure); };
  ASSERT_EQ(compared.size(), 2U);
  EXPECT_NEAR(compared[0].b[of(StepFigure::PartnerDistance)], 0.03, 1e-12);
  EXPECT_NEAR(compared[1].b[of(StepFigure::PartnerDistance)], 0, 1e-12);
  EXPECT_NEAR(compared[0].b[of(StepFigure::BehindSelected)], 0.03, 1e-12);
  EXPECT_NEAR(compared[1].a[of(StepFigure::BehindSelected)], 0.01, 1e-12);
  EXPECT_DOUBLE_EQ(compared[1].time_s, 1.0 / 60);
}

TEST(RunComparison, PartnersOfDifferentRolesHaveNoDistance) {
  Steps a({step_with(0)}), b({step_with(0)});
  const auto compared = compare_steps(a.all(), UserRole::Active, b.all(), UserRole::Passive);
  EXPECT_TRUE(std::isnan(compared[0].b[static_cast<std::size_t>(StepFigure::PartnerDistance)]));
}

TEST(RunComparison, RunsOfOtherStepsAreRefused) {
  Steps a({step_with(0)}), b({step_with(0), step_with(0)});
  EXPECT_THROW(compare_steps(a.all(), UserRole::Active, b.all(), UserRole::Active), std::invalid_argument);
}

TEST(RunComparison, EveryFigureHasANameAUnitAndAnExplanation) {
  for (std::size_t i = 0; i < run_figure_count; ++i) {
    const RunFigureInfo& info = info_of(static_cast<RunFigure>(i));
    EXPECT_FALSE(info.name.empty() || info.unit.empty() || info.help.empty()) << i;
  }
  for (std::size_t i = 0; i < step_figure_count; ++i)
    EXPECT_FALSE(info_of(static_cast<StepFigure>(i)).name.empty()) << i;
}

}  // namespace
}  // namespace abrazo::run_comparison_test
