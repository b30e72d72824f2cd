#include "core/annotation/tiling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

namespace abrazo::tiling_test {
namespace {

/// Every tiling with its score, by trying them all.
void for_each_tiling(const TilingScores& scores,
                     const std::function<void(const std::vector<TilingSegment>&, double)>& visit) {
  std::vector<TilingSegment> tiling;
  const std::function<void(double)> go_on = [&](double sum) {
    const int begin = tiling.empty() ? 0 : tiling.back().end;
    if (begin == scores.cells())
      return visit(tiling, sum + scores.last[static_cast<std::size_t>(tiling.back().state)]);
    for (int length = 1; length <= scores.longest() && begin + length <= scores.cells(); ++length)
      for (int state = 0; state < scores.states(); ++state) {
        const double before = tiling.empty() ? scores.first[static_cast<std::size_t>(state)]
                                             : scores.follows(tiling.back().state, state);
        tiling.push_back({begin, begin + length, state});
        go_on(sum + before + scores.segment(begin, length, state));
        tiling.pop_back();
      }
  };
  go_on(0);
}

TilingScores drawn(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 2);
  TilingScores scores(6, 4, 3);
  for (int begin = 0; begin < 6; ++begin)
    for (int length = 1; length <= 4 && begin + length <= 6; ++length)
      for (int state = 0; state < 3; ++state)
        if (random() % 5 != 0) scores.segment(begin, length, state) = normal(random);
  for (int state = 0; state < 3; ++state) {
    scores.first[static_cast<std::size_t>(state)] = normal(random);
    scores.last[static_cast<std::size_t>(state)] = normal(random);
    for (int next = 0; next < 3; ++next) scores.follows(state, next) = normal(random);
  }
  return scores;
}

TEST(Tiling, IsTheBestOfAll) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const TilingScores scores = drawn(seed);
    double most = -std::numeric_limits<double>::infinity();
    std::vector<TilingSegment> best;
    for_each_tiling(scores, [&](const auto& tiling, double sum) {
      if (sum > most) most = sum, best = tiling;
    });
    EXPECT_EQ(best_tiling(scores), best) << "seed " << seed;
  }
}

TEST(Tiling, StateProbabilitiesAreThoseOfAllTilings) {
  for (unsigned seed = 0; seed < 10; ++seed)
    for (const double temperature : {1.0, 2.5}) {
      const TilingScores scores = drawn(seed);
      std::vector<double> expected(18, 0);
      double all = 0;
      for_each_tiling(scores, [&](const auto& tiling, double sum) {
        const double weight = std::exp(sum / temperature);
        all += weight;
        for (const TilingSegment& segment : tiling)
          for (int cell = segment.begin; cell < segment.end; ++cell)
            expected[static_cast<std::size_t>(3 * cell + segment.state)] += weight;
      });
      const std::vector<double> found = state_probabilities(scores, temperature);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i] / all, 1e-9) << "seed " << seed << ", cell " << i / 3;
    }
}

TEST(Tiling, IsEmptyWhenNoneIsPossible) {
  const TilingScores scores(5, 2, 2);
  EXPECT_TRUE(best_tiling(scores).empty());
  for (const double share : state_probabilities(scores, 1)) EXPECT_EQ(share, 0.5);
}

TEST(Tiling, RefusesNoCells) {
  EXPECT_THROW(TilingScores(0, 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::tiling_test
