#pragma once

#include <Eigen/Core>

#include "core/annotation/motion_channels.hpp"

namespace abrazo {

/// Features of a stretch of a couple's motion: mean, minimum, maximum, first and last value of every channel,
/// the turns, change of places, rise and fall of the turns, and the duration.
class SegmentFeatures {
 public:
  explicit SegmentFeatures(const MotionChannels& channels);

  static int count(int channels) { return 5 * channels + own_features; }
  int count() const { return count(channels_.count()); }

  /// Of frames [begin, end) into `row`, which holds count() numbers.
  void describe(int begin, int end, float* row) const;

 private:
  static constexpr int own_features = 14;
  const MotionChannels& channels_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> sums_;  ///< cumulative sums
};

/// Net turn of a stretch, and its extremes [turns].
struct TurnCount {
  double net = 0;   ///< last - first
  double rise = 0;  ///< greatest rise from an earlier to a later frame
  double fall = 0;  ///< greatest fall after that rise
  double drop = 0;  ///< greatest fall from an earlier to a later frame
};
/// Over frames [begin, end); turns as CoupleGeometry's.
TurnCount turn_count(const std::vector<double>& turns, int begin, int end);

}  // namespace abrazo
