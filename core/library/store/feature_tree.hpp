#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/library/store/feature_axes.hpp"

namespace abrazo {

/// Narrows a search in the feature space down to few rows, quickly and never too far: for libraries that are
/// mapped because they do not fit into memory. A kd-tree with a box of what is in each node, 60 bytes for
/// each row and little besides. Rows of a leaf stand side by side, so that one instruction takes a step for
/// several.
class FeatureTree {
 public:
  FeatureTree() = default;
  /// @param features  finite, such that `axes` can tell them apart
  FeatureTree(const FeatureAxes& axes, std::span<const Features> features);

  /// Rows as leaves hold them: place -> row of `features`.
  const std::vector<std::int32_t>& rows() const { return rows_; }

  /// Shows every place that may be within reach to the judge, near ones first on the whole. Allocates
  /// nothing.
  void search(const FeatureAxes::Point& query, SearchReach& reach, PlaceJudge& judge) const;

  /// Of squared distances as they are summed up: 15 additions in single precision, tenfold.
  static constexpr double relative_error = 1e-5;

 private:
  static constexpr int leaf_rows = 16;
  static constexpr int most_depth = 48;
  using Point = FeatureAxes::Point;
  using Leaf = Eigen::Array<float, leaf_rows, FeatureAxes::dimensions - 1>;  ///< a row of features per row

  struct Node {
    Point low, high;
    std::int32_t right = 0;  ///< its left child is the next node; 0 = a leaf
    std::int32_t leaf = 0;
  };

  struct Builder;

  static float distance_to_box(const Node& node, const Point& point) {
    const Point outside = (node.low - point).max(point - node.high).max(0.0F);
    return (outside * outside).sum();
  }
  void look_into(const Node& node, const Point& point, SearchReach& reach, PlaceJudge& judge) const;

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::vector<std::int32_t> rows_;
};

}  // namespace abrazo
