#include "core/annotation/decision_forest.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>

namespace abrazo {

namespace {

double square_sum(const std::vector<double>& weights) {
  return std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

void check(const ForestExamples& examples) {
  const std::size_t rows = examples.classes.size();
  if (rows == 0 || static_cast<std::size_t>(examples.features.rows()) != rows ||
      examples.weights.size() != rows || examples.groups.size() != rows || examples.origins.size() != rows ||
      examples.class_count < 1 || examples.group_count < 1)
    throw std::invalid_argument("a forest needs examples with a class, a weight, a group and an origin each");
}

}  // namespace

/// Grows one tree at a time into the forest's tables.
class DecisionForest::Grower {
 public:
  Grower(DecisionForest& forest, const ForestExamples& examples, const ForestOptions& options)
      : forest_(forest), examples_(examples), options_(options), draws_(options.seed) {
    const int features = static_cast<int>(examples.features.cols());
    tried_ = options.tried_features > 0 ? options.tried_features
                                        : static_cast<int>(std::ceil(2 * std::sqrt(features)));
  }

  void grow() {
    Tree tree;
    tree.left_out = drawn_groups();
    std::vector<int> rows;
    for (std::size_t row = 0; row < examples_.classes.size(); ++row)
      if (!tree.left_out[static_cast<std::size_t>(examples_.groups[row])])
        rows.push_back(static_cast<int>(row));
    struct Open {
      std::int32_t node;
      std::vector<int> rows;
    };
    tree.nodes.emplace_back();
    std::vector<Open> open;
    open.push_back({0, std::move(rows)});
    while (!open.empty()) {
      Open next = std::move(open.back());
      open.pop_back();
      const auto split = best_split(next.rows);
      if (!split) {
        tree.nodes[static_cast<std::size_t>(next.node)].leaf = add_leaf(next.rows);
        continue;
      }
      const auto middle = std::stable_partition(next.rows.begin(), next.rows.end(), [&](int row) {
        return examples_.features(row, split->feature) < split->threshold;
      });
      Node& node = tree.nodes[static_cast<std::size_t>(next.node)];
      node.feature = split->feature;
      node.threshold = split->threshold;
      node.low = static_cast<std::int32_t>(tree.nodes.size());
      node.high = node.low + 1;
      const std::int32_t low = node.low, high = node.high;
      tree.nodes.resize(tree.nodes.size() + 2);
      open.push_back({high, {middle, next.rows.end()}});
      open.push_back({low, {next.rows.begin(), middle}});
    }
    forest_.trees_.push_back(std::move(tree));
  }

 private:
  /// Draws that are the same on every platform (the standard's distributions are not).
  class Draws {
   public:
    explicit Draws(std::uint64_t seed) : engine_(seed) {}
    double fraction() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
    int below(int count) { return std::min(count - 1, static_cast<int>(fraction() * count)); }

   private:
    std::mt19937_64 engine_;
  };

  struct Split {
    int feature = 0;
    float threshold = 0;
  };

  /// A third of the groups, at least one; none if there are fewer than three.
  std::vector<bool> drawn_groups() {
    const int groups = examples_.group_count;
    std::vector<bool> out(static_cast<std::size_t>(groups), false);
    if (groups < 3) return out;
    for (int left = std::max(1, static_cast<int>(std::lround(groups / 3.0))); left > 0;) {
      const auto group = static_cast<std::size_t>(draws_.below(groups));
      if (out[group]) continue;
      out[group] = true;
      --left;
    }
    return out;
  }

  std::optional<Split> best_split(const std::vector<int>& rows) {
    if (static_cast<int>(rows.size()) < 2 * options_.smallest_leaf || is_pure(rows)) return std::nullopt;
    std::optional<Split> best;
    double best_gain = -1;
    for (int tried = 0; tried < tried_; ++tried) {
      Split split{draws_.below(static_cast<int>(examples_.features.cols())), 0};
      const auto [low, high] = range(rows, split.feature);
      const double drawn = draws_.fraction();
      if (!(low < high)) continue;
      split.threshold = low + static_cast<float>(drawn) * (high - low);
      if (!(split.threshold > low)) split.threshold = high;
      const double gain = purity(rows, split);
      if (gain > best_gain) {
        best_gain = gain;
        best = split;
      }
    }
    return best;
  }

  bool is_pure(const std::vector<int>& rows) const {
    const int first = examples_.classes[static_cast<std::size_t>(rows.front())];
    return std::all_of(rows.begin(), rows.end(),
                       [&](int row) { return examples_.classes[static_cast<std::size_t>(row)] == first; });
  }

