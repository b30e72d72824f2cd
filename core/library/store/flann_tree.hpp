#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/library/store/feature_axes.hpp"

namespace abrazo {

/// Narrows a search down to few rows with FLANN's kd-tree (KDTreeSingleIndex), conservatively: it never loses
/// a neighbour. For libraries in memory. FLANN gets the seven longest axes and the norm of the rest as an
/// eighth coordinate: |x - q|^2 is at least the sum of squares of their differences. A query far from all
/// poses, or with most poses vetoed, would visit most leaves; then all rows are scanned instead, at about 1.5
/// ns per row. A search does not allocate.
class FlannTree {
 public:
  /// @param features finite; `axes` must be able to tell them apart
  FlannTree(const FeatureAxes& axes, std::span<const Features> features);
  ~FlannTree();
  FlannTree(FlannTree&&) noexcept;
  FlannTree& operator=(FlannTree&&) noexcept;

  /// Place -> row of `features`: rows of a leaf are adjacent.
  const std::vector<std::int32_t>& rows() const;

  /// Passes every place that may be within reach to the judge.
  void search(const FeatureAxes::Point& query, SearchReach& reach, PlaceJudge& judge) const;

  /// Relative error of squared distances summed by FLANN: see the source.
  static constexpr double relative_error = 1e-3;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace abrazo
