#pragma once

#include <cstddef>
#include <vector>

#include "widgets/common/thinning.hpp"

namespace abrazo::widgets {

/// A figure over time that is drawn at any zoom without looking at every sample: blocks of samples know their
/// smallest and largest. Appended at the new end, given up at the old one. Plain data, no toolkit.
class SampleCurve {
 public:
  struct Extent {
    float least = 0;
    float most = 0;
  };

  /// Times ascend. A value that is not finite is left out.
  void append(double time_s, double value);
  void drop_before(double time_s);
  /// So that hours do not fill the memory: the newest samples stay as they are, those before become at most
  /// `most_older`. Of each four the least and the largest remain. To be called now and then.
  void thin_older(std::size_t newest, std::size_t most_older);
  void clear();

  std::size_t size() const { return samples_.size() - begin_; }
  /// Smallest and largest value in each of `columns` equal parts of [from, to); `least > most` where there is
  /// no sample. Costs the number of columns, not that of the samples.
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
  std::size_t begin_ = 0;       ///< samples before are given up
  Thinning thinning_;
};

inline bool is_empty(const SampleCurve::Extent& column) {
  return column.least > column.most;
}

/// Fills empty columns between two that are not, on a straight line, where at most `longest` are empty.
void bridge_columns(std::vector<SampleCurve::Extent>& columns, int longest);

/// How high a curve must reach for these columns: the largest value, unless single ones tower. 0 without any.
double usual_upper(const std::vector<SampleCurve::Extent>& columns);

}  // namespace abrazo::widgets
