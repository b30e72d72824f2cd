#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"

namespace abrazo {

/// Training examples of a forest, one row each (stored by columns, in reading order).
struct ForestExamples {
  Eigen::MatrixXf features;
  std::vector<int> classes;     ///< 0 .. class_count - 1
  std::vector<double> weights;  ///< above 0
  std::vector<int> groups;      ///< examples that are left out together: the take
  std::vector<int> origins;     ///< the labelled move of the example; -1 = none
  int class_count = 0;
  int group_count = 0;
};

struct ForestOptions {
  int trees = 120;
  int tried_features = 0;  ///< per split; 0 = twice the square root of the number of features
  int smallest_leaf = 4;   ///< examples
  std::uint64_t seed = 1;
};

/// Extremely randomised trees (Geurts, Ernst, Wehenkel 2006): many trees, each split the best of some drawn
/// at random by Gini impurity. Each tree leaves out a third of the groups (as long as there are three), so
/// that a group can be evaluated by trees that never saw it. The same examples and options give the same
/// forest.
class DecisionForest {
 public:
  /// @return an Error "cancelled" if `progress` cancels
  /// @throws std::invalid_argument if the columns are inconsistent or empty
  static Result<DecisionForest> learn(const ForestExamples& examples, const ForestOptions& options,
                                      const Progress& progress);

  int class_count() const { return class_count_; }
  int group_count() const { return static_cast<int>(group_count_); }

  /// Shares of the classes in the leaves that a row falls into, which sum to 1.
  /// @param unseen uses only trees that left this group out; all if there are none
  void shares(const float* row, std::optional<int> unseen, float* of_class) const;

  /// The labelled moves that share most leaves with the rows, the nearest first: an adaptive nearest
  /// neighbour search (Lin and Jeon 2006).
  struct Neighbour {
    int origin = 0;
    double weight = 0;  ///< weights sum to at most 1
  };
  std::vector<Neighbour> neighbours(const float* row, int k) const;

 private:
  struct Node {
    std::int32_t feature = -1;  ///< -1 = leaf
    float threshold = 0;        ///< below goes to `low`
    std::int32_t low = 0, high = 0;
    std::int32_t leaf = -1;  ///< row of the leaf tables
  };
  struct Tree {
    std::vector<Node> nodes;
    std::vector<bool> left_out;  ///< by group
  };
  class Grower;

  const Node& leaf(const Tree& tree, const float* row) const;

  int class_count_ = 0, group_count_ = 0;
  std::vector<Tree> trees_;
  std::vector<float> leaf_shares_;                  ///< leaves x classes
  std::vector<std::vector<std::int32_t>> origins_;  ///< by leaf, each once
};

}  // namespace abrazo
