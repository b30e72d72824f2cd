#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/library/store/feature_axes.hpp"

namespace abrazo {

/// Narrows a search down to few rows with FLANN's kd-tree (KDTreeSingleIndex), exactly: never too far. For
/// libraries that are in memory. FLANN sees the seven longest axes and what is left of each pose as one more
/// length: |x - q|^2 is at least the sum of squares of their differences. A query far from all poses, or one
/// that most poses are vetoed for, would have it look into most leaves; then all rows are read one after the
/// other instead, which takes about 1.5 ns each. A search allocates nothing.
class FlannTree {
 public:
  /// @param features  finite, such that `axes` can tell them apart
  FlannTree(const FeatureAxes& axes, std::span<const Features> features);
  ~FlannTree();
  FlannTree(FlannTree&&) noexcept;
  FlannTree& operator=(FlannTree&&) noexcept;

  /// Place -> row of `features`: rows of a leaf are neighbours.
  const std::vector<std::int32_t>& rows() const;

  /// Shows every place that may be within reach to the judge.
  void search(const FeatureAxes::Point& query, SearchReach& reach, PlaceJudge& judge) const;

  /// Of squared distances as FLANN sums them up: see the source.
  static constexpr double relative_error = 1e-3;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace abrazo
