#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/library/normalization.hpp"

namespace abrazo {

/// Narrows a search in the feature space down to few rows, quickly and never too far: which of them are
/// nearest is for the asker to say, in double precision. A kd-tree over the principal axes of the features in
/// single precision: boxes are tight there, and the first axes alone rule out most rows. Rows of a leaf stand
/// side by side, so that one instruction takes a step for several.
class FeatureTree {
 public:
  FeatureTree() = default;
  /// @param features  finite
  explicit FeatureTree(std::span<const Features> features);

  /// Rows as leaves hold them: place -> row of `features`.
  const std::vector<std::int32_t>& rows() const { return rows_; }

  /// Where a search stands: what is farther than `limit()` need not be shown. Shrinks while it goes on.
  class Reach {
   public:
    /// @param slack  what rounding may have added to a distance [m]
    explicit Reach(double slack) : slack_(slack) {}
    float limit() const { return limit_; }
    void shrink_to(double distance);

   private:
    double slack_;
    float limit_ = std::numeric_limits<float>::infinity();
  };

  /// Shows every place whose distance may be within reach, near ones first on the whole. Allocates nothing.
  /// @param show  called as show(place, reach); may shrink the reach
  template <typename Show>
  void search(const Features& query, Show show) const;

 private:
  static constexpr int dimensions = 16;  ///< 15 and a zero, a whole number of registers
  static constexpr int leaf_rows = 16;
  static constexpr int most_depth = 48;
  using Point = Eigen::Array<float, dimensions, 1>;
  using Leaf = Eigen::Array<float, leaf_rows, dimensions - 1>;  ///< a row of features per row

  struct Node {
    Point low, high;
    std::int32_t right = 0;  ///< its left child is the next node; 0 = a leaf
    std::int32_t leaf = 0;
  };

  struct Builder;

  Point on_axes(const Features& features) const;
  double slack_for(const Features& query) const;
  static float distance_to_box(const Node& node, const Point& point) {
    const Point outside = (node.low - point).max(point - node.high).max(0.0F);
    return (outside * outside).sum();
  }

  Eigen::Matrix<double, 15, 15> axes_ = Eigen::Matrix<double, 15, 15>::Identity();  ///< one per row
  Features centre_ = Features::Zero();
  double extent_m_ = 0;  ///< largest coordinate on the axes
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::vector<std::int32_t> rows_;
};

template <typename Show>
void FeatureTree::search(const Features& query, Show show) const {
  if (rows_.empty()) return;
  struct Waiting {
    std::int32_t node;
    float distance;
  };
  std::array<Waiting, most_depth> waiting;
  int count = 0;
  const Point point = on_axes(query);
  Reach reach(slack_for(query));
  waiting[0] = {0, 0.0F};
  count = 1;
  while (count > 0) {
    const Waiting next = waiting[static_cast<std::size_t>(--count)];
    if (next.distance > reach.limit()) continue;
    std::int32_t at = next.node;
    while (nodes_[static_cast<std::size_t>(at)].right != 0) {
      const std::int32_t left = at + 1, right = nodes_[static_cast<std::size_t>(at)].right;
      const float to_left = distance_to_box(nodes_[static_cast<std::size_t>(left)], point);
      const float to_right = distance_to_box(nodes_[static_cast<std::size_t>(right)], point);
      const bool left_first = to_left <= to_right;
      const float far = left_first ? to_right : to_left;
      if (!(far > reach.limit()))
        waiting[static_cast<std::size_t>(count++)] = {left_first ? right : left, far};
      if ((left_first ? to_left : to_right) > reach.limit()) {
        at = -1;
        break;
      }
      at = left_first ? left : right;
    }
    if (at < 0) continue;
    const std::int32_t number = nodes_[static_cast<std::size_t>(at)].leaf;
    const Leaf& leaf = leaves_[static_cast<std::size_t>(number)];
    Eigen::Array<float, leaf_rows, 1> squares = (leaf.col(0) - point(0)).square();
    for (int axis = 1; axis < 5; ++axis) squares += (leaf.col(axis) - point(axis)).square();
    if (squares.minCoeff() > reach.limit()) continue;
    for (int axis = 5; axis < dimensions - 1; ++axis) squares += (leaf.col(axis) - point(axis)).square();
    const int first = number * leaf_rows;
    const int held = std::min<int>(leaf_rows, static_cast<int>(rows_.size()) - first);
    for (int i = 0; i < held; ++i)
      if (!(squares(i) > reach.limit())) show(static_cast<std::size_t>(first + i), reach);
  }
}

}  // namespace abrazo
