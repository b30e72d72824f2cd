#pragma once

#include <Eigen/Core>

#include "core/annotation/motion_channels.hpp"

namespace abrazo {

/// What a stretch of a couple's motion is described by: of every channel the mean, least, greatest, first and
/// last value, and the turns made, the places changed, rise and fall of the turns, and the duration.
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
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> sums_;  ///< of the frames before
};

/// Net turn of a stretch, and how far it went to and fro [turns].
struct TurnCount {
  double net = 0;   ///< last - first
  double rise = 0;  ///< greatest rise from an earlier to a later frame
  double fall = 0;  ///< greatest fall after that rise
  double drop = 0;  ///< greatest fall from an earlier to a later frame
};
/// Over frames [begin, end); turns as CoupleGeometry's.
TurnCount turn_count(const std::vector<double>& turns, int begin, int end);

}  // namespace abrazo
