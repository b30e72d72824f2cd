#pragma once

#include <span>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// Mean over joints of the distance between two poses [m].
double mean_joint_distance(const Pose& a, const Pose& b);

/// Delay of one motion relative to another.
struct Lag {
  double shift_s = 0;      ///< positive: `follower` comes later
  double correlation = 0;  ///< of the velocities at that shift, -1 .. 1; if low, the shift is unreliable
};

/// Time shift at which the joint velocities of two motions correlate best: maximum over whole frames of the
/// cross-correlation of the 75 coordinates' velocities (each minus its mean, so that a common drift does not
/// count as agreement), normalised over the overlapping frames, refined by a parabola through the neighbours.
/// A maximum at an end of the range is not refined: the true one may lie beyond. 0 and 0 if one of the
/// motions does not vary.
/// @param longest_s largest shift tried in either direction; at most half of the frames
/// @throws std::invalid_argument when the motions differ in length, the rate is not positive, or `longest_s`
/// is negative
Lag measure_lag(std::span<const Pose> leader, std::span<const Pose> follower, double fps,
                double longest_s = 0.5);

}  // namespace abrazo