  std::pair<float, float> range(const std::vector<int>& rows, int feature) const {
    float low = examples_.features(rows.front(), feature), high = low;
    for (const int row : rows) {
      low = std::min(low, examples_.features(row, feature));
      high = std::max(high, examples_.features(row, feature));
    }
    return {low, high};
  }

  /// Sum over both sides of (sum of squared class weights) / weight: the greater, the purer. -1 when a side
  /// is too small.
  double purity(const std::vector<int>& rows, const Split& split) {
    const auto classes = static_cast<std::size_t>(examples_.class_count);
    low_.assign(classes, 0);
    high_.assign(classes, 0);
    int low_rows = 0;
    for (const int row : rows) {
      const auto i = static_cast<std::size_t>(row);
      const bool is_low = examples_.features(row, split.feature) < split.threshold;
      low_rows += is_low ? 1 : 0;
      (is_low ? low_ : high_)[static_cast<std::size_t>(examples_.classes[i])] += examples_.weights[i];
    }
    const int high_rows = static_cast<int>(rows.size()) - low_rows;
    if (std::min(low_rows, high_rows) < options_.smallest_leaf) return -1;
    const double low = std::accumulate(low_.begin(), low_.end(), 0.0),
                 high = std::accumulate(high_.begin(), high_.end(), 0.0);
    return square_sum(low_) / low + square_sum(high_) / high;
  }

  std::int32_t add_leaf(const std::vector<int>& rows) {
    std::vector<double> weights(static_cast<std::size_t>(examples_.class_count), 0);
    std::vector<std::int32_t> origins;
    for (const int row : rows) {
      const auto i = static_cast<std::size_t>(row);
      weights[static_cast<std::size_t>(examples_.classes[i])] += examples_.weights[i];
      if (examples_.origins[i] >= 0) origins.push_back(examples_.origins[i]);
    }
    std::sort(origins.begin(), origins.end());
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (const double weight : weights) forest_.leaf_shares_.push_back(static_cast<float>(weight / all));
    forest_.origins_.push_back(std::move(origins));
    return static_cast<std::int32_t>(forest_.origins_.size()) - 1;
  }

  DecisionForest& forest_;
  const ForestExamples& examples_;
  const ForestOptions& options_;
  Draws draws_;
  int tried_ = 1;
  std::vector<double> low_, high_;
};

Result<DecisionForest> DecisionForest::learn(const ForestExamples& examples, const ForestOptions& options,
                                             const Progress& progress) {
  check(examples);
  DecisionForest forest;
  forest.class_count_ = examples.class_count;
  forest.group_count_ = examples.group_count;
  Grower grower(forest, examples, options);
  for (int tree = 0; tree < options.trees; ++tree) {
    if (!report(progress, static_cast<double>(tree) / options.trees, "learning from the labelled takes"))
      return Error{"cancelled", ""};
    grower.grow();
  }
  return forest;
}

const DecisionForest::Node& DecisionForest::leaf(const Tree& tree, const float* row) const {
  const Node* node = &tree.nodes.front();
  while (node->feature >= 0)
    node =
        &tree.nodes[static_cast<std::size_t>(row[node->feature] < node->threshold ? node->low : node->high)];
  return *node;
}

void DecisionForest::shares(const float* row, std::optional<int> unseen, float* of_class) const {
  std::fill(of_class, of_class + class_count_, 0.0F);
  int asked = 0;
  const auto ask = [&](const Tree& tree) {
    const float* share = &leaf_shares_[static_cast<std::size_t>(leaf(tree, row).leaf * class_count_)];
    for (int c = 0; c < class_count_; ++c) of_class[c] += share[c];
    ++asked;
  };
  for (const Tree& tree : trees_)
    if (!unseen || tree.left_out[static_cast<std::size_t>(*unseen)]) ask(tree);
  if (asked == 0)
    for (const Tree& tree : trees_) ask(tree);
  for (int c = 0; c < class_count_; ++c) of_class[c] /= static_cast<float>(asked);
}

std::vector<DecisionForest::Neighbour> DecisionForest::neighbours(const float* row, int k) const {
  std::map<int, double> weights;
  for (const Tree& tree : trees_) {
    const auto& origins = origins_[static_cast<std::size_t>(leaf(tree, row).leaf)];
    for (const std::int32_t origin : origins)
      weights[origin] += 1.0 / static_cast<double>(origins.size() * trees_.size());
  }
  std::vector<Neighbour> all;
  all.reserve(weights.size());
  for (const auto& [origin, weight] : weights) all.push_back({origin, weight});
  std::stable_sort(all.begin(), all.end(),
                   [](const Neighbour& l, const Neighbour& r) { return l.weight > r.weight; });
  all.resize(std::min(all.size(), static_cast<std::size_t>(k)));
  return all;
}

}  // namespace abrazo
