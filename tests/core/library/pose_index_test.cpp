#include "core/library/store/pose_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

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

/// Pairs with their distances, nearest first, equal distances by pair number.
using Answer = std::vector<std::pair<double, int>>;

Answer brute_force_answer(const std::vector<Features>& all, const std::vector<bool>& left_out,
                          const Features& query, std::size_t count) {
  Answer answer;
  for (std::size_t pair = 0; pair < all.size(); ++pair)
    if (!left_out[pair]) answer.emplace_back((all[pair] - query).norm(), static_cast<int>(pair));
  std::sort(answer.begin(), answer.end());
  answer.resize(std::min(count, answer.size()));
  return answer;
}

Answer as_answer(const std::vector<PoseMatch>& matches) {
  Answer answer;
  for (const PoseMatch& match : matches) answer.emplace_back(match.distance, match.pair);
  return answer;
}

/// As poses of a dance are: along few directions, some of them twice.
std::vector<Features> dance_like_features(int count, unsigned seed) {
  const auto directions = random_features(15, seed);
  auto all = random_features(count, seed + 1);
  for (Features& features : all) {
    Features pose = Features::Zero();
    double width = 0.5;
    for (int axis = 0; axis < 15; ++axis, width *= 0.7)
      pose += width * features(axis) * directions[static_cast<std::size_t>(axis)];
    features = pose;
  }
  for (std::size_t i = 0; i + 7 < all.size(); i += 100) all[i + 7] = all[i];
  return all;
}

std::vector<bool> some_left_out(int count, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution leaves_out(share);
  std::vector<bool> left_out(static_cast<std::size_t>(count));
  for (std::size_t pair = 0; pair < left_out.size(); ++pair) left_out[pair] = leaves_out(random);
  return left_out;
}

class PoseIndexBy : public testing::TestWithParam<PoseIndex::Tree> {};
INSTANTIATE_TEST_SUITE_P(EveryTree, PoseIndexBy,
                         testing::Values(PoseIndex::Tree::Flann, PoseIndex::Tree::Own), [](const auto& tree) {
                           return tree.param == PoseIndex::Tree::Flann ? "Flann" : "Own";
                         });

TEST_P(PoseIndexBy, AnswersAsBruteForceDoesNearAndFarAndWhateverIsVetoed) {
  constexpr int count = 20'000;
  const auto all = dance_like_features(count, 30);
  const PoseIndex index(all, numbers_to(count), GetParam());
  std::vector<PoseMatch> matches;
  for (const double share : {0.0, 0.5, 0.9, 0.99, 0.999}) {
    const std::vector<bool> left_out = some_left_out(count, share, 31);
    unsigned seed = 40;
    for (const double off_m : {0.0, 0.1, 0.3, 0.6, 5.0, 1e3, 1e9, 1e150}) {
      const auto noise = random_features(8, ++seed);
      for (std::size_t q = 0; q < noise.size(); ++q) {
        const Features query = all[q * 1997] + off_m / 0.4 * noise[q];
        matches.clear();
        index.nearest_without(left_out, query, 10, matches);
        ASSERT_EQ(as_answer(matches), brute_force_answer(all, left_out, query, 10)) << share << ' ' << off_m;
      }
    }
  }
}

TEST_P(PoseIndexBy, AnswersTheSameWhateverItWasAnsweredBefore) {
  constexpr int count = 5000;
  const auto all = dance_like_features(count, 32);
  const PoseIndex index(all, numbers_to(count), GetParam());
  const std::vector<bool> left_out = some_left_out(count, 0.3, 33);
  std::vector<PoseMatch> nearby;
  for (int q = 0; q < 100; ++q) {
    const Features query = all[static_cast<std::size_t>(q) * 31] + Features::Constant(0.001 * q);
    const Answer wanted = brute_force_answer(all, left_out, query, 10);
    index.nearest_without(left_out, query, 10, nearby);
    ASSERT_EQ(as_answer(nearby), wanted) << "after the answer to another query";
    index.nearest_without(left_out, query, 10, nearby);
    ASSERT_EQ(as_answer(nearby), wanted) << "after the same answer";
    std::vector<PoseMatch> twice(12, PoseMatch{nearby.front().pair, 0});
    index.nearest_without(left_out, query, 10, twice);
    ASSERT_EQ(as_answer(twice), wanted) << "after one pair twelve times";
    std::vector<PoseMatch> nonsense = {{-1, 0}, {count, 0}, {1 << 30, 0}};
    for (int pair = 0; pair < 40; ++pair) nonsense.push_back({pair, -1});
    index.nearest_without(left_out, query, 10, nonsense);
    ASSERT_EQ(as_answer(nonsense), wanted) << "after pairs that are far, left out or none";
  }
}

