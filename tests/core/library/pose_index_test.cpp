#include "core/library/pose_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

namespace abrazo::pose_index_test {
namespace {

std::vector<Features> random_features(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> metres(0, 0.4);
  std::vector<Features> all(static_cast<std::size_t>(count));
  for (Features& features : all)
    for (double& value : features) value = metres(random);
  return all;
}

std::vector<int> numbers_to(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

std::vector<double> brute_force(const std::vector<Features>& all, const std::vector<int>& pairs,
                                const Features& query, std::size_t count) {
  std::vector<double> distances;
  for (const int pair : pairs) distances.push_back((all[static_cast<std::size_t>(pair)] - query).norm());
  std::sort(distances.begin(), distances.end());
  distances.resize(std::min(count, distances.size()));
  return distances;
}

std::vector<double> distances_of(const std::vector<PoseMatch>& matches) {
  std::vector<double> distances;
  for (const PoseMatch& match : matches) distances.push_back(match.distance);
  return distances;
}

TEST(PoseIndex, FindsWhatBruteForceFinds) {
  const auto all = random_features(3000, 1);
  const auto pairs = numbers_to(3000);
  const PoseIndex index(all, pairs);
  std::vector<PoseMatch> matches;
  for (const Features& query : random_features(1000, 2)) {
    index.nearest(query, 10, matches);
    // Distances, not pairs: which of two equally near ones is taken is not promised. Same sum, so the same
    // bits.
    ASSERT_EQ(distances_of(matches), brute_force(all, pairs, query, 10));
  }
}

TEST(PoseIndex, DistancesBelongToTheirPairs) {
  const auto all = random_features(500, 3);
  const PoseIndex index(all, numbers_to(500));
  const Features query = random_features(1, 4).front();
  std::vector<PoseMatch> matches;
  index.nearest(query, 50, matches);
  for (const PoseMatch& match : matches)
    EXPECT_EQ(match.distance, (all[static_cast<std::size_t>(match.pair)] - query).norm());
}

TEST(PoseIndex, FindsOnlyThePairsItWasGiven) {
  const auto all = random_features(100, 5);
  const std::vector<int> odd = {1, 3, 5, 99};
  const PoseIndex index(all, odd);
  std::vector<PoseMatch> matches;
  index.nearest(all[2], 4, matches);
  std::vector<int> found;
  for (const PoseMatch& match : matches) found.push_back(match.pair);
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(odd));
}

TEST(PoseIndex, WithoutWhatIsLeftOutItFindsWhatBruteForceFindsAmongTheRest) {
  const int count = 3000;
  const auto all = random_features(count, 11);
  const PoseIndex index(all, numbers_to(count));
  std::mt19937 random(12);
  std::vector<PoseMatch> matches;
  for (const double share : {0.01, 0.5, 0.99, 0.999}) {
    std::vector<bool> left_out(static_cast<std::size_t>(count));
    std::vector<int> rest;
    for (int pair = 0; pair < count; ++pair) {
      left_out[static_cast<std::size_t>(pair)] = std::bernoulli_distribution(share)(random);
      if (!left_out[static_cast<std::size_t>(pair)]) rest.push_back(pair);
    }
    for (const Features& query : random_features(200, 13)) {
      index.nearest_without(left_out, query, 10, matches);
      ASSERT_EQ(distances_of(matches), brute_force(all, rest, query, 10)) << share;
      for (const PoseMatch& match : matches) ASSERT_FALSE(left_out[static_cast<std::size_t>(match.pair)]);
    }
  }
}

TEST(PoseIndex, LeavingOutTheNearestOfManyGivesTheNextNearest) {
  const auto all = random_features(500, 14);
  const PoseIndex index(all, numbers_to(500));
  const Features query = random_features(1, 15).front();
  std::vector<PoseMatch> before, after;
  index.nearest(query, 60, before);
  std::vector<bool> left_out(500);
  for (std::size_t i = 0; i < 50; ++i) left_out[static_cast<std::size_t>(before[i].pair)] = true;
  index.nearest_without(left_out, query, 10, after);
  ASSERT_EQ(after.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(after[i].pair, before[50 + i].pair);
}

TEST(PoseIndex, FindsNothingWhenAllIsLeftOutAndFewerWhenFewAreLeft) {
  const auto all = random_features(50, 16);
  const PoseIndex index(all, numbers_to(50));
  std::vector<PoseMatch> matches(3);
  std::vector<bool> left_out(50, true);
  index.nearest_without(left_out, all[0], 5, matches);
  EXPECT_TRUE(matches.empty());
  left_out[7] = left_out[9] = false;
  index.nearest_without(left_out, all[9], 5, matches);
  ASSERT_EQ(matches.size(), 2U);
  EXPECT_EQ(matches[0].pair, 9);
}

TEST(PoseIndex, FindsWhatBruteForceFindsAmongManyThatStandVeryClose) {
  // Frames of slow dances: distances far below what single precision tells apart at this offset.
  auto all = random_features(4000, 21);
  for (Features& features : all) features = 1e-9 * features + Features::Constant(3);
  const auto pairs = numbers_to(4000);
  const PoseIndex index(all, pairs);
  std::vector<PoseMatch> matches;
  for (int q = 0; q < 50; ++q) {
    const Features query = all[static_cast<std::size_t>(q * 71)] + Features::Constant(1e-10);
    index.nearest(query, 10, matches);
    ASSERT_EQ(distances_of(matches), brute_force(all, pairs, query, 10));
  }
}

TEST(PoseIndex, FindsWhatBruteForceFindsWhenNumbersAreNoLengthsOfABody) {
  for (const double scale : {1e-200, 1e-30, 1e10, 1e25, 1e100, 1e300}) {
    auto all = random_features(700, 22);
    for (Features& features : all) features *= scale;
    const auto pairs = numbers_to(700);
    const PoseIndex index(all, pairs);
    std::vector<PoseMatch> matches;
    for (const double query_scale : {0.0, scale, 1e-5 * scale, 1e12})
      for (const Features& direction : random_features(5, 23)) {
        const Features query = query_scale * direction;
        index.nearest(query, 10, matches);
        ASSERT_EQ(distances_of(matches), brute_force(all, pairs, query, 10)) << scale << ' ' << query_scale;
      }
  }
}

TEST(PoseIndex, FindsWhatBruteForceFindsWhateverTheirNumber) {
  for (const int count : {1, 2, 15, 16, 17, 31, 32, 33, 47, 48, 49, 100, 255, 256, 257}) {
    const auto all = random_features(count, 24);
    const auto pairs = numbers_to(count);
    const PoseIndex index(all, pairs);
    std::vector<PoseMatch> matches;
    for (const Features& query : random_features(20, 25)) {
      index.nearest(query, 7, matches);
      ASSERT_EQ(distances_of(matches), brute_force(all, pairs, query, 7)) << count;
    }
  }
}

TEST(PoseIndex, TheSameForEveryOrderOfThePairs) {
  auto all = random_features(2000, 26);
  for (std::size_t i = 0; i < 1000; ++i) all[i + 1000] = all[i];  // ties
  auto order = numbers_to(2000);
  const PoseIndex one(all, order);
  std::shuffle(order.begin(), order.end(), std::mt19937(27));
  const PoseIndex other(all, order);
  std::vector<PoseMatch> a, b;
  for (const Features& query : random_features(100, 28)) {
    one.nearest(query, 11, a);
    other.nearest(query, 11, b);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(a[i].pair, b[i].pair);
      ASSERT_EQ(a[i].distance, b[i].distance);
    }
  }
}

TEST(PoseIndex, FindsAPoseItself) {
  const auto all = random_features(200, 6);
  const PoseIndex index(all, numbers_to(200));
  std::vector<PoseMatch> matches;
  index.nearest(all[77], 1, matches);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches[0].pair, 77);
  EXPECT_EQ(matches[0].distance, 0);
}

TEST(PoseIndex, GivesAllWhenMoreAreWantedThanThereAre) {
  const auto all = random_features(7, 7);
  const PoseIndex index(all, numbers_to(7));
  std::vector<PoseMatch> matches;
  index.nearest(all[0], 50, matches);
  EXPECT_EQ(matches.size(), 7U);
  index.nearest(all[0], 0, matches);
  EXPECT_TRUE(matches.empty());
}

TEST(PoseIndex, AnEmptyIndexFindsNothing) {
  const auto all = random_features(7, 7);
  const PoseIndex index(all, {});
  std::vector<PoseMatch> matches(3);
  index.nearest(all[0], 5, matches);
  EXPECT_TRUE(matches.empty());
  EXPECT_EQ(index.size(), 0);
}

TEST(PoseIndex, EqualDistancesComeInTheOrderOfPairNumbers) {
  const std::vector<Features> all(40, random_features(1, 8).front());
  const PoseIndex index(all, numbers_to(40));
  std::vector<PoseMatch> matches;
  index.nearest(Features::Zero(), 40, matches);
  ASSERT_EQ(matches.size(), 40U);
  for (int i = 0; i < 40; ++i) EXPECT_EQ(matches[static_cast<std::size_t>(i)].pair, i);
}

TEST(PoseIndex, KeepsItsOwnCopyOfTheFeatures) {
  auto all = random_features(200, 9);
  const std::vector<Features> copy = all;
  PoseIndex index(all, numbers_to(200));
  for (Features& features : all) features.setConstant(1e6);
  const PoseIndex moved = std::move(index);
  std::vector<PoseMatch> matches;
  moved.nearest(copy[5], 1, matches);
  EXPECT_EQ(matches[0].pair, 5);
}

TEST(PoseIndex, RefusesWhatCannotBeCompared) {
  auto all = random_features(5, 10);
  EXPECT_THROW(PoseIndex(all, std::vector<int>{5}), std::invalid_argument);
  EXPECT_THROW(PoseIndex(all, std::vector<int>{-1}), std::invalid_argument);
  const PoseIndex index(all, numbers_to(5));
  Features query = all[0];
  query(3) = std::numeric_limits<double>::quiet_NaN();
  std::vector<PoseMatch> matches;
  EXPECT_THROW(index.nearest(query, 1, matches), std::invalid_argument);
  all[2](0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(PoseIndex(all, numbers_to(5)), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::pose_index_test
