#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// A pose with its time, on any clock.
struct StampedPose {
  double time_s = 0;
  Pose pose = Pose::Zero();  ///< world [m]
};

/// Poses at a constant rate, and the timing of the original ones.
struct EvenPoses {
  std::vector<Pose> poses;
  double first_s = 0;           ///< time of the first one
  std::size_t gaps = 0;         ///< intervals longer than three usual ones: bridged
  double longest_gap_s = 0;     ///< of those
  double longest_gap_at_s = 0;  ///< where it begins
  std::size_t discarded = 0;    ///< poses not later than their predecessor
  bool unchanged = false;       ///< the stamps were already even: the poses are exactly the input
};

/// Poses at first + i / rate, from the first stamp to the last, each interpolated between its two neighbours.
/// @throws std::invalid_argument without poses or a rate
EvenPoses resample(std::span<const StampedPose> stamped, double rate_hz);

/// Inverse of the median interval; 0 if there is none.
double median_rate_hz(std::span<const StampedPose> stamped);

/// The rate, rounded to a whole number if the difference is only rounding.
double even_rate(double rate_hz);

/// Interpolates two poses (share 0 to 1) with constant bone lengths: the root linearly, every bone by the
/// shorter rotation.
Pose blended(const Pose& from, const Pose& to, double share);

}  // namespace abrazo
