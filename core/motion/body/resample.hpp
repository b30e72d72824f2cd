#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// A pose and when it was, on whichever clock.
struct StampedPose {
  double time_s = 0;
  Pose pose = Pose::Zero();  ///< world [m]
};

/// Poses at an even rate, and how those they were made of lay in time.
struct EvenPoses {
  std::vector<Pose> poses;
  double first_s = 0;           ///< time of the first one
  std::size_t gaps = 0;         ///< between poses more than three usual intervals apart: bridged
  double longest_gap_s = 0;     ///< of those
  double longest_gap_at_s = 0;  ///< where it begins
  std::size_t discarded = 0;    ///< poses that were not later than the one before
  bool unchanged = false;       ///< the stamps were even already: the poses are those given, to the bit
};

/// Poses at first + i / rate, from the first stamp to the last, each blended from the two around it.
/// @throws std::invalid_argument without poses or a rate
EvenPoses resample(std::span<const StampedPose> stamped, double rate_hz);

/// One over the median of the intervals; 0 when there is none.
double median_rate_hz(std::span<const StampedPose> stamped);

/// A rate that is a whole number but for rounding, as that number.
double even_rate(double rate_hz);

/// Between two poses (share 0 to 1) so that bones keep their lengths: the root in a straight line, every bone
/// turned the shorter way.
Pose blended(const Pose& from, const Pose& to, double share);

}  // namespace abrazo
