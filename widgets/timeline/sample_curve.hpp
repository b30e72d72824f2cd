#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "widgets/common/thinning.hpp"

namespace abrazo::widgets {

/// A figure over time that is drawn at any zoom without visiting every sample: blocks of samples keep minimum
/// and maximum. Appended at the new end, dropped at the old end. Plain data, independent of Qt.
class SampleCurve {
 public:
  struct Extent {
    float least = 0;
    float most = 0;
  };

  /// Times ascend. Values that are not finite are ignored.
  void append(double time_s, double value);
  void drop_before(double time_s);
  /// Bounds the memory: keeps the newest samples and reduces older ones to at most `most_older`. Minimum and
  /// maximum of each four remain. Call at intervals.
  void thin_older(std::size_t newest, std::size_t most_older);
  void clear();

  std::size_t size() const { return samples_.size() - begin_; }
  /// Smallest and largest value in each of `columns` equal parts of [from, to); `least > most` = no sample.
  /// The cost depends on the number of columns, not samples.
  std::vector<Extent> columns(double from_s, double to_s, int columns) const;

 private:
  struct Sample {
    double time_s = 0;
    float value = 0;
  };
  std::size_t position(double time_s) const;
  std::size_t halve(std::size_t first, std::size_t count);
  Extent extent(std::size_t first, std::size_t last) const;

  static constexpr std::size_t block_size = 32;
  std::vector<Sample> samples_;
  std::vector<Extent> blocks_;  ///< of block_size samples each
  std::size_t begin_ = 0;       ///< earlier samples are dropped
  Thinning thinning_;
};

inline bool is_empty(const SampleCurve::Extent& column) {
  return column.least > column.most;
}

/// Interpolates empty columns between two others linearly, unless they have a gap.
/// @param has_gap  whether the empty columns [first, end) have
void bridge_columns(std::vector<SampleCurve::Extent>& columns,
                    const std::function<bool(std::size_t first, std::size_t end)>& has_gap);

/// Upper end for a curve of these columns: the largest value without outliers. 0 without any.
double usual_upper(const std::vector<SampleCurve::Extent>& columns);

}  // namespace abrazo::widgets
