#pragma once

#include <span>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// Mean over joints of the distance between two poses [m].
double mean_joint_distance(const Pose& a, const Pose& b);

/// How late one motion is against another.
struct Lag {
  double shift_s = 0;      ///< positive: `follower` comes later
  double correlation = 0;  ///< of the velocities at that shift, -1 .. 1; low means that the shift says little
};

/// Time shift at which the joint velocities of two motions correlate best: maximum over whole frames of the
/// cross-correlation of the 75 coordinates' velocities (each less its mean, so that both merely going the
/// same way is no agreement), normalised over the frames that overlap, refined by a parabola through its
/// neighbours. A best shift at either end of the range is left at the whole frame: it may lie beyond. 0 and
/// 0 when one of the motions does not vary.
/// @param longest_s  shifts up to this are tried, both ways, and at most to half of the frames
/// @throws std::invalid_argument when the motions differ in length, the rate is not positive, or `longest_s`
/// is negative
Lag measure_lag(std::span<const Pose> leader, std::span<const Pose> follower, double fps,
                double longest_s = 0.5);

}  // namespace abrazo
