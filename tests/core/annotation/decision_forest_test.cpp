#include "core/annotation/decision_forest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "core/annotation/confidence_scale.hpp"

namespace abrazo::decision_forest_test {
namespace {

/// Class 1 where the first two features have the same sign, which no single feature tells; five more say
/// nothing. Origins are the rows of class 1.
ForestExamples checkerboard(int rows, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  ForestExamples examples;
  examples.features.resize(rows, 7);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < 7; ++column) examples.features(row, column) = uniform(random);
    const bool same = (examples.features(row, 0) > 0) == (examples.features(row, 1) > 0);
    examples.classes.push_back(same ? 1 : 0);
    examples.weights.push_back(1);
    examples.groups.push_back(row % 4);
    examples.origins.push_back(same ? row : -1);
  }
  examples.class_count = 2;
  examples.group_count = 4;
  return examples;
}

std::vector<float> shares(const DecisionForest& forest, const std::vector<float>& row,
                          std::optional<int> unseen = {}) {
  std::vector<float> of_class(2);
  forest.shares(row.data(), unseen, of_class.data());
  return of_class;
}

const std::vector<float> same_signs = {0.6F, 0.5F, 0, 0, 0, 0, 0};
const std::vector<float> other_signs = {0.6F, -0.5F, 0, 0, 0, 0, 0};

TEST(DecisionForest, LearnsWhatNoSingleFeatureTells) {
  const auto forest = DecisionForest::learn(checkerboard(800, 1), {}, {});
  ASSERT_TRUE(forest);
  EXPECT_GT(shares(*forest, same_signs)[1], 0.8F);
  EXPECT_LT(shares(*forest, other_signs)[1], 0.2F);
}

TEST(DecisionForest, GivesSharesThatSumToOne) {
  const auto forest = DecisionForest::learn(checkerboard(200, 2), {.trees = 20}, {});
  ASSERT_TRUE(forest);
  for (const std::optional<int> unseen : {std::optional<int>(), std::optional<int>(2)}) {
    const auto of_class = shares(*forest, same_signs, unseen);
    EXPECT_NEAR(std::accumulate(of_class.begin(), of_class.end(), 0.0F), 1, 1e-5);
  }
}

TEST(DecisionForest, IsTheSameForTheSameExamples) {
  const auto one = DecisionForest::learn(checkerboard(200, 3), {.trees = 10}, {});
  const auto two = DecisionForest::learn(checkerboard(200, 3), {.trees = 10}, {});
  EXPECT_EQ(shares(*one, same_signs), shares(*two, same_signs));
}

TEST(DecisionForest, JudgesAGroupByTreesThatDidNotSeeIt) {
  ForestExamples examples = checkerboard(400, 4);
  for (std::size_t row = 0; row < examples.classes.size(); ++row)  // group 3 alone says the opposite
    if (examples.groups[row] == 3) examples.classes[row] = 1 - examples.classes[row];
  const auto forest = DecisionForest::learn(examples, {}, {});
  ASSERT_TRUE(forest);
  EXPECT_GT(shares(*forest, same_signs, 3)[1], shares(*forest, same_signs)[1]);
}

TEST(DecisionForest, FindsNeighboursOfTheSameKind) {
  const ForestExamples examples = checkerboard(800, 5);
  const auto forest = DecisionForest::learn(examples, {}, {});
  const auto neighbours = forest->neighbours(same_signs.data(), 9);
  ASSERT_EQ(neighbours.size(), 9U);
  int near = 0;
  for (const auto& neighbour : neighbours)
    near += examples.features(neighbour.origin, 0) > 0 && examples.features(neighbour.origin, 1) > 0 ? 1 : 0;
  EXPECT_GE(near, 8);
  EXPECT_GE(neighbours.front().weight, neighbours.back().weight);
}

TEST(DecisionForest, StopsWhenAsked) {
  const auto forest =
      DecisionForest::learn(checkerboard(200, 6), {}, [](double, std::string_view) { return false; });
  ASSERT_FALSE(forest);
  EXPECT_EQ(forest.error().text(), "cancelled");
}

TEST(DecisionForest, RefusesExamplesThatDoNotFitTogether) {
  ForestExamples examples = checkerboard(20, 7);
  examples.weights.pop_back();
  EXPECT_THROW((void)DecisionForest::learn(examples, {}, {}), std::invalid_argument);
}

/// Trials of which as many were right as `share` says of their probability.
std::vector<ConfidenceScale::Trial> trials(double (*share)(double)) {
  std::vector<ConfidenceScale::Trial> all;
  for (const double probability : {0.2, 0.5, 0.9})
    for (int i = 0; i < 400; ++i) all.push_back({{probability, 0}, i < 400 * share(probability)});
  return all;
}

TEST(ConfidenceScale, SaysHowManyWereRight) {
  const auto right = [](double p) { return 0.5 * p + 0.3; };
  const ConfidenceScale scale = ConfidenceScale::fit(trials(right));
  for (const double p : {0.2, 0.5, 0.9}) EXPECT_NEAR(scale({p, 0}), right(p), 0.03);
}

TEST(ConfidenceScale, WithoutTrialsIsTheModelsOwn) {
  EXPECT_NEAR(ConfidenceScale::fit({})({0.7, 3}), 0.7, 1e-9);
}

TEST(ConfidenceScale, IsNeverCertain) {
  const ConfidenceScale scale = ConfidenceScale::fit(trials([](double) { return 1.0; }));
  for (const double p : {0.0, 0.5, 1.0})
    for (const double strength : {-1e9, 0.0, 1e9}) {
      EXPECT_GE(scale({p, strength}), 0.01);
      EXPECT_LE(scale({p, strength}), 0.99);
    }
}

}  // namespace
}  // namespace abrazo::decision_forest_test
