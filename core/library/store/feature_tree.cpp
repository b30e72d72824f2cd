#include "core/library/store/feature_tree.hpp"

#include <algorithm>
#include <array>
#include <thread>

namespace abrazo {

namespace {

constexpr std::size_t split_sample_rows = 64;  ///< enough to see along which axis a node is longest
constexpr std::size_t rows_worth_a_thread = 50'000;

std::size_t stride_for(std::size_t rows, std::size_t wanted) {
  return std::max<std::size_t>(1, rows / wanted);
}

}  // namespace

/// Splits rows in halves along the axis where they lie widest apart. Which place a node or a leaf has follows
/// from the numbers of rows alone, so that halves can be built at the same time.
struct FeatureTree::Builder {
  struct Key {
    float value;
    std::int32_t row;
  };

  FeatureTree& tree;
  std::vector<Point> points;  ///< of `features`, on the axes
  std::vector<Key> keys;

  std::size_t leaf_count(std::size_t rows) const { return (rows + leaf_rows - 1) / leaf_rows; }

  int widest_axis(std::size_t begin, std::size_t end) const {
    Point low = points[static_cast<std::size_t>(keys[begin].row)], high = low;
    for (std::size_t i = begin; i < end; i += stride_for(end - begin, split_sample_rows)) {
      const Point& point = points[static_cast<std::size_t>(keys[i].row)];
      low = low.min(point);
      high = high.max(point);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }

  void build(std::size_t node, std::size_t begin, std::size_t end, int threads) {
    const std::size_t leaves = leaf_count(end - begin);
    if (leaves <= 1) return build_leaf(node, begin, end);
    const int axis = widest_axis(begin, end);
    for (std::size_t i = begin; i < end; ++i)
      keys[i].value = points[static_cast<std::size_t>(keys[i].row)](axis);
    const std::size_t left_leaves = leaves / 2, middle = begin + left_leaves * leaf_rows;
    const auto at = [&](std::size_t i) { return keys.begin() + static_cast<std::ptrdiff_t>(i); };
    // Ties are ordered by row: the grouping must not depend on the previous order.
    std::nth_element(at(begin), at(middle), at(end), [](const Key& a, const Key& b) {
      return a.value != b.value ? a.value < b.value : a.row < b.row;
    });
    const std::size_t left = node + 1, right = node + 2 * left_leaves;
    if (threads > 1 && end - begin > rows_worth_a_thread) {
      const std::jthread other([=, this] { build(left, begin, middle, threads / 2); });
      build(right, middle, end, threads - threads / 2);
    } else {
      build(left, begin, middle, 1);
      build(right, middle, end, 1);
    }
    join(node, left, right);
  }

  void join(std::size_t node, std::size_t left, std::size_t right) {
    Node& joined = tree.nodes_[node];
    joined.low = tree.nodes_[left].low.min(tree.nodes_[right].low);
    joined.high = tree.nodes_[left].high.max(tree.nodes_[right].high);
    joined.right = static_cast<std::int32_t>(right);
  }

  void build_leaf(std::size_t node, std::size_t begin, std::size_t end) {
    const std::size_t number = begin / leaf_rows;
    Leaf& leaf = tree.leaves_[number];
    leaf.setZero();
    Node& holder = tree.nodes_[node];
    holder.leaf = static_cast<std::int32_t>(number);
    holder.low = holder.high = points[static_cast<std::size_t>(keys[begin].row)];
    for (std::size_t i = begin; i < end; ++i) {
      const Point& point = points[static_cast<std::size_t>(keys[i].row)];
      leaf.row(static_cast<Eigen::Index>(i - begin)) = point.head<FeatureAxes::dimensions - 1>().transpose();
      holder.low = holder.low.min(point);
      holder.high = holder.high.max(point);
      tree.rows_[i] = keys[i].row;
    }
  }
};

FeatureTree::FeatureTree(const FeatureAxes& axes, std::span<const Features> features) {
  if (features.empty()) return;
  Builder builder{*this, {}, {}};
  builder.points.reserve(features.size());
  builder.keys.resize(features.size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    builder.points.push_back(axes.of(features[i]));
    builder.keys[i] = {0, static_cast<std::int32_t>(i)};
  }
  rows_.resize(features.size());
  leaves_.resize(builder.leaf_count(features.size()));
  nodes_.resize(2 * leaves_.size() - 1);
  builder.build(0, 0, features.size(), static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
}

void FeatureTree::search(const Point& query, SearchReach& reach, PlaceJudge& judge) const {
  if (rows_.empty()) return;
  struct Waiting {
    std::int32_t node;
    float distance;
  };
  std::array<Waiting, most_depth> waiting;
  std::size_t count = 0;
  waiting[count++] = {0, 0.0F};
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (next.distance > reach.limit()) continue;
    const Node& node = nodes_[static_cast<std::size_t>(next.node)];
    if (node.right == 0) {
      look_into(node, query, reach, judge);
      continue;
    }
    Waiting near{next.node + 1, 0}, far{node.right, 0};
    near.distance = distance_to_box(nodes_[static_cast<std::size_t>(near.node)], query);
    far.distance = distance_to_box(nodes_[static_cast<std::size_t>(far.node)], query);
    if (far.distance < near.distance) std::swap(near, far);
    waiting[count++] = far;
    waiting[count++] = near;
  }
}

void FeatureTree::look_into(const Node& node, const Point& point, SearchReach& reach,
                            PlaceJudge& judge) const {
  const Leaf& leaf = leaves_[static_cast<std::size_t>(node.leaf)];
  Eigen::Array<float, leaf_rows, 1> squares = (leaf.col(0) - point(0)).square();
  for (int axis = 1; axis < 5; ++axis) squares += (leaf.col(axis) - point(axis)).square();
  if (squares.minCoeff() > reach.limit()) return;
  for (int axis = 5; axis < leaf.cols(); ++axis) squares += (leaf.col(axis) - point(axis)).square();
  const int first = node.leaf * leaf_rows;
  const int held = std::min<int>(leaf_rows, static_cast<int>(rows_.size()) - first);
  for (int i = 0; i < held; ++i)
    if (!(squares(i) > reach.limit())) judge.look_at(static_cast<std::size_t>(first + i), reach);
}

}  // namespace abrazo
