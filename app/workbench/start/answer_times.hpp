#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace abrazo::app {

/// Histogram of response times in milliseconds, with the longest. Bins of a millisecond up to a second, so
/// its size is constant.
class AnswerTimes {
 public:
  void add(double waited_ms) {
    longest_ms_ = std::max(longest_ms_, waited_ms);
    const auto whole = static_cast<std::size_t>(std::max(0.0, waited_ms));
    ++counts_[std::min(whole, counts_.size() - 1)];
    ++total_;
  }
  std::uint64_t count() const { return total_; }
  double longest_ms() const { return longest_ms_; }
  /// Percentile, rounded up to a millisecond; never more than the longest.
  /// @param share 0..1
  double within_ms(double share) const {
    const double wanted = share * static_cast<double>(total_);
    std::uint64_t so_far = 0;
    for (std::size_t ms = 0; ms < counts_.size(); ++ms) {
      so_far += counts_[ms];
      if (total_ > 0 && static_cast<double>(so_far) >= wanted && ms + 1 < counts_.size())
        return std::min(static_cast<double>(ms + 1), longest_ms_);
    }
    return longest_ms_;
  }

 private:
  std::array<std::uint32_t, 1001> counts_{};  ///< the last bin: a second and more
  std::uint64_t total_ = 0;
  double longest_ms_ = 0;
};

}  // namespace abrazo::app
