#include "core/evaluation/run/selection_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/evaluation/takes/pose_queries.hpp"
#include "evaluation_takes.hpp"

namespace abrazo::selection_table_test {
namespace {

using namespace test;

EvaluationOptions with_queries(int queries) {
  EvaluationOptions options;
  options.settings = *preset("paper");
  options.queries = queries;
  return options;
}

TEST(PairsWithout, LeaveATakeOutAndThinTheOthers) {
  const EvaluationData data = three_takes();
  EXPECT_EQ(pairs_without(*data.library, "", 0).size(), 360u);
  EXPECT_EQ(pairs_without(*data.library, "second", 0).size(), 240u);
  const std::vector<int> thin = pairs_without(*data.library, "second", 15);
  EXPECT_EQ(thin.size(), 61u);  // every 4th of 150 and of 90 frames
  for (const int pair : thin) EXPECT_EQ(data.library->source(pair).frame % 4, 0u);
}

TEST(PoseQueries, OfARecordedPoseIsItsRowOfTheLibrary) {
  const EvaluationData data = three_takes();
  const auto queries = PoseQueries(*data.library, UserRole::Active, false).of(data.takes[2], {0, 41});
  ASSERT_TRUE(queries);
  const int pair = data.library->find_pair("third", 41, false);
  EXPECT_LT(((*queries)[1].features - data.library->features(pair)).norm(), 1e-12);
  EXPECT_LT(((*queries)[1].predicted - data.library->pair_in_world(pair, (*queries)[1].root)).norm(), 1e-9);
}

TEST(SelectionTable, HasThePapersColumnsForTheFullAndTheThinnedLibrary) {
  const auto tables = measure_selection(three_takes(), with_queries(60), {});
  ASSERT_TRUE(tables);
  ASSERT_EQ(tables->size(), 2u);
  EXPECT_EQ((*tables)[0].rate_hz, 60);
  EXPECT_EQ((*tables)[1].rate_hz, 15);
  for (const SelectionTable& table : *tables) {
    ASSERT_EQ(table.rows.size(), 10u);
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      const SelectionRow& row = table.rows[r];
      EXPECT_EQ(row.k, 5 * static_cast<int>(r + 1));
      EXPECT_LE(row.recall_best, row.recall_best2);
      EXPECT_LE(row.recall_best2, 1);
      EXPECT_GE(row.pose_excess, 0);
      // A longer list is never found less often.
      if (r > 0) {
        EXPECT_GE(row.recall_best, table.rows[r - 1].recall_best);
      }
    }
  }
}

TEST(SelectionTable, FindsTheBestAlwaysWhenTheListHoldsTheWholeLibrary) {
  EvaluationData data = three_takes();
  const auto tables = measure_selection(data, with_queries(40), {});
  ASSERT_TRUE(tables);
  // At 15 Hz some 53 to 68 pairs are left, of which the 50 nearest in feature space hold the best ones.
  EXPECT_EQ((*tables)[1].rows.back().recall_best, 1);
  EXPECT_NEAR((*tables)[1].rows.back().pose_excess, 0, 1e-12);
}

TEST(SelectionTable, CountsWhatAnIndependentSearchFinds) {
  const EvaluationData data = three_takes();
  EvaluationOptions options = with_queries(200);
  options.hold_out = {"third"};
  const auto tables = measure_selection(data, options, {});
  ASSERT_TRUE(tables);
  // All 90 frames of the take instead of 200 drawn ones: the shares agree within the drawing's error.
  const MotionLibrary& library = *data.library;
  std::vector<int> frames(90);
  for (int f = 0; f < 90; ++f) frames[static_cast<std::size_t>(f)] = f;
  const auto queries = PoseQueries(library, UserRole::Active, false).of(data.takes[2], frames);
  int found = 0;
  for (const SelectionQuery& query : *queries) {
    std::vector<std::pair<double, int>> by_feature, by_pose;
    for (const int pair : pairs_without(library, "third", 0)) {
      by_feature.emplace_back((library.features(pair) - query.features).norm(), pair);
      by_pose.emplace_back((library.pose(pair).topRows<joint_count>() - query.normalized).norm(), pair);
    }
    std::sort(by_feature.begin(), by_feature.end());
    const int best = std::min_element(by_pose.begin(), by_pose.end())->second;
    found += std::any_of(by_feature.begin(), by_feature.begin() + 10,
                         [&](const auto& f) { return f.second == best; });
  }
  const double share = found / 90.0;
  EXPECT_NEAR((*tables)[0].rows[1].recall_best, share, 4 * std::sqrt(0.25 / 200));
}

TEST(TimingTable, TheLargestLibraryAskedForIsTimedWhateverItsSize) {
  EvaluationOptions options = with_queries(10);
  options.largest_library = 8'000;
  const auto rows = measure_timing(three_takes(), options, {});
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 2u);
  EXPECT_EQ((*rows)[0].pairs, 7'500);
  EXPECT_EQ((*rows)[1].pairs, 8'000);
}

TEST(TimingTable, TimesLibrariesUpToTheSizeAskedForAndSaysWhatWasGenerated) {
  EvaluationOptions options = with_queries(10);
  options.largest_library = 15'000;
  const auto rows = measure_timing(three_takes(), options, {});
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 2u);
  EXPECT_EQ((*rows)[0].pairs, 7'500);
  EXPECT_EQ((*rows)[1].pairs, 15'000);
  EXPECT_EQ((*rows)[1].generated, 15'000 - 210);  // the longest take, 150 frames, gives the queries
  for (const TimingRow& row : *rows) {
    EXPECT_GT(row.knn_us, 0);
    EXPECT_GT(row.brute_us, 0);
  }
}

}  // namespace
}  // namespace abrazo::selection_table_test
