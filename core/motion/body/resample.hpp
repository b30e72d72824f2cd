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

/// How poses with given times become poses at a constant rate: known without the poses.
struct EvenTiming {
  double rate_hz = 0;
  std::size_t frames = 0;       ///< at this rate, from the first time to the last
  double first_s = 0;           ///< time of the first one
  std::size_t gaps = 0;         ///< intervals longer than three usual ones
  std::size_t bridged = 0;      ///< of the frames, those interpolated inside a gap
  double longest_gap_s = 0;     ///< of the gaps
  double longest_gap_at_s = 0;  ///< where it begins
  std::size_t discarded = 0;    ///< poses not later than their predecessor
  bool unchanged = false;       ///< the times were already even: the poses are exactly the input
};

/// Frames at first + i / rate, from the first time to the last.
/// @throws std::invalid_argument without times or a rate
EvenTiming even_timing(std::span<const double> times_s, double rate_hz);

struct EvenPoses {
  std::vector<Pose> poses;
  EvenTiming timing;
};

/// The poses of this timing, each interpolated between its two neighbours.
/// @throws std::invalid_argument without poses or a rate
EvenPoses resample(std::span<const StampedPose> stamped, double rate_hz);

std::vector<double> times_of(std::span<const StampedPose> stamped);

/// Inverse of the median interval; 0 if there is none.
double median_rate_hz(std::span<const double> times_s);

/// The rate, rounded to a whole number if the difference is only rounding.
double even_rate(double rate_hz);

/// Interpolates two poses (share 0 to 1) with constant bone lengths: the root linearly, every bone by the
/// shorter rotation.
Pose blended(const Pose& from, const Pose& to, double share);

}  // namespace abrazo
