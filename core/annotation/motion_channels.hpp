#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/annotation/couple_geometry.hpp"

namespace abrazo {

/// Quantities of a couple's motion as curves over its frames, with the performers in order of role: x is
/// assumed active, y passive.
struct MotionChannels {
  double fps = 0;
  /// One row per frame, one column per quantity: distances and heights [m], speeds [m/s], angles [turns].
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values;
  /// Turn counts and the direction of the line between the two, by frame [turns]; see CoupleGeometry.
  std::vector<double> n_x, n_y, orb;

  int frames() const { return static_cast<int>(values.rows()); }
  int count() const { return static_cast<int>(values.cols()); }
};

/// The last columns: above 0 on average if x moves first and y follows (hand, root, head).
inline constexpr int lead_channel_count = 3;

/// @param b_is_active  x is performer b
MotionChannels motion_channels(const CoupleMotion& motion, const CoupleGeometry& geometry, bool b_is_active);

}  // namespace abrazo
