#include <cmath>

#include "core/evaluation/run/library_data.hpp"

#include <gtest/gtest.h>

#include "core/evaluation/sweep/sweep_metric.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/takes_of_library.hpp"
#include "tests/core/evaluation/evaluation_takes.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::library_data_test {
namespace {

double farthest(const Clip& a, const Clip& b) {
  double distance = 0;
  for (std::size_t frame = 0; frame < a.poses.size(); ++frame)
    distance = std::max(distance, (a.poses[frame] - b.poses[frame]).cwiseAbs().maxCoeff());
  return distance;
}

TEST(LibraryTakes, AreTheTakesThatTheLibraryWasBuiltFrom) {
  const EvaluationData original = test::three_takes();
  const auto again = takes_of_library(*original.library);
  ASSERT_TRUE(again) << again.error().text();
  ASSERT_EQ(again->size(), original.takes.size());
  for (std::size_t t = 0; t < again->size(); ++t) {
    const PairedTake &one = original.takes[t], &other = (*again)[t];
    EXPECT_EQ(other.name, one.name);
    EXPECT_EQ(other.fps, one.fps);
    ASSERT_EQ(other.a.poses.size(), one.a.poses.size());
    ASSERT_EQ(other.b.poses.size(), one.b.poses.size());
    EXPECT_LT(farthest(one.a, other.a), 1e-12);
    EXPECT_LT(farthest(one.b, other.b), 1e-12);
    ASSERT_EQ(other.labels.size(), one.labels.size());
    for (int frame = 0; frame < static_cast<int>(one.a.poses.size()); ++frame)
      ASSERT_EQ(active_at(other, frame), active_at(one, frame));
  }
}

TEST(LibraryTakes, PerformerBIsBAlsoWhereHeLeads) {
  PairedTake take = test::swinging_take("led by b", 60, 5);
  take.roles = {{0, 60, ActivePerformer::B}};
  auto library = build_library("swapped", {take}, {}, {});
  ASSERT_TRUE(library);
  const auto again = takes_of_library(*library);
  ASSERT_TRUE(again);
  EXPECT_LT(farthest(take.a, again->front().a), 1e-12);
  EXPECT_LT(farthest(take.b, again->front().b), 1e-12);
}

TEST(LibraryTakes, OfAThinnedLibraryHaveItsRateAndTheLabelsInItsFrames) {
  PairedTake take = test::swinging_take("thinned", 60, 6);
  take.roles = {{0, 60, ActivePerformer::A}};
  take.labels = {{10, 30, "turn", "", ""}};
  auto library =
      build_library("thinned", {take}, {.excluded_takes = {}, .rate_hz = 15.0, .both_roles = false}, {});
  ASSERT_TRUE(library);
  const auto again = takes_of_library(*library);
  ASSERT_TRUE(again);
  const PairedTake& thin = again->front();
  EXPECT_EQ(thin.fps, 15);
  ASSERT_EQ(thin.a.poses.size(), 15U);
  for (int frame = 0; frame < 15; ++frame)
    EXPECT_EQ(label_at(thin.labels, frame), label_at(take.labels, 4 * frame)) << frame;
}

TEST(LibraryTakes, GiveTheFiguresThatTheFilesGive) {
  const EvaluationData original = test::three_takes();
  const auto again = evaluation_data_of(original.library);
  ASSERT_TRUE(again);
  EXPECT_FALSE(again->both_roles);
  EvaluationOptions options;
  options.parts = sweep_parts();
  options.settings = *preset("paper");
  options.variants = false;
  const auto one = evaluate(original, options, {}), other = evaluate(*again, options, {});
  ASSERT_TRUE(one && other);
  const Figures expected = figures_of(*one), found = figures_of(*other);
  for (const auto& [name, value] : expected) {
    if (name.starts_with("solve_us")) continue;  // times
    ASSERT_TRUE(found.contains(name)) << name;
    EXPECT_NEAR(found.at(name), value, 1e-6 * (1 + std::abs(value))) << name;
  }
}

}  // namespace
}  // namespace abrazo::library_data_test
