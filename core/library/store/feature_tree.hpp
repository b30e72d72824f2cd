#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/library/store/feature_axes.hpp"

namespace abrazo {

/// Narrows a search in feature space down to few rows, conservatively: it never loses a neighbour. For
/// libraries that are mapped because they do not fit into memory. A kd-tree with a bounding box per node,
/// about 60 bytes per row. Rows of a leaf are interleaved for SIMD.
class FeatureTree {
 public:
  FeatureTree() = default;
  /// @param features finite; `axes` must be able to tell them apart
  FeatureTree(const FeatureAxes& axes, std::span<const Features> features);

  /// Order of rows in the leaves: place -> row of `features`.
  const std::vector<std::int32_t>& rows() const { return rows_; }

  /// Passes every place that may be within reach to the judge, roughly nearest first. Does not allocate.
  void search(const FeatureAxes::Point& query, SearchReach& reach, PlaceJudge& judge) const;

  /// Relative error of summed squared distances: 15 additions in single precision, times 10.
  static constexpr double relative_error = 1e-5;

 private:
  static constexpr int leaf_rows = 16;
  static constexpr int most_depth = 48;
  using Point = FeatureAxes::Point;
  using Leaf = Eigen::Array<float, leaf_rows, FeatureAxes::dimensions - 1>;  ///< one row of features per row

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