TEST_P(PoseIndexBy, AnswersTheSameAfterAnAnswerWithPairsThatItDoesNotHave) {
  constexpr int count = 400;
  auto all = random_features(count, 41);
  for (Features& features : all) features += Features::Constant(100);
  std::vector<int> even;
  std::vector<bool> left_out(count, true);
  for (int pair = 0; pair < count; pair += 2) {
    even.push_back(pair);
    left_out[static_cast<std::size_t>(pair)] = false;
  }
  const PoseIndex index(all, even, GetParam());
  for (const Features& query : {Features(Features::Zero()), all[3]}) {
    std::vector<PoseMatch> matches;
    for (int pair = 1; pair < count; pair += 2) matches.push_back({pair, 0});
    index.nearest(query, 10, matches);
    EXPECT_EQ(as_answer(matches), brute_force_answer(all, left_out, query, 10));
  }
}

TEST_P(PoseIndexBy, ManyThreadsMayAskAtOnce) {
  constexpr int count = 3000;
  const auto all = dance_like_features(count, 34);
  const PoseIndex index(all, numbers_to(count), GetParam());
  const std::vector<bool> none(count, false);
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&, thread] {
      std::vector<PoseMatch> matches;
      for (int q = thread; q < 200; q += 4) {
        const Features query = all[static_cast<std::size_t>(q)] + Features::Constant(0.002 * q);
        index.nearest(query, 10, matches);
        EXPECT_EQ(as_answer(matches), brute_force_answer(all, none, query, 10));
      }
    });
}

TEST_P(PoseIndexBy, FindsWhatBruteForceFinds) {
  const auto all = random_features(3000, 1);
  const auto pairs = numbers_to(3000);
  const PoseIndex index(all, pairs, GetParam());
  std::vector<PoseMatch> matches;
  for (const Features& query : random_features(1000, 2)) {
    index.nearest(query, 10, matches);
    // The same sum, so the same bits.
    ASSERT_EQ(distances_of(matches), brute_force(all, pairs, query, 10));
  }
}

TEST_P(PoseIndexBy, DistancesBelongToTheirPairs) {
  const auto all = random_features(500, 3);
  const PoseIndex index(all, numbers_to(500), GetParam());
  const Features query = random_features(1, 4).front();
  std::vector<PoseMatch> matches;
  index.nearest(query, 50, matches);
  for (const PoseMatch& match : matches)
    EXPECT_EQ(match.distance, (all[static_cast<std::size_t>(match.pair)] - query).norm());
}

TEST_P(PoseIndexBy, FindsOnlyThePairsItWasGiven) {
  const auto all = random_features(100, 5);
  const std::vector<int> odd = {1, 3, 5, 99};
  const PoseIndex index(all, odd, GetParam());
  std::vector<PoseMatch> matches;
  index.nearest(all[2], 4, matches);
  std::vector<int> found;
  for (const PoseMatch& match : matches) found.push_back(match.pair);
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(odd));
}

