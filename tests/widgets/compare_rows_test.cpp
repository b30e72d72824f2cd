#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "widgets/compare/curve_scale.hpp"
#include "widgets/compare/figure_rows.hpp"
#include "widgets/scene/values/comparison_dashes.hpp"

namespace abrazo::widgets::compare_rows_test {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

RunFigures figures_with(RunFigure figure, double value) {
  RunFigures figures;
  figures.fill(nothing);
  figures[static_cast<std::size_t>(figure)] = value;
  return figures;
}

FigureRow row_of(RunFigure figure, double a, double b) {
  return figure_row(figure, figures_with(figure, a), figures_with(figure, b));
}

TEST(FigureRows, AFigureIsWrittenInItsUnitWithItsDifference) {
  const FigureRow row = row_of(RunFigure::BehindSelected, 0.151, 0.064);
  EXPECT_EQ(row.a, "151");
  EXPECT_EQ(row.b, "64");
  EXPECT_EQ(row.unit, "mm");
  EXPECT_EQ(row.difference, "−87");
  EXPECT_EQ(row.better, Better::B);
  EXPECT_EQ(row_of(RunFigure::BehindSelected, 0.064, 0.151).difference, "+87");
  EXPECT_EQ(row_of(RunFigure::BehindSelected, 0.064, 0.151).better, Better::A);
}

TEST(FigureRows, WhatIsWrittenAlikeIsNoBetter) {
  const FigureRow row = row_of(RunFigure::BehindSelected, 0.0640, 0.0643);
  EXPECT_EQ(row.better, Better::Neither);
  EXPECT_EQ(row.difference, "=");
}

TEST(FigureRows, WhatCannotBeMeasuredIsADash) {
  const FigureRow row = row_of(RunFigure::HoldChange, nothing, 0.01);
  EXPECT_EQ(row.a, "—");
  EXPECT_EQ(row.b, "10.0");
  EXPECT_EQ(row.difference, "");
  EXPECT_EQ(row.better, Better::Neither);
}

TEST(FigureRows, EveryFigureHasARow) {
  EXPECT_EQ(
      figure_rows(figures_with(RunFigure::BehindSelected, 0), figures_with(RunFigure::BehindSelected, 0))
          .size(),
      run_figure_count);
}

TEST(DifferingSettings, OnlyWhatDiffersIsNamedInTheRunsOwnValue) {
  Settings a = *preset("responsive"), b = a;
  a.alpha = 0.25;
  b.velocity_weight = 0.35;
  const auto of_a = differing_settings(a, b);
  ASSERT_EQ(of_a.size(), 2U);
  EXPECT_EQ(of_a[0].name, "α");
  EXPECT_EQ(of_a[0].value, "0.25");
  EXPECT_EQ(differing_settings(b, a)[1].value, "0.35");
  EXPECT_TRUE(differing_settings(a, a).empty());
}

TEST(DifferingSettings, TheLineIsShortAndNamesPresets) {
  Settings a = *preset("responsive"), b = *preset("paper");
  EXPECT_EQ(settings_line(a, b), "preset responsive");
  a.alpha = 0.25;
  b.alpha = 0.75;
  const std::string line = settings_line(a, b);
  EXPECT_NE(line.find("α 0.25"), std::string::npos);
  EXPECT_NE(line.find("more"), std::string::npos) << line;
  EXPECT_EQ(settings_line(a, a), "same settings");
}

TEST(CurveScale, TimesAndValuesHaveAPlaceAndBack) {
  CurveScale scale{10, 5, 200, 100, 2, 4, 50};
  EXPECT_DOUBLE_EQ(scale.x(2), 10);
  EXPECT_DOUBLE_EQ(scale.x(3), 110);
  EXPECT_DOUBLE_EQ(scale.time(110), 3);
  EXPECT_DOUBLE_EQ(scale.time(-50), 2);
  EXPECT_DOUBLE_EQ(scale.y(0), 105);
  EXPECT_DOUBLE_EQ(scale.y(50), 5);
  EXPECT_DOUBLE_EQ(scale.y(80), 5) << "what towers over the rest is cut";
  scale.last_s = 2;
  EXPECT_DOUBLE_EQ(scale.x(2), 10) << "one step only";
}

std::vector<ComparedStep> steps_at(std::initializer_list<double> times_s) {
  std::vector<ComparedStep> steps;
  for (const double time_s : times_s) {
    ComparedStep step;
    step.time_s = time_s;
    step.a.fill(nothing);
    step.b.fill(0.032);
    steps.push_back(step);
  }
  return steps;
}

TEST(CurveScale, TheTopIsARoundNumberAboveBothRuns) {
  EXPECT_DOUBLE_EQ(curve_upper(steps_at({1, 2}), StepFigure::BehindSelected), 50);  // 32 mm
  EXPECT_DOUBLE_EQ(curve_upper({}, StepFigure::BehindSelected), 1);
}

TEST(CurveScale, TheStepOfAnInstantIsTheLastNotAfterIt) {
  const auto steps = steps_at({1, 2, 3});
  EXPECT_EQ(step_at(steps, 2.5), 1);
  EXPECT_EQ(step_at(steps, 0), 0);
  EXPECT_EQ(step_at(steps, 9), 2);
  EXPECT_EQ(step_at({}, 1), -1);
}

PairPose rising_pair() {
  PairPose pair;
  for (int v = 0; v < pair_vertex_count; ++v) pair.row(v) << 0.1 * v, 1, 0;
  return pair;
}

TEST(ComparisonDashes, ADashedBoneBeginsAndEndsWithADash) {
  const PairPose pair = rising_pair();
  const auto whole = bone_strokes(pair, joint_count, false), dashed = bone_strokes(pair, joint_count, true);
  ASSERT_EQ(whole.size(), static_cast<std::size_t>(6 * bone_count));
  EXPECT_GT(dashed.size(), whole.size());
  EXPECT_EQ(dashed.size() % 6, 0U);
  EXPECT_DOUBLE_EQ(dashed[0], whole[0]);
  EXPECT_NEAR(dashed[dashed.size() - 3], whole[whole.size() - 3], 1e-12);
}

TEST(ComparisonDashes, DashesAreLongerThanGapsAndNeverOverlap) {
  PairPose pair = PairPose::Zero();
  pair.row(bone(0).second) << 0.5, 0, 0;
  const auto ends = bone_strokes(pair, 0, true);
  double drawn = 0;
  for (std::size_t i = 0; i + 5 < ends.size() && ends[i + 3] <= 0.5 + 1e-9 && ends[i + 3] > ends[i]; i += 6)
    drawn += ends[i + 3] - ends[i];
  EXPECT_NEAR(drawn / 0.5, 0.62, 0.03);
}

TEST(ComparisonDashes, OnlyJointsThatAreApartAreTied) {
  const PairPose a = rising_pair();
  PairPose b = a;
  b(joint_count + 3, 2) = 0.05;
  b(joint_count + 4, 2) = 0.01;
  b(2, 2) = 1;
  const auto ends = difference_strokes(a, b, joint_count, 0.02);
  ASSERT_EQ(ends.size(), 6U);
  EXPECT_DOUBLE_EQ(ends[5], 0.05);
}

}  // namespace
}  // namespace abrazo::widgets::compare_rows_test
