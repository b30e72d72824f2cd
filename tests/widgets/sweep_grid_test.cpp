#include "widgets/sweep/sweep_grid.hpp"

#include <gtest/gtest.h>

#include "widgets/sweep/sweep_request.hpp"

namespace abrazo::widgets::sweep_grid_test {
namespace {

using State = SweepCell::State;

SweepGrid three_by_two(SweepGoal goal = SweepGoal::Lowest) {
  return {{"alpha", "\u03b1", "", {"0", "0.5", "1"}},
          {"transition-time", "transition time", "s", {"0.2", "0.3"}},
          "partner.mean_joint_error_m",
          goal};
}

TEST(SweepGrid, PointsRunAlongTheColumnsFirst) {
  const SweepGrid grid = three_by_two();
  EXPECT_EQ(grid.points(), 6);
  EXPECT_EQ(grid.place_of(4), std::pair(1, 1));
  EXPECT_EQ(grid.point_at(1, 1), 4);
  EXPECT_EQ(grid.place_text(4), "\u03b1 0.5, transition time 0.3 s");
}

TEST(SweepGrid, TheBestIsByTheGoalAndTheFirstOfEquals) {
  for (const auto& [goal, best] : {std::pair(SweepGoal::Lowest, 1), std::pair(SweepGoal::Highest, 3),
                                   std::pair(SweepGoal::NearestZero, 2)}) {
    SweepGrid grid = three_by_two(goal);
    EXPECT_FALSE(grid.best());
    const double values[] = {3, -5, 0.5, 7, 7, -0.5};
    for (int point = 0; point < 6; ++point) grid.set(point, {State::Measured, values[point], {}});
    EXPECT_EQ(grid.best(), best);
    EXPECT_EQ(grid.range(), std::pair(-5.0, 7.0));
  }
}

TEST(SweepGrid, CellsWithoutAValueAreNeitherBestNorInTheRange) {
  SweepGrid grid = three_by_two();
  grid.set(0, {State::Undefined, 0, {}});
  grid.set(1, {State::Failed, 0, "take one: no step could be solved"});
  grid.set(2, {State::Measured, 0.25, {}});
  EXPECT_EQ(grid.best(), 2);
  EXPECT_EQ(grid.range(), std::pair(0.25, 0.25));
  EXPECT_EQ(grid.fraction_of(0.25), 0.5) << "a single value is in the middle of the colours";
  EXPECT_EQ(grid.count(State::Waiting), 3);
  EXPECT_EQ(grid.value_text(1), "failed: take one: no step could be solved");
  EXPECT_EQ(grid.value_text(2), "0.25 m");
  EXPECT_EQ(grid.value_text(3), "not evaluated yet");
  EXPECT_EQ(grid.best_text(), "Best so far (lowest): \u03b1 1, transition time 0.2 s: 0.25 m.");
}

TEST(SweepGrid, ArrowKeysStayWithinTheGrid) {
  const SweepGrid grid = three_by_two();
  EXPECT_EQ(grid.moved(0, 1, 0), 1);
  EXPECT_EQ(grid.moved(0, 0, 1), 3);
  EXPECT_EQ(grid.moved(0, -1, -1), 0);
  EXPECT_EQ(grid.moved(5, 1, 1), 5);
}

TEST(SweepGrid, AnotherFigureKeepsWhatFailed) {
  SweepGrid grid = three_by_two();
  grid.set(0, {State::Failed, 0, "why"});
  grid.set(1, {State::Measured, 1, {}});
  grid.set_metric("moves.rate", SweepGoal::Highest);
  EXPECT_EQ(grid.cell(0).state, State::Failed);
  EXPECT_EQ(grid.cell(1).state, State::Waiting);
  EXPECT_EQ(grid.goal(), SweepGoal::Highest);
}

TEST(MetricUnit, IsReadFromThePath) {
  EXPECT_EQ(metric_words("partner.mean_joint_error_m"), "partner: mean joint error [m]");
  EXPECT_EQ(metric_words("contact.foot_slide_m_per_s.synthesised"), "contact: foot slide: synthesised [m/s]");
  EXPECT_EQ(metric_words("moves.rate"), "moves: rate");
  EXPECT_EQ(metric_unit("partner.mean_joint_error_m"), "m");
  EXPECT_EQ(metric_unit("partner.lag_ms"), "ms");
  EXPECT_EQ(metric_unit("solve_us.p99"), "\u00b5s");
  EXPECT_EQ(metric_unit("contact.foot_slide_m_per_s.synthesised"), "m/s");
  EXPECT_EQ(metric_unit("zmp.synthesised_asf"), "ASF units");
  EXPECT_EQ(metric_unit("moves.rate"), "");
}

TEST(MetricUnit, OfTheMovementAndOfCounts) {
  EXPECT_EQ(metric_words("movement.lag_s"), "movement: lag [s]");
  EXPECT_EQ(metric_words("movement.changes_per_s"), "movement: changes [1/s]");
  EXPECT_EQ(metric_words("movement.step_max_m.synthesised"), "movement: step max: synthesised [m]");
  EXPECT_EQ(metric_unit("movement.acceleration_rms.captured"), "m/s\u00b2");
  EXPECT_EQ(metric_unit("movement.acceleration_ratio"), "");
  EXPECT_EQ(metric_unit("solve_us.steps"), "");
}

TEST(SweepColour, GoesFromDarkVioletToYellowAndGetsLighterAllTheWay) {
  EXPECT_NEAR(sweep_colour(0)[0], 68 / 255.0, 1e-9);
  EXPECT_NEAR(sweep_colour(1)[1], 231 / 255.0, 1e-9);
  double before = 0;
  for (double fraction = 0; fraction <= 1; fraction += 0.05) {
    const auto [red, green, blue] = sweep_colour(fraction);
    const double luminance = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    EXPECT_GE(luminance, before) << fraction;
    before = luminance;
  }
}

TEST(SweepRequest, AxesAreInTheWordsOfTheCommandLine) {
  EXPECT_EQ(axis_text(*find_setting("alpha"), "0", "1", 5), "alpha=0:1:5");
  EXPECT_EQ(axis_text(*find_setting("alpha"), "0.5", "", 1), "alpha=0.5");
  EXPECT_EQ(axis_text(*find_setting("morph-weight"), "1", "100", 3), "morph-weight=log:1:100:3");
  EXPECT_EQ(axis_text(*find_setting("foot-locks"), "", "", 2), "foot-locks=off,on");
  EXPECT_EQ(axis_text(*find_setting("edge-weights"), "", "", 3), "edge-weights=inverse,inverse-mean,uniform");
}

TEST(SweepRequest, ProposesARangeAroundThePresentValueWithinTheSettings) {
  for (const SettingInfo& info : all_settings()) {
    if (!is_counted(info)) continue;
    for (const std::string_view name : preset_names) {
      const SweepSpan span = usual_span(info, setting_number(*preset(name), info.key));
      EXPECT_GE(span.from, info.minimum) << info.key;
      EXPECT_LE(span.to, info.maximum) << info.key;
      EXPECT_LT(span.from, span.to) << info.key;
      EXPECT_GE(span.count, 2) << info.key;
    }
  }
  EXPECT_EQ(usual_span(*find_setting("alpha"), 0.5), (SweepSpan{0, 2, 5}));
  EXPECT_EQ(usual_span(*find_setting("step-rate"), 0), (SweepSpan{15, 60, 4})) << "1 to 4 Hz do not exist";
  EXPECT_EQ(usual_span(*find_setting("morph-weight"), 10), (SweepSpan{1, 100, 5}));
}

}  // namespace
}  // namespace abrazo::widgets::sweep_grid_test
