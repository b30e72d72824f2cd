#include "core/metrics/continuity.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies.hpp"

namespace abrazo::continuity_test {
namespace {

Pose at(double x) {
  return test::moved(test::standing_pose(), 0, {0.6 * x, 0, 0.8 * x});
}

TEST(Continuity, OfAWalkIsItsStep) {
  ContinuityMetric metric;
  for (int step = 0; step < 50; ++step) metric.add(at(0.05 * step), false);
  const ContinuityMetric::Figures figures = metric.figures();
  EXPECT_EQ(figures.steps, 50);
  EXPECT_NEAR(figures.displacement_mean_m, 0.05, 1e-9);
  EXPECT_NEAR(figures.displacement_max_m, 0.05, 1e-9);
  EXPECT_NEAR(figures.second_difference_mean_m, 0, 1e-9) << "at an even pace";
}

TEST(Continuity, AJumpShowsInTheTailAndInTheSecondDifference) {
  // 99 steps of 5 cm and one of 30 cm; the pace changes by 25 cm into it and out of it.
  ContinuityMetric metric;
  for (int step = 0; step <= 100; ++step) metric.add(at(0.05 * step + (step > 50 ? 0.25 : 0)), step == 51);
  const ContinuityMetric::Figures figures = metric.figures();
  EXPECT_NEAR(figures.displacement_mean_m, (99 * 0.05 + 0.30) / 100, 1e-9);
  EXPECT_NEAR(figures.displacement_p95_m, 0.05, 1e-9);
  EXPECT_NEAR(figures.displacement_p99_m, 0.05, 1e-9);
  EXPECT_NEAR(figures.displacement_max_m, 0.30, 1e-9);
  EXPECT_NEAR(figures.second_difference_mean_m, 2 * 0.25 / 99, 1e-9);
  EXPECT_NEAR(figures.second_difference_p99_m, 0.25, 1e-9);
  EXPECT_NEAR(figures.source_changes_per_100, 100.0 / 101, 1e-9);
}

TEST(Continuity, NothingIsComparedAcrossAnInterruption) {
  ContinuityMetric metric;
  for (int step = 0; step < 10; ++step) metric.add(at(0.05 * step), false);
  metric.interrupt();
  for (int step = 0; step < 10; ++step) metric.add(at(7 + 0.05 * step), step == 0);
  const ContinuityMetric::Figures figures = metric.figures();
  EXPECT_EQ(figures.steps, 20);
  EXPECT_NEAR(figures.displacement_max_m, 0.05, 1e-9);
  EXPECT_NEAR(figures.second_difference_p99_m, 0, 1e-9);
  EXPECT_NEAR(figures.source_changes_per_100, 5, 1e-9);
}

TEST(Continuity, IsTheMeanOverJoints) {
  ContinuityMetric metric;
  Pose pose = test::standing_pose();
  metric.add(pose, false);
  pose(3, 1) += 0.5;  // one of 25
  metric.add(pose, false);
  EXPECT_NEAR(metric.figures().displacement_mean_m, 0.02, 1e-12);
}

TEST(Continuity, DoesNotChangeUnderATurnAndAShift) {
  ContinuityMetric here, there;
  for (int step = 0; step < 20; ++step) {
    here.add(at(0.01 * step * step), false);
    there.add(test::moved(at(0.01 * step * step), 2.0, {1, 0, 5}), false);
  }
  EXPECT_NEAR(here.figures().displacement_mean_m, there.figures().displacement_mean_m, 1e-12);
  EXPECT_NEAR(here.figures().second_difference_mean_m, 0.02, 1e-9);
  EXPECT_NEAR(there.figures().second_difference_mean_m, 0.02, 1e-9);
}

TEST(Continuity, OfNothingIsNothing) {
  EXPECT_EQ(ContinuityMetric().figures().steps, 0);
  EXPECT_EQ(ContinuityMetric().figures().source_changes_per_100, 0);
  EXPECT_EQ(ContinuityMetric().figures().displacement_max_m, 0);
}

}  // namespace
}  // namespace abrazo::continuity_test