TEST_P(PoseIndexBy, WithoutWhatIsLeftOutItFindsWhatBruteForceFindsAmongTheRest) {
  const int count = 3000;
  const auto all = random_features(count, 11);
  const PoseIndex index(all, numbers_to(count), GetParam());
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

TEST_P(PoseIndexBy, LeavingOutTheNearestOfManyGivesTheNextNearest) {
  const auto all = random_features(500, 14);
  const PoseIndex index(all, numbers_to(500), GetParam());
  const Features query = random_features(1, 15).front();
  std::vector<PoseMatch> before, after;
  index.nearest(query, 60, before);
  std::vector<bool> left_out(500);
  for (std::size_t i = 0; i < 50; ++i) left_out[static_cast<std::size_t>(before[i].pair)] = true;
  index.nearest_without(left_out, query, 10, after);
  ASSERT_EQ(after.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(after[i].pair, before[50 + i].pair);
}

TEST_P(PoseIndexBy, FindsNothingWhenAllIsLeftOutAndFewerWhenFewAreLeft) {
  const auto all = random_features(50, 16);
  const PoseIndex index(all, numbers_to(50), GetParam());
  std::vector<PoseMatch> matches(3);
  std::vector<bool> left_out(50, true);
  index.nearest_without(left_out, all[0], 5, matches);
  EXPECT_TRUE(matches.empty());
  left_out[7] = left_out[9] = false;
  index.nearest_without(left_out, all[9], 5, matches);
  ASSERT_EQ(matches.size(), 2U);
  EXPECT_EQ(matches[0].pair, 9);
}

TEST_P(PoseIndexBy, FindsWhatBruteForceFindsAmongManyThatStandVeryClose) {
  // Frames of slow dances: distances far below what single precision tells apart at this offset.
  auto all = random_features(4000, 21);
  for (Features& features : all) features = 1e-9 * features + Features::Constant(3);
  const auto pairs = numbers_to(4000);
  const PoseIndex index(all, pairs, GetParam());
  std::vector<PoseMatch> matches;
  for (int q = 0; q < 50; ++q) {
    const Features query = all[static_cast<std::size_t>(q * 71)] + Features::Constant(1e-10);
    index.nearest(query, 10, matches);
    ASSERT_EQ(distances_of(matches), brute_force(all, pairs, query, 10));
  }
}

TEST_P(PoseIndexBy, FindsWhatBruteForceFindsWhenNumbersAreNoLengthsOfABody) {
  for (const double scale : {1e-200, 1e-30, 1e10, 1e25, 1e100, 1e300}) {
    auto all = random_features(700, 22);
    for (Features& features : all) features *= scale;
    const auto pairs = numbers_to(700);
    const PoseIndex index(all, pairs, GetParam());
    std::vector<PoseMatch> matches;
    for (const double query_scale : {0.0, scale, 1e-5 * scale, 1e12})
      for (const Features& direction : random_features(5, 23)) {
        const Features query = query_scale * direction;
        index.nearest(query, 10, matches);
        ASSERT_EQ(distances_of(matches), brute_force(all, pairs, query, 10)) << scale << ' ' << query_scale;
      }
  }
}

TEST_P(PoseIndexBy, FindsWhatBruteForceFindsWhateverTheirNumber) {
  for (const int count : {1, 2, 15, 16, 17, 31, 32, 33, 47, 48, 49, 100, 255, 256, 257}) {
    const auto all = random_features(count, 24);
    const auto pairs = numbers_to(count);
    const PoseIndex index(all, pairs, GetParam());
    std::vector<PoseMatch> matches;
    for (const Features& query : random_features(20, 25)) {
      index.nearest(query, 7, matches);
      ASSERT_EQ(distances_of(matches), brute_force(all, pairs, query, 7)) << count;
    }
  }
}

TEST_P(PoseIndexBy, TheSameForEveryOrderOfThePairs) {
  auto all = random_features(2000, 26);
  for (std::size_t i = 0; i < 1000; ++i) all[i + 1000] = all[i];  // ties
  auto order = numbers_to(2000);
  const PoseIndex one(all, order, GetParam());
  std::shuffle(order.begin(), order.end(), std::mt19937(27));
  const PoseIndex other(all, order, GetParam());
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

TEST_P(PoseIndexBy, FindsAPoseItself) {
  const auto all = random_features(200, 6);
  const PoseIndex index(all, numbers_to(200), GetParam());
  std::vector<PoseMatch> matches;
  index.nearest(all[77], 1, matches);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches[0].pair, 77);
  EXPECT_EQ(matches[0].distance, 0);
}

TEST_P(PoseIndexBy, GivesAllWhenMoreAreWantedThanThereAre) {
  const auto all = random_features(7, 7);
  const PoseIndex index(all, numbers_to(7), GetParam());
  std::vector<PoseMatch> matches;
  index.nearest(all[0], 50, matches);
  EXPECT_EQ(matches.size(), 7U);
  index.nearest(all[0], 0, matches);
  EXPECT_TRUE(matches.empty());
}

TEST_P(PoseIndexBy, AnEmptyIndexFindsNothing) {
  const auto all = random_features(7, 7);
  const PoseIndex index(all, {}, GetParam());
  std::vector<PoseMatch> matches(3);
  index.nearest(all[0], 5, matches);
  EXPECT_TRUE(matches.empty());
  EXPECT_EQ(index.size(), 0);
}

TEST_P(PoseIndexBy, EqualDistancesComeInTheOrderOfPairNumbers) {
  const std::vector<Features> all(40, random_features(1, 8).front());
  const PoseIndex index(all, numbers_to(40), GetParam());
  std::vector<PoseMatch> matches;
  index.nearest(Features::Zero(), 40, matches);
  ASSERT_EQ(matches.size(), 40U);
  for (int i = 0; i < 40; ++i) EXPECT_EQ(matches[static_cast<std::size_t>(i)].pair, i);
}

TEST_P(PoseIndexBy, KeepsItsOwnCopyOfTheFeatures) {
  auto all = random_features(200, 9);
  const std::vector<Features> copy = all;
  PoseIndex index(all, numbers_to(200), GetParam());
  for (Features& features : all) features.setConstant(1e6);
  const PoseIndex moved = std::move(index);
  std::vector<PoseMatch> matches;
  moved.nearest(copy[5], 1, matches);
  EXPECT_EQ(matches[0].pair, 5);
}

TEST_P(PoseIndexBy, RefusesWhatCannotBeCompared) {
  auto all = random_features(5, 10);
  EXPECT_THROW(PoseIndex(all, std::vector<int>{5}, GetParam()), std::invalid_argument);
  EXPECT_THROW(PoseIndex(all, std::vector<int>{-1}, GetParam()), std::invalid_argument);
  const PoseIndex index(all, numbers_to(5), GetParam());
  Features query = all[0];
  query(3) = std::numeric_limits<double>::quiet_NaN();
  std::vector<PoseMatch> matches;
  EXPECT_THROW(index.nearest(query, 1, matches), std::invalid_argument);
  all[2](0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(PoseIndex(all, numbers_to(5), GetParam()), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::pose_index_test
